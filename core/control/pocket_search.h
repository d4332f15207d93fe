// PocketSearch: which speed to try next. First the lobes, where they are known: the stable range nearest to where the
// frequency rule points. Without lobes, or where a speed that they call stable chattered: the rule itself
// (van Dijk 2010 eq. 29, 30), or as far up toward it as the override reaches where that leaves a quarter wave at most;
// then its neighbouring pockets, nearest first, for every frequency measured so far; never again near a speed that has
// been tried, unless two that were tried point at each other: then the pocket lies between them.
// Chatter's frequency falls with the speed, so that eq. 30 with the frequency of the old speed stops short of the
// pocket's centre. Its repetition is a fixed-point iteration, n -> 60 f_c(n) / (p Z), whose fixed point is the centre
// for every member f_c + k f_tp of the family; two of its members give the others by Aitken's extrapolation.
// Thread: prepare() at set-up, the rest on the worker, real-time.
#pragma once

#include <array>
#include <cstddef>

#include "core/control/target_speed.h"
#include "core/model/cut_setup.h"
#include "core/model/reason.h"

namespace stillcut::control {

struct SearchView {
  Hertz chatter{};
  Rpm present{};
  config::SpeedRange reach;
};

struct NextSpeed {
  Rpm speed{};  // 0: nothing is left to try
  Reason reason;
};

class PocketSearch {
 public:
  static constexpr std::size_t kRanges = 32;  // stable ranges kept
  static constexpr std::size_t kTried = 8;

  void prepare(const CutSetup& setup);
  void forget() STILLCUT_RT { tried_ = 0; }

  // The present speed chatters: it counts as tried from now on.
  NextSpeed next(const SearchView& view) STILLCUT_RT;
  // So does this one, though the spindle has left it.
  void countAsTried(Rpm speed, Hertz chatter) STILLCUT_RT;
  int tried() const STILLCUT_RT { return static_cast<int>(tried_); }

 private:
  struct Failure {
    Rpm speed{};
    Hertz chatter{};
  };

  struct Centre {
    Rpm speed{};
    bool between = false;  // two speeds that have been tried
  };

  // Which pocket a chatter belongs to: the waves that eq. 29 rounds, but of the tool's own frequency. By the lobes of
  // one mode chatter has k + phi waves, phi from 1 at the pocket k + 1 down to 1/2 far above it, and lies above the
  // mode by zeta cot(pi (phi - 1/2)): with phi near 1/2 it is the next pocket up that is near, and it carries more.
  int pocketOf(Hertz chatter, Rpm speed) const STILLCUT_RT;
  bool triedWithin(Rpm speed, double share) const STILLCUT_RT;
  bool wasHeard(Rpm speed) const STILLCUT_RT;             // this very speed
  bool wasTried(Rpm speed, int waves) const STILLCUT_RT;  // the same place of the same pocket
  NextSpeed fromLobes(const SearchView& view) const STILLCUT_RT;
  NextSpeed fromRule(const SearchView& view) const STILLCUT_RT;
  double wayFrom(const Failure& failure) const STILLCUT_RT;
  const Failure* across(const SearchView& view, int waves) const STILLCUT_RT;
  Centre centreOf(const SearchView& view, int waves) const STILLCUT_RT;

  int teeth_ = 0;
  bool lobesKnown_ = false;
  std::size_t ranges_ = 0;
  std::array<StableSpeeds::Range, kRanges> range_{};
  Metres depth_{}, deepestDepth_{};
  Rpm deepestSpeed_{};
  std::size_t tried_ = 0;
  std::array<Failure, kTried> failure_{};
};

}  // namespace stillcut::control
