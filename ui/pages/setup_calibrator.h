// The row of the Sensors tab that a calibrator is used with: its level and frequency, and what its tone says of the
// chosen channel. A good answer goes into the draft. GUI thread.
#pragma once

#include <functional>

#include "ui/pages/setup_tab.h"

namespace stillcut::ui {

class SetupCalibrator : public SetupTab {
  Q_OBJECT
 public:
  // `chosen`: row of the channel, below 0 where none is.
  SetupCalibrator(SetupDesk& desk, SetupDraft& draft, std::function<int()> chosen, QWidget* parent = nullptr);
  void refresh() override;
  void applyTheme(const Theme& theme) override;

 protected:
  void paintEvent(QPaintEvent*) override {}  // a row of another tab's surface

 private:
  void begin();
  void take(const CalibrationTrial& trial);

  std::function<int()> chosen_;
  QLineEdit *level_, *frequency_;
  TouchButton* begin_;
  TextLabel* said_;
  CalibrationTrial::State seen_ = CalibrationTrial::State::Off;
};

}  // namespace stillcut::ui
