#include "core/detect/order_growth.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <span>

#include "core/detect/order_pole.h"

namespace stillcut::detect {
namespace {

// Of the other orders' energy: 3 % of their amplitude where the class is known to be chatter's, 20 % elsewhere.
constexpr double kSmallest = 1e-3;
constexpr double kSmallestBeside = 0.04;
// What grows by itself (order_pole.h): 5 % of the others' amplitude, ...
constexpr double kSmallestAlone = 2.5e-3;
constexpr double kGrownAlone = 2.0;  // ... energy over that of its floor, ...
constexpr int kAloneTimes = 9;       // ... found so often on end: four turns
constexpr int kWindowHalfTurns = 2 * (static_cast<int>(OrderPole::kTurns) + 2);
constexpr double kOtherSpeed = 3e-3;    // a seventh of the width of a mode damped by 1 %
constexpr double kByOtherSpeed = 1.35;  // ... on whose flank 1 / (d^2 + z^2) energy changes by exp(0.3 % / z) at most
constexpr double kDriftTurns = 6.0;     // memory of the phase
constexpr double kLeastDrift = 0.012;   // orders: what a spindle known to 0.1 % leaves at the twelfth order
constexpr double kSteady = 0.8;         // of the power, that turns as one
constexpr double kStill = 0.01;         // orders
constexpr double kNearlyStill = 0.1;    // ... while it grows out of its noise
constexpr double kLeaks = 1.0 / 12.0;   // the sum of 1 / (2 pi d)^2 over all d, up and down
constexpr double kLeastOthers = 0.1;    // what leaks is known no better
constexpr double kLouder = 4.0;         // in energy, of what it was
// In energy. A mode amplifies runout by 1 / (1 - depth / limit), from half of the limit to nine tenths of it fivefold,
// to within a twentieth tenfold. What has become more is no runout: by the first at the rate of an instability, by the
// second faster than a mode so near to its limit follows any load.
constexpr double kBeyond = 25.0;
constexpr double kFarBeyond = 100.0;
constexpr double kMostOfAll = 1.0;  // all other orders together, in energy: what a line has that locked to its order
constexpr double kWholeTurn = 1.0;
constexpr double kSpeedDoubts = 2.0;
constexpr double kOutgrowDoubts = 1.5;  // where its share has grown as well
constexpr double kQuarterTurn = 0.25;   // a mode turns a forced vibration by no more as it comes near its limit
constexpr double kFloorSeconds = 10.0;  // in which a floor that rises by time doubles
constexpr double kFallTurns = 10.0;
constexpr double kNewLoadTurns = 24.0;  // grown for so long and standing still: a new load
constexpr double kStays = 0.5;          // in energy, of what it began at: noise does not end it

}  // namespace

void OrderGrowth::prepare(int teeth, int eta, int harmonics) {
  teeth_ = teeth;
  eta_ = eta;
  learnedAt_ = {};
  classes_.assign(static_cast<std::size_t>(std::max(teeth, 0) / 2), {});
  orders_.assign(static_cast<std::size_t>(std::max(harmonics, 0)), {});
  now_.assign(orders_.size(), {});
  stretches_.prepare(teeth, orders_.size());
  relearn();
}

void OrderGrowth::setEvidence(double evidence) noexcept {
  for (Class& c : classes_) c.onset.prepare({flips(c) ? kSmallest : kSmallestBeside, evidence});
}

void OrderGrowth::relearn(Class& c) noexcept {
  c.onset.reset();
  c.counts = c.own = c.unstable = c.doubles = c.dwarfs = false;
  c.aloneTimes = c.aloneOrder = 0;
  c.alone = 0.0;
  c.alarmTurns = c.turned = c.turnedBy = c.slow = c.outgrown = c.outgrownBy = 0.0;
}

void OrderGrowth::relearn() noexcept {
  for (Class& c : classes_) relearn(c);
  order_ = 0.0;
  doubling_ = false;
}

void OrderGrowth::setSpindle(Hertz spindle) noexcept {
  for (Class& c : classes_) c.onset.setSpindle(spindle);
  stretches_.setSpindle(spindle);
  if (grown() || std::abs(spindle.value - learnedAt_.value) < kOtherSpeed * spindle.value) return;
  const bool stepped = std::abs(spindle.value - learnedAt_.value) > 2.0 * kOtherSpeed * spindle.value;
  learnedAt_ = spindle;
  halfTurnsThere_ = 0;
  for (Class& c : classes_) {
    if (stepped || flips(c)) {
      relearn(c);
      continue;
    }
    const double raised = c.onset.raise(kByOtherSpeed);
    c.slow *= raised;
    c.slowEnergy *= raised;
  }
}

bool OrderGrowth::flips(const Class& c) const noexcept {
  return teeth_ % 2 == 0 && &c == &classes_.back();
}

void OrderGrowth::follow(const EnergyChain& chain, int channel) noexcept {
  constexpr double kRate = 1.0 / kDriftTurns;
  const std::size_t count = std::min(static_cast<std::size_t>(chain.active()), orders_.size());
  chain.amplitudes(channel, std::span(now_).first(count));
  stretches_.endTurn(std::span(now_).first(count));
  for (std::size_t i = 0; i < count; ++i) {
    Order& o = orders_[i];
    const std::complex<double> now = now_[i];
    o.product += kRate * (now * std::conj(o.before) - o.product);
    o.power += kRate * (std::sqrt(std::norm(now) * std::norm(o.before)) - o.power);
    o.past += kRate * (std::norm(o.before) - o.past);
    o.before = now;
  }
}

void OrderGrowth::followStretches() noexcept {
  for (std::size_t i = 0; i < classes_.size(); ++i) {
    Class& c = classes_[i];
    const int rest = static_cast<int>(i) + 1;
    c.own = stretches_.ownGrowth(rest);
    const bool unstable = flips(c) ? stretches_.unstableGrowth(rest) : stretches_.lockedGrowth(rest);
    c.unstable = c.onset.evidence() > 0.0 && (c.unstable || unstable);
  }
}

// Teeth that leave the material multiply what the orders hold with itself: of shares s of runout on the rests a and b
// they make as much as s_a s_b on a + b and a - b.
double OrderGrowth::products(const Class& c) const noexcept {
  const int rest = static_cast<int>(&c - classes_.data()) + 1;
  double most = 0.0;
  for (int a = 1; a <= static_cast<int>(classes_.size()); ++a) {
    for (const int other : {rest - a, rest + a}) {
      const int b = std::min(std::abs(other), teeth_ - std::abs(other));
      if (b < 1 || a == rest || b == rest) continue;
      const auto share = [&](int r) { return this->share(classes_[static_cast<std::size_t>(r - 1)]); };
      most = std::max(most, share(a) * share(b));
    }
  }
  return most;
}

// A share that has grown: is it more than runout that the engagement changes, that a mode amplifies, or that teeth
// multiply which leave the material?
bool OrderGrowth::begins(const Class& c) const noexcept {
  const double now = share(c);
  if (now < products(c)) return false;
  const bool turns = this->turns(c.order) && (!stretches_.engagementChanges() || std::abs(c.turnedBy) > kQuarterTurn);
  if (c.own && turns && !explained(c)) return true;
  if (!flips(c)) return c.unstable && now > std::max(kMostOfAll, kBeyond * c.onset.floor());
  return c.unstable || (c.onset.floor() < kSmallestBeside && now > kFarBeyond * c.onset.floor() &&
                        stretches_.growsOn(teeth_ / 2) && !stretches_.otherEngagement());
}

void OrderGrowth::endHop(const EnergyChain& chain, int channel) noexcept {
  if (classes_.empty()) return;
  hop_ = (hop_ + 1) % kHopsPerTurn;
  if (hop_ == 0) {
    follow(chain, channel);
    followStretches();
  }
  const std::span<const double> powers = chain.harmonicPowers(channel);
  const std::span<const double> weights = chain.orderWeights(eta_);
  weightedAll_ = chain.forced(channel, eta_);
  all_ = chain.forced(channel, 0);
  active_ = chain.active();
  for (int rest = 1; 2 * rest <= teeth_; ++rest) {
    double power = 0.0;
    double weighted = 0.0;
    Class& c = classes_[static_cast<std::size_t>(rest - 1)];
    c.strongest = 0.0;
    const int over = teeth_ - 2 * rest;  // from kZ + rest to (k + 1) Z - rest; 0: they are the same
    for (int n = rest, step = over > 0 ? over : teeth_; n <= chain.active(); n += step) {
      if (over > 0 && n > rest) step = teeth_ - step;
      const auto i = static_cast<std::size_t>(n - 1);
      power += powers[i];
      weighted += powers[i] * weights[i];
      if (powers[i] <= c.strongest) continue;
      c.strongest = powers[i];
      c.order = n;
    }
    c.power = power;
    c.weighted = weighted;
  }
}

double OrderGrowth::drift(int order) const noexcept {
  if (order < 1 || order > static_cast<int>(orders_.size())) return 0.0;
  return std::arg(orders_[static_cast<std::size_t>(order - 1)].product) / kTwoPi;
}

bool OrderGrowth::turns(int order) const noexcept {
  if (order < 1 || order > static_cast<int>(orders_.size())) return false;
  const Order& o = orders_[static_cast<std::size_t>(order - 1)];
  return std::abs(o.product) > kSteady * o.power && std::abs(drift(order)) > kLeastDrift;
}

// Period doubling does; what a line half way between two orders leaves on both turns by half a turn per turn.
bool OrderGrowth::standsStill(const Class& c) const noexcept {
  return std::abs(drift(c.order)) < kNearlyStill;
}

// Does the strongest order change by no more than the load may make it? What turns then is the phase of a mode that
// comes nearer to its limit.
bool OrderGrowth::explained(const Class& c) const noexcept {
  const auto i = static_cast<std::size_t>(c.order - 1);
  if (c.order < 1 || i >= orders_.size() || !(orders_[i].past > 0.0)) return false;
  return std::abs(1.0 - orders_[i].product / orders_[i].past) < byLoad_;
}

// Period doubling has its own measure (order_stretches.h): it stands still, where runout of alternate teeth does.
bool OrderGrowth::mayGrowByItself(const Class& c) const noexcept {
  return !flips(c) && c.onset.learned() && c.strongest > kLeastOfClass * c.power && share(c) > kSmallestAlone &&
         c.power > kGrownAlone * c.onset.floorEnergy() && !stretches_.engagementChanges();
}

bool OrderGrowth::growsAlone(Class& c, NewLine& vibration, int channel, Hertz spindle) const noexcept {
  OrderPole now;
  return mayGrowByItself(c) && OrderPole::mayGrow(vibration, channel, c.order, spindle) &&
         now.fit(vibration, channel, {teeth_, active_}, c.order, spindle) && now.growsByItself();
}

void OrderGrowth::endHalfTurn(NewLine& vibration, int channel, Hertz spindle, bool judged) noexcept {
  halfTurnsThere_ = std::min(halfTurnsThere_ + 1, kWindowHalfTurns);
  for (Class& c : classes_) {
    const double share = this->share(c);
    const bool stays = c.alone > 0.0 && share > c.alone / kLouder;
    const bool found =
        judged && !stays && halfTurnsThere_ == kWindowHalfTurns && growsAlone(c, vibration, channel, spindle);
    if (c.order != c.aloneOrder) c.aloneTimes = 0;
    c.aloneOrder = c.order;
    c.aloneTimes = found ? c.aloneTimes + 1 : 0;
    c.alone = stays || c.aloneTimes >= kAloneTimes ? std::max(c.alone, share) : 0.0;
  }
}

// Of the other orders' energy, what is the class's own. Of a line that changes by the part c from turn to turn the
// filter of two turns leaves c, and every order d away from it takes c / (2 pi d) of that line.
double OrderGrowth::leak(const Class& c) const noexcept {
  const auto i = static_cast<std::size_t>(c.order - 1);
  if (c.order < 1 || i >= orders_.size() || !(orders_[i].past > 0.0)) return 0.0;
  const Order& o = orders_[i];
  if (std::abs(o.product) < kSteady * o.power) return 0.0;
  return kLeaks * std::norm(1.0 - o.product / o.past) * c.strongest;
}

double OrderGrowth::share(const Class& c) const noexcept {
  const double others = all_ - c.power;
  return others > 0.0 ? c.power / std::max(others - leak(c), kLeastOthers * others) : 0.0;
}

// Side lines of one line at kZ + rest + e stand at kZ - rest - e: they turn the other way.
double OrderGrowth::sense(const Class& c) const noexcept {
  return c.order % teeth_ == static_cast<int>(&c - classes_.data()) + 1 ? 1.0 : -1.0;
}

void OrderGrowth::followTurning(Class& c, double turns, double speedDoubt) const noexcept {
  const double drifts = drift(c.order);
  const bool louder = c.onset.learned() && c.power > kLouder * c.onset.floorEnergy() && share(c) > kSmallestBeside;
  const bool one = c.strongest > kLeastOfClass * c.power && this->turns(c.order);
  const bool on = louder && one && std::abs(drifts) > kSpeedDoubts * c.order * speedDoubt;
  const bool turning = one && c.onset.evidence() > 0.0;
  c.turnedBy = turning ? c.turnedBy + sense(c) * drifts * turns : 0.0;
  c.turned = on && drifts * c.turned >= 0.0 ? c.turned + drifts * turns : 0.0;
}

// A slow spindle gives chatter so few turns to grow in that it becomes its own floor, and so does chatter that grows
// slowly. Where it turns against the spindle as well, faster than the speed is in doubt, or doubles and is more than
// runout becomes, it is held against a floor that rises by time alone.
bool OrderGrowth::outgrew(Class& c, double turns, bool learn, double speedDoubt) const noexcept {
  const double now = share(c);
  if (!c.onset.learned()) return false;
  const double least = std::max(kLeastDrift, kOutgrowDoubts * c.order * speedDoubt);
  const bool one = c.strongest > kLeastOfClass * c.power && this->turns(c.order);
  const bool own = one && !explained(c) && std::abs(drift(c.order)) > least;
  const bool on = own && now > std::max(kLouder * c.slow, kSmallestBeside);
  const double far = std::max({kFarBeyond * c.slow, kSmallest, products(c)});
  const bool grows = c.slow < kSmallestBeside && stretches_.growsOn(teeth_ / 2) && !stretches_.otherEngagement();
  c.doubles = flips(c) && standsStill(c) && now > (c.doubles ? kStays * far : far) && (c.doubles || grows);
  const double beyond = std::max(kFarBeyond * c.slow, kMostOfAll);
  const double stays = c.dwarfs ? kStays : 1.0;
  c.dwarfs = !flips(c) && now > stays * beyond && c.power > stays * kFarBeyond * c.slowEnergy;
  c.outgrown = on ? c.outgrown + turns : 0.0;
  c.outgrownBy = on ? c.outgrownBy + sense(c) * drift(c.order) * turns : 0.0;
  const double rise = std::min(now / c.slow - 1.0, 1.0) / (kFloorSeconds * learnedAt_.value);
  if (learn && now < c.slow) {
    c.slow += turns / kFallTurns * (now - c.slow);
    c.slowEnergy += turns / kFallTurns * (c.power - c.slowEnergy);
  }
  if (learn && now > c.slow && learnedAt_.value > 0.0) {
    c.slow *= 1.0 + turns * rise;
    c.slowEnergy *= 1.0 + turns * rise;
  }
  if (c.doubles || c.dwarfs) return true;
  return c.outgrown > kDriftTurns && std::abs(c.outgrownBy) > kQuarterTurn;
}

// An engagement that has stood for so long with nothing growing in it is the one that the floors are of by now.
void OrderGrowth::followEngagement(double turns, bool learn) noexcept {
  const bool quiet =
      learn && !stretches_.engagementChanges() && std::all_of(classes_.begin(), classes_.end(), [](const Class& c) {
        return c.onset.learned() && c.onset.evidence() == 0.0 && c.outgrown == 0.0;
      });
  standingTurns_ = quiet ? standingTurns_ + turns : 0.0;
  if (standingTurns_ < kNewLoadTurns) return;
  standingTurns_ = 0.0;
  stretches_.learnEngagement();
}

void OrderGrowth::test(double turns, bool learn, double speedDoubt) noexcept {
  followEngagement(turns, learn);
  order_ = 0.0;
  doubling_ = false;
  double strongest = 0.0;
  for (Class& c : classes_) {
    followTurning(c, turns, speedDoubt);
    c.onset.update(share(c), turns, learn && c.turned == 0.0, c.power);
    const bool turned = std::abs(c.turned) > kWholeTurn;
    const bool grown = c.onset.alarm();
    if (c.onset.learned() && !(c.slow > 0.0)) {
      c.slow = c.onset.floor();
      c.slowEnergy = c.onset.floorEnergy();
      stretches_.learnEngagement();
    }
    const bool outgrown = outgrew(c, turns, learn, speedDoubt);
    c.counts = turned || outgrown || c.alone > 0.0 || (grown && (c.counts || begins(c)));
    c.alarmTurns = grown && !c.counts ? c.alarmTurns + turns : 0.0;
    if (learn && c.alarmTurns > kNewLoadTurns) {
      c.onset.reset();
      c.outgrown = c.outgrownBy = 0.0;
      if (flips(c)) c.slow = 0.0;  // ... and its engagement is learned with it
    }
    if (!c.counts || c.strongest < kLeastOfClass * c.power || c.strongest <= strongest) continue;
    strongest = c.strongest;
    const double drifts = drift(c.order);
    doubling_ = flips(c) && std::abs(drifts) < kStill;
    order_ = c.order + (doubling_ ? 0.0 : drifts);
  }
}

bool OrderGrowth::grown() const noexcept {
  return std::any_of(classes_.begin(), classes_.end(), [](const Class& c) { return c.counts; });
}

double OrderGrowth::severity() const noexcept {
  if (!(weightedAll_ > 0.0)) return 0.0;
  double sum = 0.0;
  for (const Class& c : classes_) {
    const double now = share(c);
    if (!c.counts || !(now > 0.0)) continue;
    const double before =
        std::abs(c.turned) > kWholeTurn ? c.onset.floorEnergy() / c.power : std::min(c.onset.floor(), c.slow) / now;
    sum += c.weighted / weightedAll_ * std::max(0.0, 1.0 - before);
  }
  return sum;
}

}  // namespace stillcut::detect
