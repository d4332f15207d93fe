#include "tests/support/known_cuts/cut_families.h"

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "tests/support/known_cuts/family_orders.h"

namespace stillcut::bench {
namespace {

using milling::Scenario;

Orders hopf(int seeds) {
  Orders orders;
  each(kFast, seeds, 100, [&](Scenario& s, const milling::StabilityLimit& limit) {
    planDepth(s, kPlan, 0.5 * limit.depth.value, 1.3 * limit.depth.value);
    orders.push_back(order("hopf", s, AlarmRule::Sharp));
  });
  return orders;
}

Orders depthRamp(int seeds) {
  Orders orders;
  DepthPlan plan{.rise = 0.9, .risen = 2.1, .end = 2.6};
  each(kFast, seeds, 200, [&](Scenario& s, const milling::StabilityLimit& limit) {
    planDepth(s, plan, 0.5 * limit.depth.value, 1.5 * limit.depth.value);
    s.programme.depth.segments.back().shape = milling::RampShape::Linear;
    orders.push_back(order("depth ramp", s, AlarmRule::Ramp, plan));
  });
  return orders;
}

// The width of cut rises at a constant depth, which is that part of the limit at full width. The arc is as narrow at
// first as a cut beyond the limit needs.
Orders widen(int seeds, const char* family, double part, AlarmRule rule) {
  Orders orders;
  each(kFast, seeds, 300, [&](Scenario& s, const milling::StabilityLimit& limit) {
    const double depth = 1.4 * limit.depth.value;
    const double full = s.model.engagement.radialImmersion;
    // The narrowest cut that is stable at this depth by a margin.
    double narrow = full;
    for (int i = 0; i < 24; ++i) {
      narrow *= 0.88;
      s.model.engagement.radialImmersion = narrow;
      const auto at = limitOf(s);
      if (!at || at->depth.value > 2.0 * depth) break;
    }
    s.model.engagement.radialImmersion = full;
    if (narrow < 0.03) return;
    planDepth(s, kPlan, part * limit.depth.value, part * limit.depth.value);
    s.programme.immersion.segments = {{0.0, 0.9, narrow, narrow, milling::RampShape::Linear},
                                      {0.9, 1.7, narrow, full, milling::RampShape::Linear}};
    s.programme.duration = Seconds(2.4);
    orders.push_back(order(family, s, rule));
  });
  return orders;
}
Orders immersionRamp(int seeds) {
  return widen(seeds, "immersion ramp", 1.4, AlarmRule::Ramp);
}
Orders stableImmersionRamp(int seeds) {
  return widen(seeds, "stable, immersion ramp", 0.9, AlarmRule::Silent);
}

// The spindle's speed runs away by some percent a second while the depth rises; nobody tells.
Orders speedRamp(int seeds, bool told) {
  Orders orders;
  each(kFast, seeds, 500, [&](Scenario& s, const milling::StabilityLimit& limit) {
    planDepth(s, kPlan, 0.5 * limit.depth.value, 1.5 * limit.depth.value);
    const double perSecond = (s.seed % 2 == 0 ? 1.0 : -1.0) * 0.01 * (1.0 + 2.0 * static_cast<double>(s.seed % 3));
    const double rpm = s.programme.speed.value;
    s.programme.speedOverTime.segments = {{0.0, 2.2, rpm, rpm * (1.0 + 2.2 * perSecond), milling::RampShape::Linear}};
    orders.push_back(order(told ? "speed ramp, told" : "speed ramp", s, AlarmRule::Ramp));
    orders.back().machineTells = told;
  });
  return orders;
}
Orders speedRampUntold(int seeds) {
  return speedRamp(seeds, false);
}
Orders speedRampTold(int seeds) {
  return speedRamp(seeds, true);
}

// A stable cut whose speed ramps, or steps by an override of 5 to 15 %.
Orders stableSpeedChange(int seeds) {
  Orders orders;
  each(kFast, seeds, 600, [&](Scenario& s, const milling::StabilityLimit& limit) {
    const double rpm = s.programme.speed.value;
    planDepth(s, kPlan, 0.3 * limit.depth.value, 0.3 * limit.depth.value);
    const double perSecond = (s.seed % 2 == 0 ? 1.0 : -1.0) * 0.01 * (1.0 + 2.0 * static_cast<double>(s.seed % 3));
    s.programme.speedOverTime.segments = {{0.8, 2.2, rpm, rpm * (1.0 + 1.4 * perSecond), milling::RampShape::Linear}};
    orders.push_back(order("stable, speed ramps", s, AlarmRule::Silent));
    s.programme.speedOverTime.segments = {
        {0.0, 1.2, rpm, rpm, milling::RampShape::Linear},
        {1.2, 1.21, rpm, rpm * (s.seed % 2 == 0 ? 0.9 : 1.06), milling::RampShape::Linear}};
    s.drive.acceleration = 5000.0;
    orders.push_back(order("stable, speed steps, told", s, AlarmRule::Silent));
    orders.back().machineTells = true;
  });
  return orders;
}

Orders recovery(int seeds) {
  Orders orders;
  each(kFast, seeds, 700, [&](Scenario& s, const milling::StabilityLimit& limit) {
    planDepth(s, kPlan, 0.5 * limit.depth.value, 1.3 * limit.depth.value);
    const double high = 1.3 * limit.depth.value;
    s.programme.depth.segments.push_back({1.3, 1.7, high, high, milling::RampShape::Linear});
    s.programme.depth.segments.push_back({1.7, 1.9, high, 0.4 * limit.depth.value, milling::RampShape::Smoothstep});
    s.programme.duration = Seconds(3.0);
    orders.push_back(order("recovery by depth", s, AlarmRule::Sharp));
    orders.back().recovers = true;
  });
  return orders;
}

// The speed goes to where the exact lobes carry the depth.
Orders recoveryBySpeed(int seeds) {
  Orders orders;
  each(kFast, seeds, 800, [&](Scenario& s, const milling::StabilityLimit& limit) {
    const double high = 1.3 * limit.depth.value;
    const Rpm programmed = s.programme.speed;
    double quiet = 0.0;
    for (const double factor : {0.96, 1.04, 0.92, 1.08, 0.88, 1.12, 0.84, 1.16}) {
      s.programme.speed = Rpm(programmed.value * factor);
      const auto there = limitOf(s);
      if (there && there->depth.value < 2.0 * high) continue;
      quiet = s.programme.speed.value;
      break;
    }
    s.programme.speed = programmed;
    if (!(quiet > 0.0)) return;
    planDepth(s, kPlan, 0.5 * limit.depth.value, high);
    s.programme.speedOverTime.segments = {{0.0, 1.7, programmed.value, programmed.value, milling::RampShape::Linear},
                                          {1.7, 2.0, programmed.value, quiet, milling::RampShape::Smoothstep}};
    s.programme.duration = Seconds(3.2);
    orders.push_back(order("recovery by speed, told", s, AlarmRule::Sharp));
    orders.back().recovers = orders.back().machineTells = true;
  });
  return orders;
}

Orders entryChatter(int seeds) {
  Orders orders;
  each(kFast, seeds, 900, [&](Scenario& s, const milling::StabilityLimit& limit) {
    planDepth(s, kPlan, 1.6 * limit.depth.value, 1.6 * limit.depth.value);
    orders.push_back(order("chatter from entry", s, AlarmRule::Present));
  });
  return orders;
}

Orders slowSpindle(int seeds) {
  constexpr std::array<ToolKind, 1> kTools{ToolKind::FaceMill};
  Orders orders;
  each(kTools, 2 * seeds, 1000, [&](Scenario& s, const milling::StabilityLimit& limit) {
    planDepth(s, kSlowPlan, 0.6 * limit.depth.value, 1.3 * limit.depth.value);
    orders.push_back(order("slow spindle", s, AlarmRule::Slow, kSlowPlan));
  });
  return orders;
}

Orders strongRunout(int seeds) {
  Orders orders;
  each(kFast, seeds, 1100, [&](Scenario& s, const milling::StabilityLimit& limit) {
    for (auto& r : s.model.tool.runout) r = Metres(r.value * 4.0);
    planDepth(s, kPlan, 0.5 * limit.depth.value, 1.3 * limit.depth.value);
    orders.push_back(order("strong runout", s, AlarmRule::Sharp));
  });
  return orders;
}

// Stable cuts: near the limit with an uneven material, a harmonic on a mode, in and out of the material.
Orders stable(int seeds) {
  Orders orders;
  constexpr DepthPlan kLong{.rise = 1.0, .risen = 1.3, .end = 4.0};
  each(kFast, seeds, 1200, [&](Scenario& s, const milling::StabilityLimit& limit) {
    s.programme.unevenness = 1.85e-5;
    planDepth(s, kLong, 0.9 * limit.depth.value, 0.9 * limit.depth.value);
    orders.push_back(order("stable, near the limit", s, AlarmRule::Silent));
    planDepth(s, kLong, 0.5 * limit.depth.value, 0.9 * limit.depth.value);
    orders.push_back(order("stable, rises to the limit", s, AlarmRule::Silent));
    planDepth(s, kLong, 0.5 * limit.depth.value, 0.5 * limit.depth.value);
    s.programme.entry = milling::Passage{milling::Along::Time, 0.6};
    s.programme.exit = milling::Passage{milling::Along::Time, 3.2};
    s.programme.depth.segments = {{0.0, 0.1, 0.5 * limit.depth.value, 0.5 * limit.depth.value}};
    orders.push_back(order("stable, entry and exit", s, AlarmRule::Silent));
    orders.back().quietFrom = 1.5;
    orders.back().quietTo = 2.5;
  });
  return orders;
}

Orders forcedResonance(int seeds) {
  Orders orders;
  for (const ToolKind tool : kFast) {
    for (int seed = 1; seed <= seeds; ++seed) {
      Scenario s = scattered(tool, 1300 + static_cast<std::uint64_t>(seed));
      const double tooth = s.programme.speed.value / 60.0 * s.model.tool.teeth;
      const double k = std::max(1.0, std::round(s.model.modes[0].frequency.value / tooth));
      s.programme.speed = Rpm(60.0 * s.model.modes[0].frequency.value / (k * s.model.tool.teeth));
      const auto limit = limitOf(s);
      if (!limit) continue;
      planDepth(s, kPlan, 0.3 * limit->depth.value, 0.7 * limit->depth.value);
      orders.push_back(order("stable, forced resonance", s, AlarmRule::Silent));
    }
  }
  return orders;
}

// One to six teeth, rates from 5 to 102 kHz, noise from 1 to 10 % of the stable vibration, blocks from 1 to 100 ms.
Orders varied(int seeds) {
  constexpr std::array<double, 4> kRates{5120.0, 12800.0, 51200.0, 102400.0};
  constexpr std::array<double, 3> kNoises{0.01, 0.03, 0.1};
  constexpr std::array<double, 4> kBlocks{0.001, 0.005, 0.02, 0.1};
  Orders orders;
  for (int seed = 1; seed <= 4 * seeds; ++seed) {
    const auto i = static_cast<std::size_t>(seed);
    Scenario s = scattered(kFast[i % kFast.size()], 1400 + i);
    const double told = static_cast<double>(s.model.tool.teeth) * s.programme.speed.value;
    s.model.tool.teeth = 1 + seed % 6;
    s.model.tool.runout.resize(static_cast<std::size_t>(s.model.tool.teeth));
    s.programme.speed = Rpm(told / std::max(2, s.model.tool.teeth));  // teeth pass as often as they did
    s.rate = Hertz(kRates[i % kRates.size()]);
    const auto limit = limitOf(s);
    if (!limit) continue;
    planDepth(s, kPlan, 0.5 * limit->depth.value, 1.3 * limit->depth.value);
    orders.push_back(order("varied", s, AlarmRule::Sharp));
    orders.back().name += "-Z" + std::to_string(s.model.tool.teeth);
    orders.back().noise = kNoises[i % kNoises.size()];
    orders.back().block = kBlocks[(i / 2) % kBlocks.size()];
  }
  return orders;
}

constexpr std::array<CutFamily, 25> kFamilies{{
    {"hopf", "depth rises through the limit", hopf},
    {"depth ramp", "the depth goes on rising through the limit", depthRamp},
    {"immersion ramp", "the width of cut rises through the limit", immersionRamp},
    {"stable, immersion ramp", "no chatter", stableImmersionRamp},
    {"flip, odd teeth", "period doubling between spindle harmonics", flipOdd},
    {"flip, even teeth", "period doubling on spindle harmonics", flipEven},
    {"speed ramp", "speed drifts 1 to 5 %/s, nobody tells", speedRampUntold},
    {"speed ramp, told", "speed drifts 1 to 5 %/s, the machine tells", speedRampTold},
    {"stable, speed changes", "no chatter", stableSpeedChange},
    {"recovery by depth", "chatter ends", recovery},
    {"recovery by speed", "chatter ends", recoveryBySpeed},
    {"chatter from entry", "no stable stretch to learn from", entryChatter},
    {"slow spindle", "chatter near an order", slowSpindle},
    {"stable, slow spindle", "no chatter", slowStable},
    {"stable, face mill in and out", "no chatter", slowPassage},
    {"stable, quick rise", "no chatter", quickRise},
    {"stable, speed drifts", "no chatter", speedDrifts},
    {"stable, into the slot", "no chatter", intoTheSlot},
    {"stable, corners and steps", "no chatter", cornersAndSteps},
    {"stable, strong runout", "no chatter", strongStable},
    {"stable, flip", "no chatter", flipStable},
    {"strong runout", "spindle harmonics as strong as the teeth's", strongRunout},
    {"stable", "no chatter", stable},
    {"forced resonance", "no chatter", forcedResonance},
    {"varied", "teeth, rate, noise and length of the blocks", varied},
}};

}  // namespace

std::span<const CutFamily> cutFamilies() {
  return kFamilies;
}

SimulationOrder orderOf(std::string_view family, int seeds, std::string_view name) {
  for (const CutFamily& one : cutFamilies()) {
    if (one.name != family) continue;
    for (SimulationOrder& order : one.make(seeds)) {
      if (order.name == name) return order;
    }
  }
  throw std::invalid_argument(std::string(family) + " has no " + std::string(name));
}

}  // namespace stillcut::bench
