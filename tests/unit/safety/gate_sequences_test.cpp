// Short hostile lives of a gate with its link and a register that an operator's hand turns: answers late or lost,
// states that lie, authority given and taken, verdicts that are old, clocks that jump, a worker that stalls. Whatever
// happened, then it is calm and authority is Off: the machine is back where its operator had set it, in time.
// The oracle here knows the hand, which the gate does not, and shares no code with the gate.
// STILLCUT_GATE_SEQUENCES: how many; the long run takes a million. STILLCUT_GATE_FIRST: from which number on.
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

#include "core/safety/override_gate.h"
#include "tests/support/hand_and_wire.h"

namespace stillcut::safety {
namespace {

using testing::HandAndWire;

constexpr Duration kStep = std::chrono::milliseconds(20);
constexpr int kHostile = 60;  // steps
// Home from 50 % on both axes by the ramp, a spindle that is waited for, and the way there and back on the wire.
constexpr double kHomeWithin = 1.8;  // [s]

GateLimits tightLimits() {
  GateLimits l;
  l.autoAllowed = true;
  l.overrides.lowestSpeed = l.overrides.lowestFeed = Ratio(0.5);
  l.overrides.highestSpeed = l.overrides.highestFeed = Ratio(1.2);
  l.holdTime = Seconds(0.2);
  l.reengageDelay = Seconds(0.1);
  l.operatorPause = Seconds(0.2);
  l.takeTime = Seconds(0.6);
  l.followTime = Seconds(0.4);
  l.filter = Seconds(0.0);
  return l;
}

class Life {
 public:
  // A hand is believed at the first sight, or, as LinuxCNC's, at the second.
  explicit Life(std::uint64_t seed) : random_(seed), speed_(manners(seed)), feed_(manners(seed)) {
    gate_.prepare(limits_);
    delay_ = milliseconds(0, 40);
  }

  // Empty, or what was broken.
  std::string live() {
    for (int i = 0; i < kHostile; ++i) {
      misfortune();
      if (std::string what = step(); !what.empty()) return what;
    }
    calm();
    press({OperatorAction::SetAuthority, Authority::Off});
    const Instant off = now_;
    while (!home()) {
      if (secondsBetween(off, now_).value > kHomeWithin) return notHome();
      if (std::string what = step(); !what.empty()) return what;
    }
    for (int i = 0; i < 5; ++i) {
      if (std::string what = step(); !what.empty()) return what;
      // What an answer that was late brings about may be sent, if it is the hand's own value.
      if (inForce_ || !stands(speed_) || !stands(feed_)) return "left home again: " + notHome();
    }
    return "";
  }
  long sets = 0, hands = 0, undecidable = 0;

 private:
  static cnc::SharedOverride::Manners manners(std::uint64_t seed) { return {.sightings = seed % 2 == 0 ? 1 : 2}; }
  bool chance(double p) { return std::uniform_real_distribution<double>(0.0, 1.0)(random_) < p; }
  int between(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  Duration milliseconds(int low, int high) { return std::chrono::milliseconds(between(low, high)); }
  void press(const OperatorInput& input) { pressed_ = input; }

  void misfortune() {
    if (chance(0.02)) {
      (chance(0.5) ? speed_ : feed_).turn(chance(0.2) ? 0 : between(0, 140));
      ++hands;
    }
    if (chance(0.02)) delay_ = milliseconds(0, 100);
    if (chance(0.01)) silentFor_ = between(1, 30);
    if (chance(0.01)) stalledFor_ = between(1, 25);
    if (chance(0.01)) jump_ = milliseconds(-400, 400);
    if (chance(0.02)) lie_ = between(1, 5);
    if (chance(0.03)) oldFor_ = between(1, 40);
    if (chance(0.02)) alarming_ = !alarming_;
    if (chance(0.05)) wish_ = 0.01 * between(40, 140);
    if (chance(0.04)) {
      const auto to = static_cast<Authority>(chance(0.6) ? 2 : between(0, 2));
      press(chance(0.9) ? OperatorInput{OperatorAction::SetAuthority, to}
                        : OperatorInput{chance(0.5) ? OperatorAction::Hold : OperatorAction::EndHold});
    }
    if (chance(0.02)) press({OperatorAction::BackToProgrammed});
    if (chance(0.05)) press({OperatorAction::Accept, Authority::Off, advice_});
  }
  void calm() {
    delay_ = milliseconds(0, 40);
    silentFor_ = stalledFor_ = oldFor_ = lie_ = 0;
  }

  // One turn of the link's thread, and one of the worker's unless it is stalled.
  std::string step() {
    now_ += kStep;
    const bool lost = silentFor_ > 0 && silentFor_-- > 0;
    for (HandAndWire* axis : {&speed_, &feed_}) {
      axis->ask(now_, delay_, lost);
      axis->deliver(now_);
    }
    if (!lost) heard_ = now_;
    std::string what = stalledFor_ > 0 && stalledFor_-- > 0 ? "" : worker();
    if (what.empty()) what = link();
    actual_ += (10000.0 * speed_.shows() * 0.01 - actual_) * 0.6;
    return what;
  }

  MachineState told() {
    MachineState m;
    m.time = heard_;
    m.valid = speed_.link().known() && feed_.link().known();
    m.linkUp = m.programRunning = m.atSpeed = true;
    m.programmedSpeed = Rpm(10000.0);
    m.programmedFeed = fromMmPerMin(1000.0);
    m.operatorSpeed = speed_.link().base();
    m.operatorFeed = feed_.link().base();
    m.speedOverride = Ratio(0.01 * speed_.link().shown());
    m.feedOverride = Ratio(0.01 * feed_.link().shown());
    m.actualSpeed = Rpm(actual_);
    m.endedEngagement = lease_.endedEngagement();
    switch (lie_) {
      case 1:
        m.valid = false;
        break;
      case 2:
        m.linkUp = false;
        break;
      case 3:
        m.overridesEnabled = false;
        break;
      case 4:
        m.programmedSpeed = Rpm(std::numeric_limits<double>::quiet_NaN());
        break;
      case 5:
        m.operatorSpeed = Ratio(-3.0);
        break;
      default:
        break;
    }
    if (lie_ > 0 && chance(0.3)) lie_ = 0;
    return m;
  }

  std::string worker() {
    GateInput in;
    in.now = now_ + std::exchange(jump_, Duration::zero());
    in.dt = Seconds(0.02);
    in.machine = told();
    in.verdict.valid = true;
    in.verdict.state = alarming_ ? CutState::Chatter : CutState::Stable;
    in.verdict.phase = CutPhase::Steady;
    in.verdict.frequency = Hertz(700.0);
    const bool old = oldFor_ > 0 && oldFor_-- > 0;
    if (!old) judged_ = now_;
    in.verdict.time = judged_;
    in.request.time = now_;
    in.request.kind = RequestKind::Set;
    in.request.claimsSpeed = in.request.claimsFeed = true;
    in.request.speed = Rpm(10000.0 * wish_);
    in.request.feed = fromMmPerMin(1000.0 * wish_);
    const std::optional<OperatorInput> pressed = std::exchange(pressed_, std::nullopt);
    if (pressed) in.inputs = {&*pressed, 1};
    const GateOutput out = gate_.step(in);
    advice_ = out.adviceNumber;
    std::string what = judge(in, out, pressed);
    if (out.command) newest_ = out.command;
    return what;
  }

  // What the gate lets out, by what it was told.
  std::string judge(const GateInput& in, const GateOutput& out, const std::optional<OperatorInput>& pressed) {
    if (pressed && (pressed->action == OperatorAction::BackToProgrammed ||
                    (pressed->action == OperatorAction::SetAuthority && pressed->authority == Authority::Off))) {
      if (out.authority != Authority::Off) return "Off was not obeyed";
    }
    offFor_ = out.authority == Authority::Off ? offFor_ + 0.02 : 0.0;
    if (!out.command) return inForce_ ? "a Set was neither renewed nor released" : "";
    const bool set = out.command->kind() == CommandKind::Set;
    const double s = set ? out.command->speed().value : 1.0, f = set ? out.command->feed().value : 1.0;
    const bool was = std::exchange(inForce_, set);
    const double fromS = std::exchange(lastS_, s), fromF = std::exchange(lastF_, f);
    if (!set) return "";
    ++sets;
    if (out.authority == Authority::Off) {
      if (!was) return "took the overrides while Off";
      if (std::abs(s - 1.0) > std::abs(fromS - 1.0) + 1e-9 || std::abs(f - 1.0) > std::abs(fromF - 1.0) + 1e-9) {
        return "moved away from 100 % while Off";
      }
      if (offFor_ > kHomeWithin) return "Off for too long and still a Set";
    }
    return limits(in.machine, s, f, was && s == fromS && f == fromF);
  }
  static std::string limits(const MachineState& m, double s, double f, bool unmoved) {
    const bool sane =
        m.valid && m.linkUp && m.overridesEnabled && m.programmedSpeed.value > 0.0 && m.operatorSpeed.value > 0.0;
    if (!sane) return unmoved ? "" : "moved by a state that makes no sense";
    const double ks = m.operatorSpeed.value, kf = m.operatorFeed.value;
    if (s < 0.5 - 1e-9 || s > 1.2 + 1e-9 || f < 0.5 - 1e-9 || f > 1.2 + 1e-9) return "beyond the override's range";
    if (s * ks > std::max(1.2, ks) + 1e-9 || f * kf > std::max(1.2, kf) + 1e-9) return "above limits with the hand";
    if (s * ks < std::min(0.5, ks) - 1e-9 || f * kf < std::min(0.5, kf) - 1e-9) return "below limits with the hand";
    return f > s + 1e-9 ? "more feed per tooth" : "";
  }

  std::string link() {
    const LinkAction action = lease_.poll(newest_ ? &*newest_ : nullptr, now_);
    for (HandAndWire* axis : {&speed_, &feed_}) {
      if (action == LinkAction::Release) axis->relinquish();
      if (action == LinkAction::Apply) {
        axis->want(axis == &speed_ ? newest_->speed() : newest_->feed(), newest_->engagement());
      }
      if (std::string what = axis->send(now_, delay_); !what.empty()) return what;
    }
    return "";
  }

  static bool stands(const HandAndWire& axis) { return axis.undecidable() || axis.shows() == axis.hand(); }
  static bool isHome(const HandAndWire& axis) { return axis.undecidable() || axis.home(); }
  bool home() const { return !inForce_ && isHome(speed_) && isHome(feed_); }
  std::string notHome() const {
    return "Off, and still not home: speed " + std::to_string(speed_.shows()) + " of the hand's " +
           std::to_string(speed_.hand()) + " %, feed " + std::to_string(feed_.shows()) + " of " +
           std::to_string(feed_.hand()) + (inForce_ ? " %, a Set in force" : " %");
  }

  std::mt19937_64 random_;
  GateLimits limits_ = tightLimits();
  OverrideGate gate_;
  LeaseWatch lease_;
  HandAndWire speed_, feed_;
  Instant now_ = instantFromNs(1'000'000'000'000), heard_ = now_, judged_ = now_;
  double actual_ = 10000.0;
  Duration delay_{}, jump_{};
  int silentFor_ = 0, stalledFor_ = 0, oldFor_ = 0, lie_ = 0;
  bool alarming_ = true;
  double wish_ = 0.8;
  std::optional<OperatorInput> pressed_ = OperatorInput{OperatorAction::SetAuthority, Authority::Auto};
  std::uint32_t advice_ = 0;
  std::optional<OverrideCommand> newest_;
  bool inForce_ = false;
  double lastS_ = 1.0, lastF_ = 1.0, offFor_ = 0.0;

 public:
  void count() { undecidable += speed_.undecidable() || feed_.undecidable() ? 1 : 0; }
};

TEST(GateSequences, EndWhereTheOperatorHadSetTheMachine) {
  const char* told = std::getenv("STILLCUT_GATE_SEQUENCES");
  const long count = told != nullptr ? std::atol(told) : 100'000;
  const char* from = std::getenv("STILLCUT_GATE_FIRST");
  const long first = from != nullptr ? std::atol(from) : 0;
  long sets = 0, hands = 0, undecidable = 0;
  for (long i = first; i < first + count; ++i) {
    Life life(static_cast<std::uint64_t>(i) + 1);
    const std::string broken = life.live();
    ASSERT_TRUE(broken.empty()) << "sequence " << i << ": " << broken;
    life.count();
    sets += life.sets;
    hands += life.hands;
    undecidable += life.undecidable;
  }
  // The machine was really driven, hands were really turned, and most ends could be told.
  EXPECT_GT(sets, 10 * count);
  EXPECT_GT(hands, count / 2);
  EXPECT_LE(2 * undecidable, count);
}

}  // namespace
}  // namespace stillcut::safety
