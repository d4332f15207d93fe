// The levels a spectrogram's palette spans: follows the signal by itself, in steps of 5 dB and rarely, so that the
// picture does not flicker while nothing happens. GUI thread.
#pragma once

#include <span>

namespace stillcut::ui {

class LevelRange {
 public:
  // Takes in one column (dB). True when the range has moved and everything must be drawn anew.
  bool add(std::span<const float> levels_dB);
  double low() const { return low_; }
  double high() const { return high_; }
  // 0 at low, 1 at high, clamped.
  double place(double level_dB) const;

 private:
  bool settle();

  bool started_ = false;
  double floor_ = 0.0;  // running noise floor
  double peak_ = 0.0;   // running peak: up at once, down slowly
  double low_ = -80.0;
  double high_ = 0.0;
};

}  // namespace stillcut::ui
