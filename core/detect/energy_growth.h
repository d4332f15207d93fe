// Growth of one channel's turn difference (turn_difference.h) over its vibration, hop by hop: eighths of a turn.
// Thread: worker; real-time.
#pragma once

#include <array>

#include "core/detect/onset_test.h"

namespace stillcut::detect {

inline constexpr int kHopsPerTurn = 8;

class EnergyGrowth {
 public:
  static constexpr int kLevelHops = 8 * kHopsPerTurn;

  void prepare(const OnsetTest::Limits& limits) noexcept { onset_.prepare(limits); }
  // Forgets the levels, after a gap; what was learned stays.
  void restart() noexcept;
  void relearn() noexcept { onset_.reset(); }

  // One frame: the vibration and its turn difference.
  void add(double x, double difference) noexcept {
    sums_.all += x * x;
    sums_.changed += difference * difference;
  }
  // windowHops: newest hops over which the turn difference is averaged.
  void endHop(int windowHops) noexcept;
  // Tests the level of the last hop; learn: the cut is steady and nobody alarms.
  void test(int windowHops, bool learn) noexcept { onset_.update(changed_, 1.0 / windowHops, learn); }

  // E_d / E_x of the newest window.
  double changed() const noexcept { return changed_; }
  // Exponential growth shows before any spectrum can: three stretches in a row, each well above the one before. A knock
  // rises once and decays.
  bool rising() const noexcept;
  const OnsetTest& onset() const noexcept { return onset_; }

 private:
  struct Energies {
    double all = 0.0;
    double changed = 0.0;  // of the turn difference
  };
  const Energies& ago(int hops) const noexcept {
    return hops_[static_cast<std::size_t>((newest_ - hops + kLevelHops) % kLevelHops)];
  }
  bool grows(int hops, double factor) const noexcept;

  Energies sums_;  // this hop
  std::array<Energies, kLevelHops> hops_{};
  int newest_ = 0;
  double changed_ = 0.0;
  OnsetTest onset_;
};

}  // namespace stillcut::detect
