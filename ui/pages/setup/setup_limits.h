// The tab of limits: how far the overrides may ever drive spindle and feed on this machine. The gate enforces them;
// they are saved in the profile and hold from START on, for a whole run.
#pragma once

#include "core/config/param_set.h"
#include "ui/pages/setup/setup_tab.h"

class QGridLayout;

namespace stillcut::ui {

class SetupLimits final : public SetupTab {
  Q_OBJECT
 public:
  SetupLimits(SetupController& controller, SetupDraft& draft, QWidget* parent = nullptr);
  void refresh() override;
  void applyTheme(const Theme& theme) override;
  // What was typed last is no limit, and the tab says why.
  bool refused() const { return refused_; }

 private:
  // One declared limit and what it is typed into.
  struct Field {
    const config::ParamDecl* decl;
    QLineEdit* edit;
  };
  void addField(const config::ParamDecl& decl);
  void setLimit(const config::ParamDecl& decl, const QString& text);
  void check();

  config::ParamCatalog catalog_;
  std::vector<Field> fields_;
  QGridLayout* grid_;
  TextLabel *about_, *problem_;
  bool refused_ = false;  // the newest number was not taken, and the problem says why
};

}  // namespace stillcut::ui
