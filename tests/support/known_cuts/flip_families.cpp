#include <algorithm>
#include <cmath>
#include <optional>

#include "tests/support/known_cuts/cut_families.h"
#include "tests/support/known_cuts/family_orders.h"

namespace stillcut::bench {
namespace {

using milling::Scenario;

constexpr std::array<ToolKind, 1> kOdd{ToolKind::ThreeFlute};
constexpr std::array<ToolKind, 2> kEven{ToolKind::TwoFlute, ToolKind::FourFlute};

// Low immersion at a speed where the exact lobes end at a multiplier of -1; whole samples per tooth period, so that the
// truth can compare one tooth with the next exactly. Calls make(scenario, limit).
template <class Make>
void eachFlip(std::span<const ToolKind> tools, int seeds, Metres runout, const Make& make) {
  for (const ToolKind tool : tools) {
    for (int seed = 1; seed <= seeds; ++seed) {
      Scenario s = scattered(tool, 400 + static_cast<std::uint64_t>(seed));
      const bool up = seed % 2 == 0;
      const double arc = kTwoPi / s.model.tool.teeth * (0.13 + 0.02 * (seed % 3));  // how long a tooth cuts
      s.model.engagement = {0.5 * (1.0 - std::cos(arc)),
                            up ? milling::MillingDirection::Up : milling::MillingDirection::Down};
      s.model.modes[0].damping = 0.012;
      s.model.modes[1].stiffness *= 10.0;
      s.model.modes[0].stiffness = 1.5e6;
      for (int j = 0; j < s.model.tool.teeth; ++j) {
        s.model.tool.runout[static_cast<std::size_t>(j)] = runout * std::cos(kTwoPi * j / s.model.tool.teeth + 0.4);
      }
      // A flip lobe hangs from where the mode is near an odd multiple of half the tooth-passing frequency.
      const double mode = s.model.modes[0].frequency.value;
      std::optional<milling::StabilityLimit> found;
      for (int k = 1 + (seed / 2) % 2; k > 0 && !found; --k) {
        for (double above = up ? 1.03 : 0.985; std::abs(above - 1.0) < 0.08 && !found; above += up ? 0.01 : -0.01) {
          const double samples = std::round(s.rate.value * (k + 0.5) / (above * mode));
          s.programme.speed = Rpm(60.0 * s.rate.value / (samples * s.model.tool.teeth));
          const auto limit = limitOf(s);
          if (limit && limit->kind == milling::CrossingKind::Flip) found = limit;
        }
      }
      if (found) make(s, *found);
    }
  }
}

Orders flip(int seeds, const char* family, std::span<const ToolKind> tools, Metres runout) {
  Orders orders;
  eachFlip(tools, seeds, runout, [&](Scenario& s, const milling::StabilityLimit& limit) {
    planDepth(s, kPlan, 0.6 * limit.depth.value, 1.35 * limit.depth.value);
    orders.push_back(order(family, s, AlarmRule::Sharp));
    orders.back().doubling = s.model.tool.teeth % 2 == 0;
  });
  return orders;
}

}  // namespace

std::vector<SimulationOrder> flipOdd(int seeds) {
  return flip(seeds, "flip, odd teeth", kOdd, Metres(1e-6));
}

std::vector<SimulationOrder> flipEven(int seeds) {
  Orders orders = flip(seeds, "flip, even teeth", kEven, Metres(0.0));
  for (SimulationOrder& o : flip(seeds, "flip, even teeth", kEven, Metres(1e-6))) {
    o.name += "-runout";
    orders.push_back(o);
  }
  return orders;
}

// The same cuts just below where they double. A mode amplifies by ten and by twenty there what runout leaves half way
// between the tooth passings, as the depth rises.
std::vector<SimulationOrder> flipStable(int seeds) {
  Orders orders;
  for (const std::span<const ToolKind> tools : {std::span<const ToolKind>(kOdd), std::span<const ToolKind>(kEven)}) {
    for (const int microns : {0, 1, 4}) {
      eachFlip(tools, seeds, Metres(1e-6 * microns), [&](Scenario& s, const milling::StabilityLimit& limit) {
        for (const int percent : {90, 95}) {
          for (const bool slowly : {false, true}) {
            const DepthPlan plan{.risen = slowly ? 1.8 : 1.3};
            planDepth(s, plan, 0.6 * limit.depth.value, 0.01 * percent * limit.depth.value);
            orders.push_back(order("stable, flip", s, AlarmRule::Silent, plan));
            orders.back().name += "-" + std::to_string(microns) + "um-" + std::to_string(percent);
            if (slowly) orders.back().name += "-slowly";
            orders.back().repeats = true;
          }
        }
      });
    }
  }
  return orders;
}

}  // namespace stillcut::bench
