// The tabs of the Set up page that choose what a machine is made of: the link to its control, and the device with its
// channels, live level and spectrum.
#pragma once

#include "ui/pages/setup_tab.h"

class QScrollArea;
class QTableView;

namespace stillcut::ui {

class LevelSpectrum;
class SettingsForm;

class SetupMachine : public SetupTab {
  Q_OBJECT
 public:
  SetupMachine(SetupDesk& desk, SetupDraft& draft, QWidget* parent = nullptr);
  void refresh() override;

 private:
  std::vector<TouchButton*> links_;
  TextLabel* about_;
  SettingsForm* form_;
  QLineEdit *name_, *speed_, *feed_;
  TouchButton* allowAuto_;
};

class SetupSensors : public SetupTab {
  Q_OBJECT
 public:
  SetupSensors(SetupDesk& desk, SetupDraft& draft, QWidget* parent = nullptr);
  void refresh() override;
  void display(const Picture& picture) override;
  void applyTheme(const Theme& theme) override;

 private:
  std::vector<TouchButton*> sources_;
  TextLabel *about_, *state_;
  SettingsForm* form_;
  ChannelModel channels_;
  QTableView* table_;
  LevelSpectrum* live_;
};

}  // namespace stillcut::ui
