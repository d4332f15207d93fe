// The tabs of the Set up page that choose what a machine is made of: the link to its control, and the device with its
// channels, live level and spectrum.
#pragma once

#include "ui/models/freshness.h"
#include "ui/pages/setup/setup_tab.h"

class QScrollArea;
class QTableView;
class QVBoxLayout;

namespace stillcut::ui {

class LevelSpectrum;
class SettingsForm;
class SetupFinder;
class SetupSensorTrial;

class SetupMachine : public SetupTab {
  Q_OBJECT
 public:
  SetupMachine(SetupController& controller, SetupDraft& draft, QWidget* parent = nullptr);
  void refresh() override;

 private:
  void takeDepth();

  std::vector<TouchButton*> links_;
  TextLabel* about_;
  SettingsForm* form_;
  QLineEdit *name_, *speed_, *feed_, *depth_;
  TextLabel *feedLabel_, *depthLabel_, *problem_;
  SetupFinder* finder_;
  TouchButton* allowAuto_;
};

class SetupSensors : public SetupTab {
  Q_OBJECT
 public:
  SetupSensors(SetupController& controller, SetupDraft& draft, QWidget* parent = nullptr);
  void refresh() override;
  void display(const Picture& picture) override;
  void applyTheme(const Theme& theme) override;

 protected:
  void showEvent(QShowEvent* event) override;  // what was plugged in meanwhile is looked for
  void hideEvent(QHideEvent* event) override;  // nobody looks: the device is let go

 private:
  Picture shown(const Picture& picture, const DevicePreview& heard);
  void showFound();
  void showKinds();
  void listenNow();
  QWidget* makeKits();
  // The chosen device is one of those that are listed by their names.
  bool chosenIsFound() const;

  std::vector<TouchButton*> sources_;
  TextLabel* heading_;
  QVBoxLayout* foundRows_;
  std::vector<TouchButton*> found_;  // what is plugged in here
  std::vector<FoundDevice> foundShown_;
  TextLabel* none_;     // nothing is plugged in
  QWidget* kits_;       // what to buy then, with the manual's part on it
  TouchButton* other_;  // opens the kinds of devices that are no names
  QWidget* kinds_;
  QScrollArea* settings_;
  qint64 lookedMs_ = -1;
  TextLabel *about_, *whose_, *state_, *findings_, *levels_;
  TouchButton* listen_;
  config::ComponentChoice listened_;  // what was chosen then
  Freshness heardFresh_;
  SettingsForm* form_;
  ChannelModel channels_;
  QTableView* table_;
  SetupSensorTrial* trial_;
  LevelSpectrum* live_;
};

}  // namespace stillcut::ui
