// How a recording is looked at: which channel, which spectra, on which axis of frequency; and what is marked on that
// axis. GUI thread, values.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/units.h"
#include "core/model/recording_spectra.h"

namespace stillcut::ui {

struct FileLook {
  int channel = 0;
  int length = 2048;  // samples of one spectrum
  SpectraWindow window = SpectraWindow::Hann;
  double overlap = 0.5;
  bool log = false;    // axis of frequency
  bool order = false;  // numbers of it in orders of the spindle
  bool operator==(const FileLook&) const = default;
};

// The axis of frequency between two ends. A logarithmic one begins at a thousandth of its upper end at the earliest.
class FrequencyScale {
 public:
  FrequencyScale(Hertz low, Hertz high, bool log)
      : low_(log ? std::max(low.value, high.value * 1e-3) : low.value), high_(high.value), log_(log) {}

  double low() const { return low_; }
  double high() const { return high_; }
  bool log() const { return log_; }
  // 0 at the lower end, 1 at the upper.
  double placeOf(double hertz) const {
    if (!log_) return (hertz - low_) / (high_ - low_);
    return std::log(std::max(hertz, 1e-9) / low_) / std::log(high_ / low_);
  }
  double at(double place) const { return log_ ? low_ * std::pow(high_ / low_, place) : low_ + (high_ - low_) * place; }

 private:
  double low_, high_;
  bool log_;
};

// What is known of the cut on the axis of frequency; 0: nothing.
struct FileMarks {
  Hertz spindle{}, chatter{};
  int teeth = 0;
  Hertz toothPassing() const { return spindle * static_cast<double>(std::max(teeth, 0)); }
};

// Multiples of the tooth passing (of the spindle where the teeth are not known) between two frequencies, at most a
// hundred.
inline std::vector<double> passingMarks(const FileMarks& marks, double low, double high) {
  const double each = marks.teeth > 0 ? marks.toothPassing().value : marks.spindle.value;
  std::vector<double> lines;
  if (!(each > 0.0)) return lines;
  for (double k = std::max(std::ceil(low / each), 1.0); k * each <= high && lines.size() < 100; k += 1.0)
    lines.push_back(k * each);
  return lines;
}

// The other members of the chatter's family, f_c + k f_tp, at most a hundred.
inline std::vector<double> chatterFamily(const FileMarks& marks, double low, double high) {
  const double each = marks.toothPassing().value, chatter = marks.chatter.value;
  std::vector<double> lines;
  if (!(each > 0.0) || !(chatter > 0.0)) return lines;
  for (double k = std::ceil((std::max(low, 1.0) - chatter) / each); chatter + k * each <= high && lines.size() < 100;
       k += 1.0) {
    if (std::abs(k) > 0.5) lines.push_back(chatter + k * each);
  }
  return lines;
}

}  // namespace stillcut::ui
