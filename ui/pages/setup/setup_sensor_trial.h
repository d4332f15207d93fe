// The rows of the Sensors tab that ask a sensor by hand: a calibrator's tone on the chosen channel, with its level and
// frequency, and knocks along its axis. A good answer goes into the draft. GUI thread.
#pragma once

#include <functional>

#include "ui/pages/setup/setup_tab.h"

namespace stillcut::ui {

class SetupSensorTrial : public SetupTab {
  Q_OBJECT
 public:
  // `chosen`: row of the channel, below 0 where none is.
  SetupSensorTrial(SetupController& controller, SetupDraft& draft, std::function<int()> chosen,
                   QWidget* parent = nullptr);
  void refresh() override;
  void applyTheme(const Theme& theme) override;

 protected:
  void paintEvent(QPaintEvent*) override {}  // rows of another tab's surface

 private:
  void calibrate();
  void knock();
  int channel() const;
  void take(const SensorTrial& trial);

  std::function<int()> chosen_;
  QLineEdit *level_, *frequency_;
  TouchButton *calibrate_, *knock_;
  TextLabel* said_;
  QString meanwhile_;  // said while it is heard
  SensorTrial::State seen_ = SensorTrial::State::Off;
};

}  // namespace stillcut::ui
