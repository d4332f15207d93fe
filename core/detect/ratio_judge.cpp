#include "core/detect/ratio_judge.h"

#include <algorithm>
#include <cmath>

#include "core/detect/turn_difference.h"
#include "core/dsp/order.h"

namespace stillcut::detect {
namespace {

constexpr double kAlarmTurns = 16.0;
constexpr double kLeft = 0.1;          // of the energy while the alarm lasted
constexpr double kFalling = 0.8;       // what grows does not make the vibration fall; a tool that leaves does
constexpr double kLeastPurity = 0.4;   // chatter is a line; chips and knocks are not
constexpr double kLostPurity = 0.25;   // an alarm whose line sinks into the noise ...
constexpr double kLostTurns = 32.0;    // ... for so long was none, or is over
constexpr double kLineReach = 0.25;    // orders within which a line is the same
constexpr double kMostPassed = 0.25;   // difference over news of a line that needs the news to be heard in time
constexpr double kLeastNews = 0.5;     // of what a line's news leaves of it in the difference
constexpr double kLeastLine = 2.5e-3;  // of the vibration's energy: 5 % of its amplitude
constexpr double kLeastBetween = 0.5;  // line over severity from which it is not on an order
constexpr double kOnOrderSd = 2e-4;    // relative: as well as the spindle's speed is known
constexpr double kLeastOffset = 0.03;  // orders; nearer to a harmonic a line is forced
constexpr double kSpeedDoubts = 4.0;   // ... or within so many standard deviations of the harmonic's place
constexpr double kMostOffset = 0.25;   // ... at most; what turns by more a turn belongs to the next order as much
// Orders over a relative change of speed in a turn: an order that moves across a mode of the damping z turns by 1 / (2
// pi z) of it a turn, here 0.5 %, and the difference's peak stands as far again from it.
constexpr double kPulled = 64.0;

// A line that is followed need not be looked at more often than verdicts are given, nor less often than every quarter
// of that spectrum.
constexpr Seconds kFollowing{10e-3};
constexpr int kMostLookHops = 4 * kHopsPerTurn;

int followingHops(Seconds hop) noexcept {
  return std::clamp(static_cast<int>(kFollowing / hop), RatioJudge::kLookHops, kMostLookHops);
}

// A line within its first turn is in the difference as it is in the news, each by the part it passes then. What a speed
// that was found anew moves in every harmonic stands still from the next turn on: the difference hardly holds any of
// it.
bool arrives(const RatioChannel& c) noexcept {
  const auto line = [](const EnergyGrowth& growth, double arrival) {
    return (growth.changed() - growth.onset().floor()) / arrival;
  };
  return line(c.growth, TurnDifference::kDifferenceArrival) > kLeastNews * line(c.news, TurnDifference::kNewsArrival);
}

// Of the speed from the last turn but one to the last, relative; 0 where no machine tells a change.
double speedChange(const RatioHop& hop) noexcept {
  if (hop.marks == nullptr) return 0.0;
  const double unmarked = hop.rate / hop.spindle;
  const double turn = hop.marks->framesAgo(1.0, unmarked);
  const double before = hop.marks->framesAgo(2.0, 2.0 * unmarked) - turn;
  return std::abs(before / turn - 1.0);
}

// While the speed changes its turns are where its angle says.
Hertz newLineNear(Hertz rough, const RatioHop& hop) noexcept {
  if (hop.marks == nullptr) return hop.newLine->frequency(rough, hop.spindle);
  NewLine::TurnsAgo ago{};
  const double turn = hop.rate / hop.spindle;
  for (std::size_t k = 1; k < ago.size(); ++k) ago[k] = hop.marks->framesAgo(static_cast<double>(k), ago[k - 1] + turn);
  return hop.newLine->frequency(rough, hop.spindle, ago);
}

}  // namespace

bool isIntegral(SensorQuantity q) noexcept {
  return q == SensorQuantity::SpindleSpeed || q == SensorQuantity::Current;
}

void RatioJudge::prepare(int teeth, double chatterRatio) noexcept {
  teeth_ = teeth;
  chatterRatio_ = chatterRatio;
}

void RatioJudge::leaveCut() noexcept {
  calm_.reset();
  calm_.forgetLevel();
  line_ = {};
  highTurns_ = calmTurns_ = joint_ = severity_ = evidence_ = floor_ = changed_ = 0.0;
  learned_ = sided_ = wasCalm_ = false;
  calmFloor_ = calmNews_ = {};
  risingHops_ = {};
  frequency_ = {};
  frequencySd_ = purity_ = sinceOnset_ = feedSinceOnset_ = 0.0;
}

void RatioJudge::weigh(const EnergyGrowth& growth) noexcept {
  const OnsetTest& onset = growth.onset();
  if (onset.evidence() >= evidence_) {
    evidence_ = onset.evidence();
    floor_ = onset.floor();
    changed_ = growth.changed();
  }
  learned_ = learned_ && onset.learned();
}

// What speaks for an alarm in a channel whose vibration does not fall.
void RatioJudge::gatherGrowth(const RatioChannel& c, int& risingHops) noexcept {
  const OnsetTest& onset = c.growth.onset();
  const OnsetTest& news = c.news.onset();
  grown_ = grown_ || c.orders.grown() || onset.alarm() || news.alarm();
  if (c.orders.order() > 0.0) {
    onOrder_ = c.orders.order();
    doubling_ = c.orders.doubling();
  }
  if (onset.grown() && c.growth.steadyGrowth() && !c.load.explainsDifference(c.growth.changed())) {
    growing_ = true;
    mostGrown_ = std::max(mostGrown_, c.growth.changed());
  }
  newsGrowing_ = newsGrowing_ || (news.grown() && c.news.steadyGrowth());
  // What is new also holds forced vibration that changes: for the fast only.
  bool rises = c.growth.rising() || (c.news.rising() && arrives(c));
  // Of the torque's integrals a load that ends at once, as where the tool leaves, makes a step. That grows from one
  // half turn to the next until the newer has taken all of it in.
  risingHops = rises ? risingHops + 1 : 0;
  if (isIntegral(c.quantity)) rises = risingHops >= kHopsPerTurn / 2;
  rising_ = rising_ || (rises && c.growth.steadyGrowth() && c.news.steadyGrowth());
}

void RatioJudge::gather(std::span<const RatioChannel> channels) noexcept {
  severity_ = joint_ = evidence_ = mostChanged_ = mostGrown_ = 0.0;
  grown_ = growing_ = newsGrowing_ = rising_ = forced_ = false;
  onOrder_ = 0.0;
  learned_ = true;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const RatioChannel& c = channels[i];
    severity_ = std::max(severity_, c.ratio);
    severity_ = std::max(severity_, c.orders.severity());
    forced_ = forced_ || c.forced.stands();
    weigh(c.growth);
    mostChanged_ = std::max(mostChanged_, c.growth.changed());
    if (alarming() || c.growth.levelTrend() > kFalling) {
      gatherGrowth(c, risingHops_[i]);
    } else {
      risingHops_[i] = 0;
    }
    double unrepeated = 0.0;
    double all = 0.0;
    for (const RatioChannel& other : channels) {
      if (other.quantity != c.quantity) continue;
      unrepeated += other.ratio * other.growth.level();
      all += other.growth.level();
    }
    if (all > 0.0) joint_ = std::max(joint_, unrepeated / all);
  }
}

// A tool that leaves takes its chatter along; what rings down then, or was there anyway, is none.
bool RatioJudge::toolLeaves(std::span<const RatioChannel> channels, CutPhase phase) noexcept {
  bool left = phase == CutPhase::Exit;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const double now = channels[i].growth.energy();
    double& usual = alarmEnergy_[i];
    if (!alarming()) usual = 0.0;
    if (alarming() && phase != CutPhase::Exit)
      usual += usual > 0.0 ? (now - usual) / (kAlarmTurns * kHopsPerTurn) : now;
    left = left && now < kLeft * usual;
  }
  return left;
}

bool RatioJudge::judge(std::span<const RatioChannel> channels, LineFinder& lines, const RatioHop& hop) noexcept {
  gather(channels);
  const bool was = alarming();
  const bool high = severity_ >= chatterRatio_ * (state_ == CutState::Chatter ? kHysteresis : 1.0);
  const bool held = sided_ && joint_ >= kHysteresis * kSidedRatio;
  calm_.watch(changed_, severity_ < kHysteresis * chatterRatio_ && !held, was ? hop.length.value : 0.0);
  if (!was && !high && hop.phase == CutPhase::Steady) learnCalm(channels);
  const bool entry = (hop.loneLine && high) || (!was && fromEntry(channels, lines, hop));
  const bool left = toolLeaves(channels, hop.phase);
  bool over = false;
  if (was) {
    const bool lost = lostTurns_ > kLostTurns;
    over = lost || left || calm_.calm(hop.spindle) || !(high || held || grown_ || calm_.floorGone());
    // A ratio that rises while the speed changes may be forced vibration that changes with it.
    const bool full = high && (hop.turnsCompare || state_ == CutState::Chatter);
    state_ = over ? CutState::Stable : full ? CutState::Chatter : CutState::Onset;
    if (over) calm_.reset();
    sided_ = sided_ && !over;
    highTurns_ = 0.0;  // after an alarm the turns of chatter from the entry count anew
  } else if (hop.phase == CutPhase::Steady && hop.turnsCompare &&
             (entry || (hop.levelTrend > kFalling && grows(channels, lines, hop)))) {
    state_ = high ? CutState::Chatter : CutState::Onset;
  } else {
    state_ = CutState::Stable;
  }
  sinceOnset_ = alarming() ? sinceOnset_ + hop.length.value : 0.0;
  if (!alarming()) feedSinceOnset_ = 0.0;
  track(lines, hop);
  return over;
}

// Growth or a high ratio alone may be a knock or a lost speed; chatter is a line between the spindle harmonics.
bool RatioJudge::lineStands(LineFinder& lines, const RatioHop& hop) noexcept {
  line_ = lines.find(hop.spindle * 0.5, hop.highest);
  purity_ = line_.purity;
  const double doubt = kSpeedDoubts * line_.frequency / hop.spindle * (hop.spindleSd / hop.spindle);
  const double least = std::max(kLeastOffset, std::min(std::max(doubt, kPulled * speedChange(hop)), kMostOffset));
  return line_.purity >= kLeastPurity && std::abs(dsp::orderOffset(line_.frequency, hop.spindle)) >= least;
}

// Narrow-band noise of a stable cut near its limit comes in bursts, well above its mean; they stay small. On the axis
// that grew: what another one is used to proves nothing.
bool RatioJudge::lineCounts(Hertz spindle) const noexcept {
  const double offset = dsp::orderOffset(line_.frequency, spindle);
  return mostGrown_ > kLeastLine * TurnDifference::differenceGain(offset);
}

// Of a line near a harmonic the difference passes little and the news much, but news is also what forced vibration
// changes by. It is the line's where the difference holds as much of it, above its own noise, as that line leaves
// there, and grows as well: where a change of the engagement ends, what the tracked speed took along is new at once.
bool RatioJudge::lineIsNew(std::span<const RatioChannel> channels, Hertz spindle) const noexcept {
  const double offset = dsp::orderOffset(line_.frequency, spindle);
  const double gain = TurnDifference::differenceGain(offset);
  const double passed = gain / TurnDifference::newsGain(offset);
  if (passed > kMostPassed) return false;
  return std::any_of(channels.begin(), channels.end(), [&](const RatioChannel& c) {
    const double news = c.news.changed() - c.news.onset().floor();
    const double difference = c.growth.changed() - c.growth.onset().floor();
    return !c.load.explainsNews(c.news.changed()) && c.news.onset().grown() && c.news.steadyGrowth() &&
           c.news.growsOn() && c.growth.steadyGrowth() && difference > kLeastLine * gain &&
           difference > kLeastNews * passed * news;
  });
}

// Growth above a learned floor, and a line that it is of.
bool RatioJudge::lineGrows(std::span<const RatioChannel> channels, LineFinder& lines, const RatioHop& hop) noexcept {
  if ((!growing_ && !newsGrowing_) || !lineStands(lines, hop)) return false;
  return (growing_ && lineCounts(hop.spindle)) || (newsGrowing_ && lineIsNew(channels, hop.spindle));
}

// ... or growth too fast for one, or on an order; and none of it is the load's.
bool RatioJudge::grows(std::span<const RatioChannel> channels, LineFinder& lines, const RatioHop& hop) noexcept {
  double order = onOrder_;
  if (rising_ || !(order > 0.0)) {
    if (!rising_ && !lineGrows(channels, lines, hop)) return false;
    order = lines.find(hop.spindle * 0.5, hop.highest).frequency / hop.spindle;
  }
  for (std::size_t i = 0; i < channels.size(); ++i) {
    if (!channels[i].load.explains(*hop.newLine, static_cast<int>(i), order, hop.spindle)) return true;
  }
  return channels.empty();
}

void RatioJudge::track(LineFinder& lines, const RatioHop& hop) noexcept {
  if (!alarming()) {
    frequency_ = {};
    frequencySd_ = lostTurns_ = 0.0;
    sinceLook_ = 0;
    doubled_ = false;
    return;
  }
  const int hops = frequency_.value > 0.0 ? followingHops(hop.length) : 1;
  if (++sinceLook_ < hops) return;
  sinceLook_ = 0;
  const double spindle = hop.spindle.value;
  const FoundLine line = lines.find(hop.spindle * 0.5, hop.highest);
  purity_ = line.purity;
  spread_ = line.spread.value;
  // A line between the harmonics that is larger than what grows on them is what those orders have caught a part of.
  const double offset = std::abs(dsp::orderOffset(line.frequency, hop.spindle));
  const bool larger = mostChanged_ > kLeastBetween * severity_ * TurnDifference::differenceGain(offset);
  // ... and so is what turns by more than a quarter of a turn a turn: the next order has as much of it.
  const bool caught = std::abs(onOrder_ - std::round(onOrder_)) > kMostOffset;
  const bool between = offset >= kLeastOffset && line.purity >= kLeastPurity && (larger || caught);
  doubled_ = onOrder_ > 0.0 && doubling_ && !between;
  if (onOrder_ > 0.0 && !between) {
    frequency_ = hop.spindle * onOrder_;
    frequencySd_ = kOnOrderSd * frequency_.value;
    spread_ = 0.0;
    lostTurns_ = 0.0;
    return;
  }
  lostTurns_ = purity_ < kLostPurity ? lostTurns_ + static_cast<double>(hops) / kHopsPerTurn : 0.0;
  if (!(line.frequency.value > 0.0)) return;
  // While the speed changes lines are smeared, and what is left when it has arrived rings down at the mode's own
  // frequency: the chatter's is the one from before.
  const bool ringing = calm_.floorGone() && severity_ < chatterRatio_;
  if (frequency_.value > 0.0 && (!hop.turnsCompare || ringing)) return;
  Hertz next = line.frequency;
  if (frequency_.value > 0.0 && std::abs(next.value - frequency_.value) > kLineReach * spindle) {
    const LineFinder::Peak held = lines.near(frequency_, hop.spindle * kLineReach);
    const LineFinder::Peak strongest = lines.near(next, hop.spindle * kLineReach);
    if (strongest.power < kOtherLine * held.power) next = held.frequency;
  }
  const Hertz newer = newLineNear(next, hop);
  if (newer.value > 0.0) next = newer;
  const double jump = std::abs(next.value - frequency_.value);
  if (!(frequency_.value > 0.0) || jump > kLineReach * spindle) {  // the first line, or another one
    frequencySd_ = spindle / kLineTurns;
  } else {
    frequencySd_ += (1.0 - std::exp(-hops * hop.length.value * spindle)) * (jump - frequencySd_);
  }
  frequency_ = next;
}

// Period doubling sits half way between the tooth-passing harmonics, whatever the speed; Hopf chatter anywhere else.
ChatterKind RatioJudge::kind(Hertz spindle) const noexcept {
  if (teeth_ < 1 || !(frequency_.value > 0.0)) return ChatterKind::Unknown;
  if (doubled_) return ChatterKind::Flip;
  const double offset = std::abs(dsp::orderOffset(frequency_, spindle * teeth_));
  const double doubt = 0.02 + 2.0 * frequencySd_ / (spindle.value * teeth_);
  return 0.5 - offset < doubt ? ChatterKind::Flip : ChatterKind::Hopf;
}

void RatioJudge::fill(Verdict& v, Hertz spindle) const noexcept {
  v.state = v.phase == CutPhase::Air ? CutState::Air : state_;
  v.severity = Ratio(severity_);
  v.frequency = frequency_;
  v.frequencySd = Hertz(std::hypot(frequencySd_, alarming() ? spread_ : 0.0));
  v.sinceOnset = Seconds(sinceOnset_);
  v.feedSinceOnset = Metres(feedSinceOnset_);
  v.indicators = {severity_, frequency_.value, changed_, floor_, evidence_, purity_};
  if (v.state == CutState::Chatter) {
    v.reason = {ReasonCode::EnergyRatioHigh, {severity_, chatterRatio_}};
  } else if (v.state == CutState::Onset) {
    v.reason = {ReasonCode::EnergyRatioGrowing, {changed_, floor_}};
  } else if (v.phase == CutPhase::RunUp) {
    v.reason = {ReasonCode::SpindleRunUp, {toRpm(v.spindle).value}};
  } else if (v.phase == CutPhase::Steady && !learned_) {
    v.reason = {ReasonCode::Learning, {(OnsetTest::kLearnTurns + kSettleTurns) / spindle.value}};
  }
  if (v.alarming()) v.kind = kind(spindle);
  if (v.state == CutState::Stable && v.phase == CutPhase::Steady && forced_) v.kind = ChatterKind::Forced;
}

}  // namespace stillcut::detect
