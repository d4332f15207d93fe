#include <algorithm>
#include <cmath>

#include "tests/support/known_cuts/cut_families.h"
#include "tests/support/known_cuts/family_orders.h"

namespace stillcut::bench {
namespace {

using milling::Scenario;

constexpr double kDeepest = 0.03;  // m, where there is no limit
constexpr int kSteps = 24;         // of what changes, looked at for its least limit

double depthLimit(const Scenario& s) {
  const auto limit = limitOf(s);
  return limit ? std::min(kDeepest, limit->depth.value) : kDeepest;
}

// The least limit that there is while change(scenario, step) takes it through kSteps.
template <class Change>
double leastLimit(Scenario s, const Change& change) {
  double least = kDeepest;
  for (int k = 0; k <= kSteps; ++k) {
    change(s, k);
    least = std::min(least, depthLimit(s));
  }
  return least;
}

// ... while the arc goes from one width to another, at the scenario's speed.
double leastLimit(const Scenario& s, double from, double to) {
  return leastLimit(
      s, [&](Scenario& there, int k) { there.model.engagement.radialImmersion = from + (to - from) * k / kSteps; });
}

}  // namespace

// At 0.9 of the limit in uneven material, and on the way there.
std::vector<SimulationOrder> slowStable(int seeds) {
  constexpr std::array<ToolKind, 1> kTools{ToolKind::FaceMill};
  Orders orders;
  each(kTools, seeds, 2000, [&](Scenario& s, const milling::StabilityLimit& limit) {
    const double high = 0.9 * limit.depth.value;
    planDepth(s, kSlowPlan, 0.5 * limit.depth.value, high);
    orders.push_back(order("stable, slow spindle", s, AlarmRule::Silent, kSlowPlan));
    orders.back().name += "-rises";
    s.programme.unevenness = 1.85e-5;
    planDepth(s, kSlowPlan, high, high);
    orders.push_back(order("stable, slow spindle", s, AlarmRule::Silent, kSlowPlan));
  });
  return orders;
}

// A cutter of 50 mm at 5 mm/s is seconds on its way into the work and out of it; its runout meets a mode meanwhile, and
// the noise is as little as a good sensor's.
std::vector<SimulationOrder> slowPassage(int seeds) {
  constexpr std::array<ToolKind, 1> kTools{ToolKind::FaceMill};
  Orders orders;
  each(kTools, seeds, 2200, [&](Scenario& s, const milling::StabilityLimit& limit) {
    const double depth = 0.5 * limit.depth.value;
    planDepth(s, kSlowPlan, depth, depth);
    s.programme.entry = milling::Passage{milling::Along::Time, 1.0};
    s.programme.exit = milling::Passage{milling::Along::Time, 7.65};
    s.programme.depth.segments = {{0.0, 0.1, depth, depth}};
    orders.push_back(order("stable, face mill in and out", s, AlarmRule::Silent, kSlowPlan));
    orders.back().quietFrom = 4.5;
    orders.back().quietTo = 6.0;
    orders.back().noise = 0.007;
  });
  return orders;
}

// To 0.9 of the limit within half a second, from the slowest spindle to the fastest: a load that changes, and no more.
std::vector<SimulationOrder> quickRise(int seeds) {
  constexpr std::array<ToolKind, 4> kTools{ToolKind::FaceMill, ToolKind::TwoFlute, ToolKind::ThreeFlute,
                                           ToolKind::FourFlute};
  constexpr DepthPlan kQuick{.entry = 0.5, .entered = 0.7, .rise = 3.0, .risen = 3.5, .end = 5.0};
  Orders orders;
  const auto add = [&](Scenario s, const char* what) {
    const auto limit = limitOf(s);
    if (!limit) return;
    planDepth(s, kQuick, 0.4 * limit->depth.value, 0.9 * limit->depth.value);
    orders.push_back(order("stable, quick rise", s, AlarmRule::Silent, kQuick));
    orders.back().name += what;
  };
  each(kTools, seeds, 2100, [&](Scenario& s, const milling::StabilityLimit&) {
    add(s, "");
    if (s.programme.speed.value > 1000.0) return;
    s.programme.speed = s.programme.speed * 1.9;
    add(s, "-faster");
    s.programme.speed = s.programme.speed * 0.5;
    s.model.tool.teeth = 6;
    s.model.tool.runout.insert(s.model.tool.runout.end(), {Metres(0.0), s.model.tool.runout.front()});
    add(s, "-Z6");
  });
  return orders;
}

// Runout of up to two thirds of the feed per tooth, tools of two to six teeth, a depth that rises to just below the
// limit: where a mode is on an order between the tooth passings, most of the vibration is runout's, and it is
// amplified.
std::vector<SimulationOrder> strongStable(int seeds) {
  constexpr std::array<ToolKind, 4> kTools{ToolKind::FaceMill, ToolKind::TwoFlute, ToolKind::ThreeFlute,
                                           ToolKind::FourFlute};
  Orders orders;
  const auto add = [&](Scenario s, const char* what, double seconds, double high) {
    for (auto& r : s.model.tool.runout) r = Metres(r.value * 4.0);
    const auto limit = limitOf(s);
    if (!limit) return;
    const bool slow = s.programme.speed.value < 1000.0;
    DepthPlan plan = slow ? kSlowPlan : DepthPlan{.end = 2.6};
    plan.risen = plan.rise + (slow ? 5.0 : 1.0) * seconds;
    planDepth(s, plan, 0.5 * limit->depth.value, high * limit->depth.value);
    orders.push_back(order("stable, strong runout", s, AlarmRule::Silent, plan));
    orders.back().name += what;
    orders.back().repeats = true;
  };
  each(kTools, seeds, 1100, [&](Scenario& s, const milling::StabilityLimit&) {
    add(s, "", 0.3, 0.9);
    add(s, "-quick", 0.1, 0.95);
    // As many passings of other teeth.
    const double passings = s.model.tool.teeth * s.programme.speed.value;
    const double runout = 1.7e-5 * std::fmod(0.37 * static_cast<double>(s.seed), 1.0);
    s.model.tool.teeth = 2 + static_cast<int>(s.seed % 5);
    s.programme.speed = Rpm(passings / s.model.tool.teeth);
    s.model.tool.runout.clear();
    for (int j = 0; j < s.model.tool.teeth; ++j) {
      const double angle = kTwoPi * j / s.model.tool.teeth + static_cast<double>(s.seed);
      s.model.tool.runout.emplace_back(runout * std::cos(angle));
    }
    const std::string teeth = "-Z" + std::to_string(s.model.tool.teeth);
    add(s, teeth.c_str(), 0.1, 0.9);
    add(s, (teeth + "-slowly").c_str(), 0.3, 0.95);
  });
  return orders;
}

// The speed drifts, and the depth rises to just below the least limit that there is on the way: modes come and go on
// the spindle's orders, near the limit as sharply as anywhere.
std::vector<SimulationOrder> speedDrifts(int seeds) {
  constexpr double kSeconds = 2.2;
  Orders orders;
  const auto add = [&](Scenario s, const char* what, double perSecond) {
    const double rpm = s.programme.speed.value;
    const double least = leastLimit(s, [&](Scenario& there, int k) {
      there.programme.speed = Rpm(rpm * (1.0 + perSecond * kSeconds * k / kSteps));
    });
    planDepth(s, kPlan, 0.5 * least, 0.9 * least);
    s.programme.speedOverTime.segments = {
        {0.0, kSeconds, rpm, rpm * (1.0 + kSeconds * perSecond), milling::RampShape::Linear}};
    orders.push_back(order("stable, speed drifts", s, AlarmRule::Silent));
    orders.back().name += what;
  };
  each(kFast, seeds, 500, [&](Scenario& s, const milling::StabilityLimit&) {
    const double perSecond = (s.seed % 2 == 0 ? 1.0 : -1.0) * 0.01 * (1.0 + 2.0 * static_cast<double>(s.seed % 3));
    add(s, "", perSecond);
    for (auto& r : s.model.tool.runout) r = Metres(r.value * 3.0);
    add(s, "-runout", perSecond);
  });
  return orders;
}

// From a fifth of the width to a full slot, where tooth passings cancel and runout is most of what there is; below the
// limit all the way.
std::vector<SimulationOrder> intoTheSlot(int seeds) {
  constexpr double kNarrow = 0.2;
  Orders orders;
  const auto add = [&](Scenario s, const char* what, double seconds) {
    const double depth = 0.8 * leastLimit(s, kNarrow, 1.0);
    planDepth(s, kPlan, depth, depth);
    s.programme.immersion.segments = {{0.0, 0.9, kNarrow, kNarrow, milling::RampShape::Linear},
                                      {0.9, 0.9 + seconds, kNarrow, 1.0, milling::RampShape::Linear}};
    orders.push_back(order("stable, into the slot", s, AlarmRule::Silent));
    orders.back().name += what;
    orders.back().quietTo = 0.9;
    orders.back().repeats = true;
  };
  each(kFast, seeds, 2300, [&](Scenario& s, const milling::StabilityLimit&) {
    add(s, "", 0.8);
    add(s, "-quick", 0.2);
    for (auto& r : s.model.tool.runout) r = Metres(r.value * 4.0);
    add(s, "-runout", 0.8);
    add(s, "-quick-runout", 0.2);
  });
  return orders;
}

// What a programme asks of a cut without a word: an inner corner, the same with the feed taken back, steps in the
// stock, holes that the tool passes over.
std::vector<SimulationOrder> cornersAndSteps(int seeds) {
  constexpr double kNarrow = 0.25;
  constexpr double kWide = 0.75;
  Orders orders;
  each(kFast, seeds, 2400, [&](Scenario& s, const milling::StabilityLimit&) {
    const auto linear = milling::RampShape::Linear;
    const auto add = [&](const Scenario& cut, const char* what) {
      orders.push_back(order("stable, corners and steps", cut, AlarmRule::Silent));
      orders.back().name += what;
      orders.back().quietTo = 0.9;
      orders.back().repeats = true;
    };
    const double depth = 0.9 * leastLimit(s, kNarrow, kWide);
    Scenario corner = s;
    planDepth(corner, kPlan, depth, depth);
    corner.programme.immersion.segments = {
        {0.0, 0.9, kNarrow, kNarrow, linear}, {0.9, 1.2, kNarrow, kWide, linear}, {1.2, 1.5, kWide, kNarrow, linear}};
    add(corner, "-corner");
    const double feed = s.programme.feedPerTooth.value;
    corner.programme.feedPerToothOverTime.segments = {
        {0.0, 0.8, feed, feed, linear}, {0.8, 1.0, feed, 0.4 * feed, linear}, {1.4, 1.6, 0.4 * feed, feed, linear}};
    add(corner, "-slower");
    s.model.engagement.radialImmersion = kWide;
    const double limit = 0.9 * depthLimit(s);
    Scenario step = s;
    planDepth(step, kPlan, 0.4 * limit, limit);
    step.programme.depth.segments = {{0.3, 0.35, 0.0, 0.4 * limit, linear},
                                     {1.0, 1.02, 0.4 * limit, limit, linear},
                                     {1.5, 1.52, limit, 0.6 * limit, linear}};
    add(step, "-step");
    step.programme.depth.segments = {{0.3, 0.35, 0.0, limit, linear}};
    for (const double at : {0.9, 1.3, 1.7}) {
      step.programme.depth.segments.push_back({at, at + 0.04, limit, 0.3 * limit, linear});
      step.programme.depth.segments.push_back({at + 0.08, at + 0.12, 0.3 * limit, limit, linear});
    }
    add(step, "-holes");
  });
  return orders;
}

}  // namespace stillcut::bench
