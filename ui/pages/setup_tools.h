// The tab of the shop's tools: teeth, diameter, pitch, modes, limits, notes, and where each chattered before.
#pragma once

#include "ui/pages/setup_tab.h"

class QListView;
class QPlainTextEdit;

namespace stillcut::ui {

class SetupTools : public SetupTab {
  Q_OBJECT
 public:
  SetupTools(SetupDesk& desk, SetupDraft& draft, QWidget* parent = nullptr);
  void refresh() override;
  void display(const Picture& picture) override;
  void applyTheme(const Theme& theme) override;

 private:
  ToolEntry typed() const;
  void showTool(int row);
  void keep(const QString& done);
  void noteChatter();

  ToolModel tools_;
  QListView* list_;
  QLineEdit *name_, *holder_, *teeth_, *diameter_, *pitch_, *modes_, *limit_;
  QPlainTextEdit* notes_;
  TextLabel *chattered_, *note_;
  TouchButton *save_, *use_, *remove_, *here_;
  ChatterNote now_;  // what the cut does
  bool alarming_ = false;
};

}  // namespace stillcut::ui
