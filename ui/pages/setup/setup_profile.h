// The tab that holds a machine together: which methods are in charge, the trial step by step, saving, starting.
#pragma once

#include "ui/pages/setup/setup_tab.h"

class QBoxLayout;
class QListWidget;

namespace stillcut::ui {

class StepList;

class SetupProfile : public SetupTab {
  Q_OBJECT
 public:
  SetupProfile(SetupController& controller, SetupDraft& draft, QWidget* parent = nullptr);
  void refresh() override;
  void applyTheme(const Theme& theme) override;
  // Saves the profile and begins with it; false: the tab says why not.
  bool start();
  // The same; one without a name gets one.
  bool startUnderAnyName();

 private:
  void addChoices(QBoxLayout* column, const QString& title, const std::vector<ComponentOption>& options,
                  std::vector<TouchButton*>& buttons, const QString& prefix, std::string config::Profile::*field);
  bool lacksDevice();
  void tell(const Status& status, const QString& done);
  void showTrial();
  void showKnown();

  QLineEdit* name_;
  QListWidget* known_;
  std::vector<TouchButton*> detectors_, strategies_;
  StepList* trial_;
  TextLabel *note_, *force_;
  TouchButton *try_, *save_, *start_, *load_;
};

}  // namespace stillcut::ui
