// TapTest: a tap test along one axis as it happens: hits are caught out of the stream, judged as they come, kept or
// refused with the reason, until there are enough good ones.
//
// A hit is refused that bounces, that reaches the end of a channel's range, that is too weak to stand out, that comes
// while the one before still rings, that lacks samples, or whose response over force is not that of the others (the
// median of its distances to them, over the lines that the hammer reaches with a tenth of its largest line). With two
// hits that differ nobody can tell which is wrong: both stay until a third has come. Whoever measures may decide
// otherwise on each.
//
// Without a hammer channel the response alone triggers, and its decay is compared. Thread: one. Allocates.
#pragma once

#include <complex>
#include <optional>
#include <span>
#include <vector>

#include "core/milling/identify/hammer.h"
#include "core/milling/identify/live/hit_catcher.h"

namespace stillcut::identify {

enum class HitFault { None, DoubleHit, ForceOverload, ResponseOverload, Weak, TooSoon, Gap, Incoherent };

struct TapHit {
  double time = 0.0;        // since the test began [s]
  double peak = 0.0;        // of the force [N], without a hammer of the response
  double width = 0.0;       // of the force pulse at half height [s]; 0 without a hammer
  double difference = 0.0;  // from the others, relative; 0 while there are none
  HitFault fault = HitFault::None;
  std::optional<bool> asked;  // what somebody has said of it, whatever the fault
  bool used() const { return asked.value_or(fault == HitFault::None); }
};

struct TapTestOptions {
  CatcherOptions catcher;
  HammerOptions hammer;  // of the analysis; its `doubleHit` is used here as well
  bool withForce = true;
  int enough = 5;              // good hits
  double forceRange = 0.0;     // where the channel ends [N]; 0: a flat top tells
  double responseRange = 0.0;  // [SI unit]
  double weakShare = 0.2;      // of the median peak of the good ones: weaker is refused
  double weakNoises = 30.0;    // peak over the rms of the noise: 30 dB
  double differs = 0.35;       // relative; repeatable hands reach 0.1
  FrfQuantity quantity = FrfQuantity::Accelerance;
  Axis axis = Axis::X;
};

class TapTest {
 public:
  enum class Phase { Settling, Waiting, Recording, Ringing, Enough };

  TapTest(double rate, const TapTestOptions& options);

  // Samples in SI units; see HitCatcher. True: the list of hits has changed.
  bool feed(std::span<const double> force, std::span<const double> response, bool gap);
  Phase phase() const;
  double level() const { return catcher_.level(); }
  const std::vector<TapHit>& hits() const { return hits_; }
  int good() const;  // hits used
  // Somebody decides on a hit, from 0.
  void use(std::size_t hit, bool use);
  // What is used, for the analysis: one record a hit.
  std::vector<HammerRecord> records() const;
  const TapTestOptions& options() const { return options_; }

 private:
  TapHit judgeAlone(CaughtHit& caught);
  void compare();
  std::vector<std::complex<double>> signature(const HammerRecord& record) const;

  double rate_;
  TapTestOptions options_;
  HitCatcher catcher_;
  std::vector<TapHit> hits_;
  std::vector<HammerRecord> records_;                          // one each
  std::vector<std::vector<std::complex<double>>> signatures_;  // one each; empty: not to be compared
};

}  // namespace stillcut::identify
