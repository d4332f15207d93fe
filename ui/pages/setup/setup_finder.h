// The part of the Machine tab that looks for ways to a machine when it is asked to, takes the chosen one into the
// draft, and tests the link by itself, step by step. GUI thread.
#pragma once

#include "ui/pages/setup/setup_tab.h"

class QListWidget;

namespace stillcut::ui {

class StepList;

class SetupFinder : public SetupTab {
  Q_OBJECT
 public:
  SetupFinder(SetupController& controller, SetupDraft& draft, QWidget* parent = nullptr);
  void refresh() override;
  void applyTheme(const Theme& theme) override;

 protected:
  void paintEvent(QPaintEvent*) override {}  // a part of another tab's surface

 private:
  void layOut();
  void connectAll();
  void use();
  void save();
  void showFound();
  void showTest();

  QLineEdit* hosts_;
  TouchButton *find_, *use_, *test_, *save_;
  QListWidget* places_;
  TextLabel* note_;
  StepList* steps_;
};

}  // namespace stillcut::ui
