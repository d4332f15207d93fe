// ChatterTruth: what really goes on in a simulated cut, to judge detectors and controllers by.
//
// The chatter part of the tip's acceleration is its second difference over whole spindle revolutions, a(t) - 2 a(t-T) +
// a(t-2T): the forced vibration with its runout repeats every revolution and falls out, slow growth of it too. Divided
// by |1 - exp(-2 pi i f_c T)|^2 it has the chatter's amplitude. Samples come at equal angles, so T is exact at any
// speed. ratio = rms of the chatter part / rms of the rest (x and y together), over the longer of one revolution and 8
// ms. Soft where f_c nears a spindle harmonic (the divisor is kept above 0.3) and while the cut itself changes: after
// entry, exit and steps of the engagement it waits `settle` before it calls anything chatter. Thread: one. add() is
// real-time safe; the questions about the past are not.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "core/base/units.h"
#include "core/model/verdict.h"

namespace stillcut::milling {

struct TruthSample {
  double time = 0.0;                     // [s]
  std::array<double, 2> acceleration{};  // of the tip [m/s^2]
  std::array<double, 2> displacement{};  // of the tip [m]
  double spindleHz = 0.0;
  double path = 0.0;             // [m]
  bool cutting = false;          // in the material
  bool engagementSteady = true;  // no entry or exit going on
};

struct ChatterOnset {
  // Times [s] from which on the ratio stays above 1, 20, 50 % until it reaches full chatter; NaN: never.
  double at1 = std::numeric_limits<double>::quiet_NaN();
  double at20 = std::numeric_limits<double>::quiet_NaN();
  double at50 = std::numeric_limits<double>::quiet_NaN();
};

class ChatterTruth {
 public:
  struct Settings {
    int samplesPerRevolution = 64;
    double nominalHz = 100.0;   // spindle frequency, for the window
    double fastestHz = 120.0;   // highest one to come, for the sizes
    double duration = 10.0;     // [s]
    double settle = 0.1;        // [s]
    double highestHz = 1000.0;  // highest mode
  };
  explicit ChatterTruth(const Settings& settings);

  void add(const TruthSample& sample) noexcept;

  // Now.
  double ratio() const { return ratio_; }            // amplitude, chatter to forced
  bool chattering() const { return sustained_; }     // ratio above 0.2 for six revolutions and 50 ms
  Metres marked() const { return Metres(marked_); }  // path cut with a ratio above 0.5 (an energy ratio of 20 %)
  double vibration() const { return totalRms_; }     // rms of the tip's acceleration [m/s^2]
  Hertz liveFrequency() const { return Hertz(liveHz_); }

  // The first chatter of the run, afterwards.
  ChatterOnset onset() const;
  Hertz chatterFrequency() const;     // of the first chatter, from its first 0.22 s or 8 revolutions; 0: none
  ChatterKind kind(int teeth) const;  // hopf, flip, unknown: no chatter
  double peakRatio() const { return peak_; }

  struct LogEntry {
    float time, chatterRms, forcedAndChatterRms, spindleHz, path, ratio;
    bool settled;
  };
  const std::vector<LogEntry>& log() const { return log_; }  // every millisecond; chatterRms before division
  double ratioAt(const LogEntry& e, Hertz chatter) const;

 private:
  void follow(double difference) noexcept;
  void note(const TruthSample& s, double raw) noexcept;

  Settings settings_;
  int perRev_;
  std::size_t window_;
  double spectrumLength_;                    // [s]
  std::array<std::vector<double>, 4> past_;  // two revolutions of tip acceleration and displacement, x and y
  std::size_t pastAt_ = 0;
  std::vector<double> chatterSq_, totalSq_;
  std::size_t windowAt_ = 0;
  double chatterSum_ = 0.0, totalSum_ = 0.0;
  std::size_t seen_ = 0, sinceCut_ = 0;
  double unsteadyUntil_ = 0.0, lastTime_ = 0.0, lastPath_ = 0.0, lastLog_ = -1.0;
  double ratio_ = 0.0, totalRms_ = 0.0, strongest_ = 0.0, peak_ = 0.0, marked_ = 0.0;
  double aboveSince_ = -1.0, highest_ = 0.0;
  bool sustained_ = false;
  // Frequency now: neighbours' correlation of the displacement's difference, in which the mode stands out most.
  double d1_ = 0.0, d2_ = 0.0, num_ = 0.0, den_ = 0.0, liveHz_ = 0.0;
  // The difference around the first chatter.
  std::vector<double> difference_;
  std::size_t differenceAt_ = 0;
  bool frozen_ = false;
  double freezeAt_ = -1.0, differenceRate_ = 0.0, eventTime_ = -1.0, eventHz_ = 0.0;
  std::vector<LogEntry> log_;
};

}  // namespace stillcut::milling
