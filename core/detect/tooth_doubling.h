// Period doubling with an even number of teeth: the chatter lies at odd multiples of half the tooth-passing frequency,
// which are spindle harmonics (orders (k + 1/2) Z), stands still from turn to turn once it is full, and is taken out
// with the forced vibration. What tells it from that is growth: in a stable cut these orders hold the runout of
// alternate teeth, a share of the tooth-passing orders that stays as it is while the load changes. So their share is
// tested against its own learned floor (onset_test.h). With an odd number of teeth those orders lie between the
// harmonics, and this is idle. Not in Caliskan 2018, where even teeth and flips are not mentioned. Thread: worker;
// everything real-time.
#pragma once

#include "core/base/units.h"
#include "core/detect/energy_chain.h"
#include "core/detect/onset_test.h"

namespace stillcut::detect {

class ToothDoubling {
 public:
  // eta: of the energy ratio's weights (Caliskan 2018 eq. 28).
  void prepare(int teeth, int eta) noexcept;
  void setEvidence(double evidence) noexcept;
  void relearn() noexcept { onset_.reset(); }
  // What modes make of runout changes with the speed: beyond their damping's width the floor is learned anew.
  void setSpindle(Hertz spindle) noexcept;
  // One hop: what the harmonic filter holds of a channel.
  void endHop(const EnergyChain& chain, int channel) noexcept;
  void test(double turns, bool learn) noexcept;

  bool grown() const noexcept { return onset_.alarm(); }
  // One order stands out of them, as a mode does.
  bool stands() const noexcept { return grown() && purity_ >= kLeastPurity; }
  int order() const noexcept { return order_; }
  // Part of the weighted energy that the doubling holds, above its floor.
  double severity() const noexcept;

 private:
  static constexpr double kLeastPurity = 0.4;

  int teeth_ = 0;
  int eta_ = 0;
  double share_ = 0.0;
  double energy_ = 0.0;
  double weightedShare_ = 0.0;
  double purity_ = 0.0;
  int order_ = 0;
  Hertz learnedAt_{};
  OnsetTest onset_;
};

}  // namespace stillcut::detect
