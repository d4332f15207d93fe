// The tab of recordings: who cuts what, whether every cut is recorded, how much of it, and how long it is kept. Saved
// in the profile.
#pragma once

#include "core/config/param_set.h"
#include "ui/pages/setup/setup_tab.h"

class QVBoxLayout;

namespace stillcut::ui {

class SetupRecording final : public SetupTab {
  Q_OBJECT
 public:
  SetupRecording(SetupController& controller, SetupDraft& draft, QWidget* parent = nullptr);
  void refresh() override;
  void display(const Picture& picture) override;

 private:
  // One declared number and what it is typed into.
  struct Field {
    const config::ParamDecl* decl;
    QWidget* row;
    QLineEdit* edit;
  };
  void addNames(QVBoxLayout* column);
  void addModes(QVBoxLayout* column);
  void addFields(QVBoxLayout* column);
  void setParam(const config::ParamDecl& decl, const QString& text);

  config::ParamCatalog catalog_;
  const config::ParamDecl* mode_ = nullptr;
  QLineEdit *operator_, *job_, *folder_;
  TouchButton* record_;
  std::vector<TouchButton*> modes_;
  std::vector<Field> fields_;
  TextLabel *about_, *names_, *problem_, *now_;
};

}  // namespace stillcut::ui
