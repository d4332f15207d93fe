#include "core/detect/caliskan/order_growth.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <span>

#include "core/detect/growth/order_pole.h"

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
constexpr double kLeastOfClass = 0.4;   // of its power, that one order holds
constexpr double kOtherSpeed = 3e-3;    // a seventh of the width of a mode damped by 1 %
constexpr double kByOtherSpeed = 1.35;  // ... on whose flank 1 / (d^2 + z^2) energy changes by exp(0.3 % / z) at most
constexpr double kStill = 0.01;         // orders
constexpr double kNearlyStill = 0.1;    // ... while it grows out of its noise
constexpr double kLeastOthers = 0.1;    // what leaks is known no better
constexpr double kLouder = 4.0;         // in energy, of what it was
// In energy. A mode amplifies runout by 1 / (1 - depth / limit), from half of the limit to nine tenths of it fivefold,
// to within a twentieth tenfold. What has become more is no runout: by the first at the rate of an instability, by the
// second faster than a mode so near to its limit follows any load, or by itself as well as against all else.
constexpr double kBeyond = 25.0;
constexpr double kFarBeyond = 100.0;
constexpr double kMostOfAll = 1.0;  // all other orders together, in energy: what a line has that locked to its order
constexpr double kDwarfed = 4.0;    // ... and they have half its amplitude at most
constexpr double kWholeTurn = 1.0;
constexpr double kSpeedDoubts = 2.0;
constexpr double kApartDoubts = 1.5;    // where its share has grown as well
constexpr double kQuarterTurn = 0.25;   // a mode turns a forced vibration by no more as it comes near its limit
constexpr double kNewLoadTurns = 24.0;  // grown for so long and standing still: a new load
constexpr double kSettlesTurns = 1.0;   // asked twice as often
constexpr double kMostHeld = 48.0;      // turns: what settles has settled by then; full chatter stays as large as it is
constexpr double kStays = 0.5;          // in energy, of what it began at: noise does not end it

}  // namespace

void OrderGrowth::prepare(int teeth, int eta, int harmonics) {
  teeth_ = teeth;
  eta_ = eta;
  spindle_ = learnedAt_ = {};
  restart();
  classes_.assign(static_cast<std::size_t>(std::max(teeth, 0) / 2), {});
  for (std::size_t i = 0; i < classes_.size(); ++i) {
    classes_[i].rest = static_cast<int>(i) + 1;
    classes_[i].flips = 2 * classes_[i].rest == teeth;
  }
  now_.assign(static_cast<std::size_t>(std::max(harmonics, 0)), {});
  turns_.prepare(harmonics);
  stretches_.prepare(teeth, now_.size());
  relearn();
}

void OrderGrowth::setEvidence(double evidence) {
  for (Class& c : classes_) c.onset.prepare({c.flips ? kSmallest : kSmallestBeside, evidence});
}

void OrderGrowth::relearn(Class& c) {
  c.onset.reset();
  c.timed.reset();
  c.counts = c.own = c.unstable = c.doubles = c.dwarfs = false;
  c.alarmTurns = c.turned = c.turnedBy = c.apartTurns = c.apartBy = c.settles = c.held = 0.0;
  c.alone = {};
}

void OrderGrowth::relearn() {
  for (Class& c : classes_) relearn(c);
  stretches_.forget();
  order_ = 0.0;
  doubling_ = false;
}

void OrderGrowth::setSpindle(Hertz spindle) {
  for (Class& c : classes_) c.onset.setSpindle(spindle);
  stretches_.setSpindle(spindle);
  spindle_ = spindle;
  if (grown() || std::abs(spindle.value - learnedAt_.value) < kOtherSpeed * spindle.value) return;
  const bool stepped = std::abs(spindle.value - learnedAt_.value) > 2.0 * kOtherSpeed * spindle.value;
  learnedAt_ = spindle;
  halfTurnsThere_ = 0;
  for (Class& c : classes_) {
    if (stepped || c.flips) {
      relearn(c);
      continue;
    }
    c.timed.raise(c.onset.raise(kByOtherSpeed));
  }
}

void OrderGrowth::endHop(const EnergyChain& chain, int channel) {
  if (classes_.empty()) return;
  hop_ = (hop_ + 1) % kHopsPerTurn;
  if (hop_ == 0) {
    const std::size_t count = std::min(static_cast<std::size_t>(chain.active()), now_.size());
    const auto now = std::span(now_).first(count);
    chain.amplitudes(channel, now);
    stretches_.endTurn(now);
    turns_.endTurn(now);
    pull_.endTurn(spindle_, stretches_.engagementChanges());
    followStretches();
  }
  const std::span<const double> powers = chain.harmonicPowers(channel);
  const std::span<const double> weights = chain.orderWeights(eta_);
  weightedAll_ = chain.forced(channel, eta_);
  all_ = chain.forced(channel, 0);
  active_ = chain.active();
  for (Class& c : classes_) {
    c.power = c.weighted = c.strongest = 0.0;
    const int over = teeth_ - 2 * c.rest;  // from kZ + rest to (k + 1) Z - rest; 0: they are the same
    for (int n = c.rest, step = over > 0 ? over : teeth_; n <= chain.active(); n += step) {
      if (over > 0 && n > c.rest) step = teeth_ - step;
      const auto i = static_cast<std::size_t>(n - 1);
      c.power += powers[i];
      c.weighted += powers[i] * weights[i];
      if (powers[i] <= c.strongest) continue;
      c.strongest = powers[i];
      c.order = n;
    }
  }
}

void OrderGrowth::followStretches() {
  for (Class& c : classes_) {
    c.own = stretches_.ownGrowth(c.rest);
    const bool unstable = c.flips ? stretches_.unstableGrowth(c.rest) : stretches_.lockedGrowth(c.rest);
    c.unstable = c.onset.evidence() > 0.0 && (c.unstable || unstable);
  }
}

double OrderGrowth::share(const Class& c) const {
  const double others = all_ - c.power;
  const double leak = turns_.leak(c.order, c.strongest);
  return others > 0.0 ? c.power / std::max(others - leak, kLeastOthers * others) : 0.0;
}

// A class that holds noise in a narrow band, or a line that beats, is now and then much louder than it mostly is.
double OrderGrowth::muchLouder(const Class& c) {
  return kLouder * (1.0 + 1.0 / c.onset.shape());
}

// Does one order stand out of it, as a mode does?
bool OrderGrowth::isOne(const Class& c) {
  return c.strongest > kLeastOfClass * c.power;
}

// Side lines of one line at kZ + rest + e stand at kZ - rest - e: they turn the other way.
double OrderGrowth::sense(const Class& c) const {
  return c.order % teeth_ == c.rest ? 1.0 : -1.0;
}

// Of its strongest order, turns per turn, but what a moving arc pulls the tracked speed by. What is known to be chatter
// turns by itself, whatever the arc does.
double OrderGrowth::ownDrift(const Class& c) const {
  const double drift = turns_.drift(c.order);
  return c.counts ? drift : pull_.beyond(c.order, drift);
}

bool OrderGrowth::turnsByItself(const Class& c) const {
  return turns_.turns(c.order) && std::abs(ownDrift(c)) > OrderTurns::kLeastDrift;
}

// It turns, and nobody knows whether by itself: what it has turned by so far stands.
bool OrderGrowth::pulled(const Class& c) const {
  return isOne(c) && turns_.turns(c.order) && !turnsByItself(c);
}

// Does the strongest order change by no more than the load may make it? What turns then is the phase of a mode that
// comes nearer to its limit.
bool OrderGrowth::explained(const Class& c) const {
  return turns_.change(c.order) < byLoad_;
}

// Teeth that leave the material multiply what the orders hold with itself: of shares s of runout on the rests a and b
// they make as much as s_a s_b on a + b and a - b.
double OrderGrowth::products(const Class& c) const {
  double most = 0.0;
  for (const Class& a : classes_) {
    for (const int other : {c.rest - a.rest, c.rest + a.rest}) {
      const int b = std::min(std::abs(other), teeth_ - std::abs(other));
      if (b < 1 || a.rest == c.rest || b == c.rest) continue;
      most = std::max(most, share(a) * share(classes_[static_cast<std::size_t>(b - 1)]));
    }
  }
  return most;
}

// A share that has grown: is it more than runout that the engagement changes, that a mode amplifies, or that teeth
// multiply which leave the material?
bool OrderGrowth::begins(const Class& c) const {
  const double now = share(c);
  if (now < products(c)) return false;
  const bool learnedArc = !stretches_.engagementChanges() && !stretches_.otherEngagement();
  const bool turns = turnsByItself(c) && (learnedArc || std::abs(c.turnedBy) > kQuarterTurn);
  if (c.own && turns && !explained(c)) return true;
  if (!c.flips) return c.unstable && now > std::max(kMostOfAll, kBeyond * c.onset.floor());
  return c.unstable || (c.onset.floor() < kSmallestBeside && now > kFarBeyond * c.onset.floor() &&
                        stretches_.growsOn(c.rest) && !stretches_.otherEngagement());
}

void OrderGrowth::followTurning(Class& c, double turns, double speedDoubt) const {
  if (pulled(c)) return;
  const double drift = ownDrift(c);
  const bool louder =
      c.onset.learned() && c.power > muchLouder(c) * c.onset.floorEnergy() && share(c) > kSmallestBeside;
  const bool one = isOne(c) && turnsByItself(c);
  const bool on = louder && one && std::abs(drift) > kSpeedDoubts * c.order * speedDoubt;
  const bool turning = one && c.onset.evidence() > 0.0;
  c.turnedBy = turning ? c.turnedBy + sense(c) * drift * turns : 0.0;
  c.turned = on && drift * c.turned >= 0.0 ? c.turned + drift * turns : 0.0;
}

// A slow spindle gives chatter so few turns to grow in that it becomes its own floor, and so does chatter that grows
// slowly. It is held against a floor that rises by time alone where it turns against the spindle as well, faster than
// the speed is in doubt, where it doubles and is more than runout becomes, or where it is most of the vibration.
void OrderGrowth::followTimed(Class& c, double turns, bool learn, double speedDoubt) const {
  const double now = share(c);
  const double drift = ownDrift(c);
  const double least = std::max(OrderTurns::kLeastDrift, kApartDoubts * c.order * speedDoubt);
  const bool one = isOne(c) && turnsByItself(c);
  const bool apart = one && !explained(c) && std::abs(drift) > least &&
                     now > std::max(muchLouder(c) * c.timed.share(), kSmallestBeside);
  if (!pulled(c)) {
    c.apartTurns = apart ? c.apartTurns + turns : 0.0;
    c.apartBy = apart ? c.apartBy + sense(c) * drift * turns : 0.0;
  }
  if (c.flips)
    c.doubles = doubles(c);
  else
    c.dwarfs = dwarfs(c);
  if (learn) c.timed.follow(now, c.power, turns, learnedAt_);
}

// Period doubling stands still. What a line half way between two orders leaves on both turns by half a turn per turn.
bool OrderGrowth::doubles(const Class& c) const {
  const double far = std::max({kFarBeyond * c.timed.share(), kSmallest, products(c)});
  if (std::abs(ownDrift(c)) >= kNearlyStill || share(c) <= (c.doubles ? kStays * far : far)) return false;
  return c.doubles ||
         (c.timed.share() < kSmallestBeside && stretches_.growsOn(c.rest) && !stretches_.otherEngagement());
}

bool OrderGrowth::dwarfs(const Class& c) const {
  const double stays = c.dwarfs ? kStays : 1.0;
  const double far = stays * kFarBeyond;
  return c.power > stays * kDwarfed * (all_ - c.power) && share(c) > far * c.timed.share() &&
         c.power > far * c.timed.energy();
}

bool OrderGrowth::mayFit(const Class& c) const {
  return halfTurnsThere_ == kWindowHalfTurns && c.onset.learned() && isOne(c) &&
         c.power > kGrownAlone * c.onset.floorEnergy();
}

// Period doubling has its own measure (order_stretches.h): it stands still, where runout of alternate teeth does.
bool OrderGrowth::mayGrowByItself(const Class& c) const {
  return !c.flips && mayFit(c) && share(c) > kSmallestAlone && !stretches_.engagementChanges();
}

// Asked where anything else speaks for chatter: the fit is dear.
bool OrderGrowth::settles(const Class& c, const NewLine& vibration, int channel, Hertz spindle) const {
  const bool suspect =
      c.onset.evidence() > 0.0 || c.turned != 0.0 || c.apartTurns > 0.0 || share(c) > kLouder * c.timed.share();
  OrderPole now;
  return suspect && mayFit(c) && now.fitMoving(vibration, channel, {teeth_, active_}, c.order, spindle) &&
         now.settles(spindle);
}

bool OrderGrowth::growsAlone(const Class& c, const NewLine& vibration, int channel, Hertz spindle) const {
  OrderPole now;
  return mayGrowByItself(c) && OrderPole::mayGrow(vibration, channel, c.order, spindle) &&
         now.fit(vibration, channel, {teeth_, active_}, c.order, spindle) && now.growsByItself();
}

bool OrderGrowth::Alone::stays(double share) const {
  return most > 0.0 && share > most / kLouder;
}

void OrderGrowth::Alone::look(int atOrder, double share, bool found) {
  if (atOrder != order) times = 0;
  order = atOrder;
  times = found ? times + 1 : 0;
  most = stays(share) || times >= kAloneTimes ? std::max(most, share) : 0.0;
}

void OrderGrowth::endHalfTurn(const NewLine& vibration, int channel, Hertz spindle, bool judged) {
  halfTurnsThere_ = std::min(halfTurnsThere_ + 1, kWindowHalfTurns);
  for (Class& c : classes_) {
    const double now = share(c);
    const bool look = judged && !c.alone.stays(now);
    c.alone.look(c.order, now, look && growsAlone(c, vibration, channel, spindle));
    c.settles = !alarming_ && !c.counts && settles(c, vibration, channel, spindle) ? kSettlesTurns : 0.0;
  }
}

// An engagement that has stood for so long with nothing growing in it is the one that the floors are of by now.
void OrderGrowth::followEngagement(double turns, bool learn) {
  const bool quiet =
      learn && !stretches_.engagementChanges() && std::all_of(classes_.begin(), classes_.end(), [](const Class& c) {
        return c.onset.learned() && c.onset.evidence() == 0.0 && c.apartTurns == 0.0;
      });
  standingTurns_ = quiet ? standingTurns_ + turns : 0.0;
  if (standingTurns_ < kNewLoadTurns) return;
  standingTurns_ = 0.0;
  stretches_.learnEngagement();
}

// Chatter that has grown as large as it gets and turns against the spindle settles as well, by the same fit. What
// stands still, as period doubling does, leaves its pole in doubt.
bool OrderGrowth::withheld(const Class& c) {
  return c.settles > 0.0 && (c.flips || c.held < kMostHeld);
}

// What has grown and then stands, without being chatter, is a new load, and its floor is learned anew.
void OrderGrowth::relearnNewLoad(Class& c, double turns, bool learn) {
  if (withheld(c) && !c.flips) return;
  c.alarmTurns = c.onset.alarm() && !c.counts ? c.alarmTurns + turns : 0.0;
  if (!learn || c.alarmTurns <= kNewLoadTurns) return;
  c.onset.reset();
  c.apartTurns = c.apartBy = 0.0;
  if (c.flips) c.timed.reset();  // ... and its engagement is learned with it
}

bool OrderGrowth::counts(const Class& c) const {
  if (withheld(c)) return false;
  if (std::abs(c.turned) > kWholeTurn || c.alone.most > 0.0) return true;
  if (c.onset.alarm() && (c.counts || begins(c))) return true;
  const bool apart = c.apartTurns > OrderTurns::kMemoryTurns && std::abs(c.apartBy) > kQuarterTurn;
  return c.onset.learned() && (apart || c.doubles || c.dwarfs);
}

void OrderGrowth::test(double turns, bool learn, double speedDoubt) {
  followEngagement(turns, learn);
  alarming_ = !learn;
  for (Class& c : classes_) {
    followTurning(c, turns, speedDoubt);
    c.onset.update(share(c), turns, learn && c.turned == 0.0, c.power);
    if (c.onset.learned()) {
      if (!c.timed.learned()) {
        c.timed.learn(c.onset.floor(), c.onset.floorEnergy());
        stretches_.learnEngagement();
      }
      followTimed(c, turns, learn, speedDoubt);
    }
    c.settles = std::max(0.0, c.settles - turns);
    c.held = c.settles > 0.0 ? c.held + turns : 0.0;
    c.counts = counts(c);
    relearnNewLoad(c, turns, learn);
  }
  tell();
}

// Of all that counts, the strongest order.
void OrderGrowth::tell() {
  order_ = 0.0;
  doubling_ = false;
  double strongest = 0.0;
  for (const Class& c : classes_) {
    if (!c.counts || !isOne(c) || c.strongest <= strongest) continue;
    strongest = c.strongest;
    const double drift = turns_.drift(c.order);
    doubling_ = c.flips && std::abs(pull_.beyond(c.order, drift)) < kStill;
    order_ = c.order + (doubling_ ? 0.0 : drift);
  }
}

bool OrderGrowth::grown() const {
  return std::any_of(classes_.begin(), classes_.end(), [](const Class& c) { return c.counts; });
}

double OrderGrowth::severity() const {
  if (!(weightedAll_ > 0.0)) return 0.0;
  double sum = 0.0;
  for (const Class& c : classes_) {
    const double now = share(c);
    if (!c.counts || !(now > 0.0)) continue;
    const double before = std::abs(c.turned) > kWholeTurn ? c.onset.floorEnergy() / c.power
                                                          : std::min(c.onset.floor(), c.timed.share()) / now;
    sum += c.weighted / weightedAll_ * std::max(0.0, 1.0 - before);
  }
  return sum;
}

}  // namespace stillcut::detect
