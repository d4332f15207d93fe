#include "core/control/pocket_search.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stillcut::control {
namespace {

// Pocket p and p + 1 lie Omega/(p + 1) apart. A speed within an eighth of that of one that chattered is in the same
// place of the same pocket; less than 1 % is within what spindle and frequency are known to.
constexpr double kSamePlace = 0.125;
constexpr double kSmallestMove = 0.01;
// Distance kept from a stability limit, as a fraction of the stable range.
constexpr double kInside = 0.2;
// A quarter of a wave too many between two teeth is where Liao 1996 would go by choice: the reach may end there.
constexpr double kQuarterWave = 0.25;
// Where two speeds point at each other the next lies at least this fraction of their distance from each.
constexpr double kBetween = 0.1;
// How much of a step of the rule the next one may repeat: at 0.85 what is left of the way is seven steps.
constexpr double kSteepest = 0.85;
// Damping of a tool that nobody has measured: 1 to 5 %.
constexpr double kUsualDamping = 0.03;

}  // namespace

void PocketSearch::prepare(const CutSetup& setup) {
  teeth_ = setup.teeth;
  lobesKnown_ = setup.stableSpeeds.has_value();
  ranges_ = 0;
  if (lobesKnown_) {
    const StableSpeeds& known = *setup.stableSpeeds;
    for (const StableSpeeds::Range& range : known.ranges) {
      if (ranges_ < kRanges) range_[ranges_++] = range;
    }
    depth_ = known.depth;
    deepestDepth_ = known.largestStableDepth;
    deepestSpeed_ = known.largestDepthSpeed;
  }
  forget();
}

NextSpeed PocketSearch::next(const SearchView& view) STILLCUT_RT {
  countAsTried(view.present, view.chatter);
  if (lobesKnown_ && ranges_ == 0) {
    return {{},
            {ReasonCode::NoStableSpeed,
             {1e3 * depth_.value, 1e3 * deepestDepth_.value, deepestSpeed_.value, view.chatter.value}}};
  }
  const NextSpeed known = fromLobes(view);
  return known.speed.value > 0.0 ? known : fromRule(view);
}

void PocketSearch::countAsTried(Rpm speed, Hertz chatter) STILLCUT_RT {
  const bool again = tried_ > 0 && std::abs((failure_[tried_ - 1].speed - speed).value) < kSmallestMove * speed.value;
  if (again) {
    failure_[tried_ - 1] = {speed, chatter};
  } else if (tried_ < kTried) {
    failure_[tried_++] = {speed, chatter};
  }
}

bool PocketSearch::triedWithin(Rpm speed, double share) const STILLCUT_RT {
  return std::any_of(failure_.begin(), failure_.begin() + static_cast<std::ptrdiff_t>(tried_),
                     [&](const Failure& f) { return std::abs((f.speed - speed).value) < share * speed.value; });
}

bool PocketSearch::wasHeard(Rpm speed) const STILLCUT_RT {
  return triedWithin(speed, kSmallestMove);
}

bool PocketSearch::wasTried(Rpm speed, int waves) const STILLCUT_RT {
  return triedWithin(speed, std::max(kSmallestMove, kSamePlace / (waves + 1)));
}

int PocketSearch::pocketOf(Hertz chatter, Rpm speed) const STILLCUT_RT {
  const double waves = chatter / toothPassing(speed, teeth_);
  const double whole = std::floor(waves), part = waves - whole;
  if (!std::isfinite(waves) || part <= 0.5) return wavesBetweenTeeth(chatter, teeth_, speed);
  const double own = waves / (1.0 + kUsualDamping / std::tan(std::numbers::pi * (part - 0.5)));
  return static_cast<int>(std::clamp(std::max(whole, std::round(own)), 1.0, 1e6));
}

NextSpeed PocketSearch::fromLobes(const SearchView& view) const STILLCUT_RT {
  const Rpm rule = speedForWaves(view.chatter, teeth_, pocketOf(view.chatter, view.present));
  NextSpeed best;
  double nearest = 0.0;
  for (std::size_t i = 0; i < ranges_; ++i) {
    const StableSpeeds::Range& range = range_[i];
    const Rpm low = std::max(range.from, view.reach.low);
    const Rpm high = std::min(range.to, view.reach.high);
    const Rpm room = (high - low) * kInside;
    if (!(room.value > 0.0)) continue;
    // The rule's target where it is well inside, the place that carries most where it is not.
    const bool inside = rule > low + room && rule < high - room;
    const Rpm speed = inside ? rule : std::clamp(range.best, low + room, high - room);
    if (wasTried(speed, wavesBetweenTeeth(view.chatter, teeth_, speed))) continue;
    const double distance = std::abs((speed - view.present).value);
    if (best.speed.value > 0.0 && distance >= nearest) continue;
    nearest = distance;
    best = {speed, {ReasonCode::PocketByLobes, {speed.value, low.value, high.value, view.chatter.value}}};
  }
  return best;
}

// The nearest other speed that chattered, no farther than the next pocket, on the side to which the present one points,
// and which points back, by the same mode or by another: what is stable for both lies between. nullptr: none.
const PocketSearch::Failure* PocketSearch::across(const SearchView& view, int waves) const STILLCUT_RT {
  const double way = (speedForWaves(view.chatter, teeth_, waves) - view.present).value;
  const Failure* nearest = nullptr;
  double least = view.present.value / (waves + 1);
  for (std::size_t i = 0; i + 1 < tried_; ++i) {
    const Failure& f = failure_[i];
    const double distance = (f.speed - view.present).value;
    if (distance * way <= 0.0 || wayFrom(f) * way >= 0.0 || std::abs(distance) > least) continue;
    least = std::abs(distance);
    nearest = &f;
  }
  return nearest;
}

// Which way its own chatter points, and how far [rev/min].
double PocketSearch::wayFrom(const Failure& failure) const STILLCUT_RT {
  const int waves = pocketOf(failure.chatter, failure.speed);
  return (speedForWaves(failure.chatter, teeth_, waves) - failure.speed).value;
}

// Where the rule points at a pocket's centre. Two speeds that point at each other have it between them (two modes, or a
// step that went too far). From the upper one the rule's own step is taken where it stays between: above a pocket the
// frequency is near the tool's own, below it is far above. From the lower one: regula falsi. Two that point the same
// way give where the rule's own sequence ends. One gives its next member.
PocketSearch::Centre PocketSearch::centreOf(const SearchView& view, int waves) const STILLCUT_RT {
  const Rpm next = speedForWaves(view.chatter, teeth_, waves);
  if (const Failure* other = across(view, waves)) {
    const double way = (next - view.present).value;
    if (way < 0.0 && next > other->speed + (view.present - other->speed) * kBetween) return {next, true};
    const double back = wayFrom(*other);
    const double share = std::clamp(way / (way - back), kBetween, 1.0 - kBetween);
    return {view.present + (other->speed - view.present) * share, true};
  }
  if (tried_ < 2) return {next, false};
  const Failure& before = failure_[tried_ - 2];
  const Rpm predicted = speedForWaves(before.chatter, teeth_, waves);
  const bool sameRow = std::abs((predicted - view.present).value) < kSamePlace / (waves + 1) * view.present.value ||
                       pocketOf(before.chatter, before.speed) == waves;
  if (!sameRow) return {next, false};
  const double repeats = (predicted - next) / (before.speed - view.present);
  if (!(repeats > 0.0) || repeats > kSteepest) return {next, false};
  const double halfway = 0.5 * view.present.value / (waves + 1);  // to the neighbouring pocket
  const double step = (next - view.present).value / (1.0 - repeats);
  return {view.present + Rpm(std::clamp(step, -halfway, halfway)), false};
}

NextSpeed PocketSearch::fromRule(const SearchView& view) const STILLCUT_RT {
  const int here = pocketOf(view.chatter, view.present);
  const Centre centre = centreOf(view, here);
  const Rpm first = centre.speed;
  const auto waves = static_cast<double>(here);
  if (view.reach.contains(first) && (centre.between ? !wasHeard(first) : !wasTried(first, here))) {
    return {first, {ReasonCode::CentreOfNextPocket, {first.value, waves, view.chatter.value, view.present.value}}};
  }
  // A pocket reaches beyond its centre, and its edge is nearer than the next one.
  const Rpm edge = view.reach.high;
  const double left = view.chatter / toothPassing(edge, teeth_) - waves;
  if (first > edge && left <= kQuarterWave && !wasTried(edge, here)) {
    return {edge, {ReasonCode::QuarterWave, {edge.value, waves + left, view.chatter.value, view.present.value}}};
  }
  // The rule's own speed may be out of reach, or have chattered.
  const bool reached = view.reach.contains(first);
  const auto whyThere = [&](Rpm speed, int candidate, Hertz heard) -> Reason {
    const auto between = static_cast<double>(candidate);
    if (reached) return {ReasonCode::CentreOfNextPocket, {speed.value, between, heard.value, view.present.value}};
    return {ReasonCode::NextPocketInRange, {speed.value, between, first.value, heard.value}};
  };
  NextSpeed best;
  best.reason = {ReasonCode::TargetOutOfRange,
                 {first.value, view.reach.low.value, view.reach.high.value, view.chatter.value}};
  if (reached) best.reason = {ReasonCode::AlreadyThere, {first.value, view.chatter.value}};
  for (std::size_t i = tried_; i-- > 0;) {
    const Hertz heard = failure_[i].chatter;
    const int p = pocketOf(heard, view.present);
    for (const int candidate : {p, p - 1, p + 1, p - 2, p + 2}) {
      if (candidate < 1) continue;
      const Rpm speed = speedForWaves(heard, teeth_, candidate);
      if (!view.reach.contains(speed) || wasTried(speed, candidate)) continue;
      const bool nearer = best.speed.value <= 0.0 ||
                          std::abs((speed - view.present).value) < std::abs((best.speed - view.present).value);
      if (!nearer) continue;
      best = {speed, whyThere(speed, candidate, heard)};
    }
    if (best.speed.value > 0.0) break;  // the newest frequency decides; older ones only where it leaves nothing
  }
  return best;
}

}  // namespace stillcut::control
