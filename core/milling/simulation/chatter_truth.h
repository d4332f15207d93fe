// ChatterTruth: what really goes on in a simulated cut, to measure detectors and controllers by. It looks at the tip of
// the tool itself; sensors and their noise do not come into it. Definition:
// resources/manual/developers/laws.md#chatter-truth. Thread: one. add() is real-time safe; the questions about the past
// are not.
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
  std::array<double, 2> forced{};        // acceleration of a tip whose vibration leaves no marks [m/s^2]
  double spindleHz = 0.0;
  double path = 0.0;             // [m]
  double growth = 0.0;           // of a small disturbance of the cut [1/s]; above zero: unstable
  double gain = 4.0;             // of that disturbance, over the forced period
  bool flips = false;            // that disturbance repeats after two teeth
  double folded = 0.0;           // its frequency in periods of `foldHz`, folded into 0 .. 1/2
  double foldHz = 0.0;           // tooth passing, or the spindle
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
    int periodsPerRevolution = 1;  // of the forced vibration: 1, or the number of teeth
    double nominalHz = 100.0;      // spindle frequency, for the window
    double fastestHz = 120.0;      // highest one to come, for the sizes
    double duration = 10.0;        // [s]
    double settle = 0.1;           // [s]
    double highestHz = 1000.0;     // highest mode
  };
  explicit ChatterTruth(const Settings& settings);

  void add(const TruthSample& sample) noexcept;

  // Now.
  double ratio() const { return ratio_; }           // amplitude, chatter part to forced
  double chatterRatio() const { return counted_; }  // as far as it counts as chatter
  // chatterRatio above 0.2 for six revolutions and 50 ms, until 0.1; above 0.03 where a disturbance has had the time to
  // become as large as it becomes.
  bool chattering() const { return sustained_; }
  Metres marked() const { return Metres(marked_); }  // path cut with a chatterRatio above 0.5 (an energy ratio of 20 %)
  double vibration() const { return totalRms_; }     // rms of the tip's acceleration [m/s^2]

  // The first chatter of the run, afterwards.
  ChatterOnset onset() const;
  Hertz chatterFrequency() const;             // of the first chatter, from its first 0.22 s or 8 revolutions; 0: none
  ChatterKind kind() const;                   // hopf, flip, unknown: no chatter
  double peakRatio() const { return peak_; }  // 50 at most

  struct LogEntry {
    float time;        // [s], middle of the window
    float chatterRms;  // before division
    float forcedAndChatterRms, spindleHz, path;
    float ratio;    // as measured
    bool unstable;  // settled, in the cut, and growing
    bool repeats;   // the ratio comes from the departure
  };
  const std::vector<LogEntry>& log() const { return log_; }  // every millisecond
  double ratioAt(const LogEntry& e, Hertz chatter) const;

 private:
  void grow(double folds) noexcept;
  void count(const TruthSample& s, bool settled) noexcept;
  void decide(const TruthSample& s, double middle, bool settled) noexcept;
  double usualVibration() const noexcept;
  bool expected(double hz) const noexcept;
  double departed() const noexcept;
  void note(const TruthSample& s, double raw) noexcept;
  double gain(double chatterHz, double spindleHz) const noexcept;

  // Sum of squares over the window.
  struct Power {
    std::vector<double> squares;
    double sum = 0.0;
    void put(std::size_t at, double square) noexcept {
      sum += square - squares[at];
      squares[at] = square;
    }
    double rms() const noexcept;
  };

  Settings settings_;
  int perRev_;
  std::size_t window_;
  double spectrumLength_;                    // [s]
  std::array<std::vector<double>, 2> past_;  // two periods of tip acceleration, x and y
  std::size_t pastAt_ = 0;
  Power chatter_, total_, forced_, departure_;
  std::size_t windowAt_ = 0;
  std::size_t seen_ = 0, sinceCut_ = 0;
  double unsteadyUntil_ = 0.0, lastTime_ = 0.0, lastPath_ = 0.0, lastLog_ = -1.0;
  double ratio_ = 0.0, most_ = 0.0, counted_ = 0.0, totalRms_ = 0.0, peak_ = 0.0, marked_ = 0.0;
  double grown_ = 0.0, mostGrown_ = 0.0;  // of a small disturbance since the cut became unstable [e-folds]
  struct {
    double ratioSquare = 0.0;                 // of random forces, mean of late
    double vibration = 1.0, departure = 0.0;  // as multiples of the forced companion's vibration
  } usual_;                                   // of the stable cut
  double strongest_ = 0.0;
  bool flips_ = false;
  bool repeats_ = false;  // as the forced vibration does: only the departure shows it
  double aboveSince_ = -1.0;
  bool sustained_ = false;
  double liveGain_ = 1.0;  // of what is there now
  // Difference and departure around the first chatter, and when.
  std::vector<double> difference_, departures_, differenceTimes_;
  std::size_t differenceAt_ = 0;
  double meanHz_ = 0.0;  // of the spindle
  bool frozen_ = false;
  double freezeAt_ = -1.0, differenceRate_ = 0.0, eventTime_ = -1.0;
  bool eventFlips_ = false, differenceShows_ = true;
  double eventFolded_ = 0.0, eventFoldHz_ = 0.0;
  std::vector<LogEntry> log_;
};

}  // namespace stillcut::milling
