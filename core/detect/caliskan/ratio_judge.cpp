#include "core/detect/caliskan/ratio_judge.h"

#include <algorithm>
#include <cmath>

#include "core/detect/growth/turn_difference.h"
#include "core/dsp/order.h"

namespace stillcut::detect {
namespace {

constexpr double kAlarmTurns = 16.0;
constexpr double kLeft = 0.1;          // of the energy while the alarm lasted
constexpr double kFalling = 0.8;       // what grows does not make the vibration fall; a tool that leaves does
constexpr double kMostPassed = 0.25;   // difference over news of a line that needs the news to be heard in time
constexpr double kLeastNews = 0.5;     // of what a line's news leaves of it in the difference
constexpr double kGrowsOn = 0.3;       // of the time for which it must last: so long it may be missed
constexpr double kLeastLine = 2.5e-3;  // of the vibration's energy: 5 % of its amplitude

// A line within its first turn is in the difference as it is in the news, each by the part it passes then. What a speed
// that was found anew moves in every harmonic stands still from the next turn on: the difference hardly holds any of
// it.
bool arrives(const RatioChannel& c) {
  const auto line = [](const EnergyGrowth& growth, double arrival) {
    return (growth.changed() - growth.onset().floor()) / arrival;
  };
  return line(c.growth, RevolutionDifference::kDifferenceArrival) >
         kLeastNews * line(c.news, RevolutionDifference::kNewsArrival);
}

}  // namespace

void RatioJudge::prepare(int teeth, double chatterRatio) {
  teeth_ = teeth;
  chatterRatio_ = full_ = chatterRatio;
  entry_.prepare(chatterRatio);
}

void RatioJudge::leaveCut() {
  calm_.reset();
  calm_.forgetLevel();
  entry_.leaveCut();
  share_.reset();
  line_.forget();
  joint_ = severity_ = worst_ = evidence_ = floor_ = changed_ = purity_ = 0.0;
  learned_ = wasFull_ = byShare_ = false;
  risingHops_ = {};
  growsFor_ = notGrowing_ = 0.0;
  sinceOnset_ = feedSinceOnset_ = 0.0;
}

void RatioJudge::weigh(const EnergyGrowth& growth) {
  const OnsetTest& onset = growth.onset();
  if (onset.evidence() >= evidence_) {
    evidence_ = onset.evidence();
    floor_ = onset.floor();
    changed_ = growth.changed();
  }
  learned_ = learned_ && onset.learned();
}

// What speaks for an alarm in a channel whose vibration does not fall.
void RatioJudge::gatherGrowth(const RatioChannel& c, int& risingHops) {
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

// Full chatter is asked of the channel that is furthest beyond what it may be.
void RatioJudge::gatherRatio(const RatioChannel& c) {
  const auto take = [&](double ratio, const UsualRatio& usual) {
    const double full = usual.limit(chatterRatio_, 1.0);
    const double still = usual.limit(chatterRatio_, kHysteresis);
    const double limit = wasFull_ ? still : full;
    worst_ = std::max(worst_, ratio);
    quiet_ = quiet_ && ratio < still;
    if (ratio * limit_ < severity_ * limit) return;
    severity_ = ratio;
    full_ = full;
    limit_ = limit;
  };
  take(c.ratio, c.usual);
  take(c.orders.severity(), {});
}

void RatioJudge::gather(std::span<const RatioChannel> channels) {
  full_ = limit_ = chatterRatio_;
  quiet_ = true;
  severity_ = worst_ = joint_ = evidence_ = mostChanged_ = mostGrown_ = 0.0;
  grown_ = growing_ = newsGrowing_ = rising_ = forced_ = false;
  onOrder_ = 0.0;
  doubling_ = false;
  learned_ = true;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const RatioChannel& c = channels[i];
    gatherRatio(c);
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
bool RatioJudge::toolLeaves(std::span<const RatioChannel> channels, CutPhase phase) {
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

bool RatioJudge::judge(std::span<RatioChannel> channels, LineFinder& lines, const RatioHop& hop) {
  gather(channels);
  const bool was = alarming();
  share_.see(*hop.series);
  const bool high = severity_ >= limit_;
  // Of the line that full chatter was made of, less is chatter still.
  const bool lasts = wasFull_ && line_.stays() && joint_ >= entry_.sidedRatio();
  const bool held = lasts || entry_.held(joint_);
  calm_.watch(changed_, quiet_ && !held, was ? hop.length.value : 0.0);
  if (!was && !high && hop.phase == CutPhase::Steady) entry_.learnCalm(channels, worst_, hop);
  if (!was && hop.steadyTurns >= kSettleTurns && joint_ < entry_.sidedRatio()) {
    for (RatioChannel& c : channels) c.usual.learn(c.ratio, 1.0 / kHopsPerTurn);
  }
  bool entry = hop.isolatedLine && high;
  if (!was && !entry) {
    entry = entry_.begins(channels, {worst_, joint_}, lines, hop);
    if (entry_.looked()) purity_ = entry_.line().purity;
  }
  const bool left = toolLeaves(channels, hop.phase);
  bool over = false;
  if (was) {
    const bool ended = line_.lost() || calm_.calm(hop.spindle) || !(high || held || grown_ || calm_.floorGone());
    byShare_ = byShare_ && !(grown_ && high);
    over = left || (byShare_ ? !share_.lasts() : ended);
    // A ratio that rises while the speed changes may be forced vibration that changes with it.
    const bool full =
        (byShare_ && share_.full()) || ((high || lasts) && (hop.revolutionsComparable || state_ == CutState::Chatter));
    state_ = over ? CutState::Stable : full ? CutState::Chatter : CutState::Onset;
    if (over) {
      left ? share_.skipStale() : share_.reset();
      calm_.reset();
      entry_.endAlarm();
    }
  } else if (hop.phase == CutPhase::Steady &&
             (share_.full() || (hop.revolutionsComparable && (entry || growsLongEnough(channels, lines, hop))))) {
    state_ = high || share_.full() ? CutState::Chatter : CutState::Onset;
    byShare_ = share_.full() && !entry && !grown_;
  } else {
    state_ = CutState::Stable;
  }
  over_ = severity_ >= full_ ? full_ : high ? limit_ : entry_.sidedRatio();
  wasFull_ = state_ == CutState::Chatter || (wasFull_ && alarming() && !line_.another());
  sinceOnset_ = alarming() ? sinceOnset_ + hop.length.value : 0.0;
  if (!alarming()) feedSinceOnset_ = 0.0;
  follow(lines, hop);
  return over;
}

// Narrow-band noise of a stable cut near its limit comes in bursts, well above its mean; they stay small. On the axis
// that grew: what another one is used to proves nothing.
bool RatioJudge::lineCounts(Hertz line, Hertz spindle) const {
  const double offset = dsp::orderOffset(line, spindle);
  return mostGrown_ > kLeastLine * RevolutionDifference::differenceGain(offset);
}

// Of a line near a harmonic the difference passes little and the news much, but news is also what forced vibration
// changes by. It is the line's where the difference holds as much of it, above its own noise, as that line leaves
// there, and grows as well: where a change of the engagement ends, what the tracked speed took along is new at once.
bool RatioJudge::lineIsNew(std::span<const RatioChannel> channels, Hertz line, Hertz spindle) const {
  const double offset = dsp::orderOffset(line, spindle);
  const double gain = RevolutionDifference::differenceGain(offset);
  const double passed = gain / RevolutionDifference::newsGain(offset);
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
bool RatioJudge::lineGrows(std::span<const RatioChannel> channels, LineFinder& lines, const RatioHop& hop) {
  if (!growing_ && !newsGrowing_) return false;
  const FoundLine line = lines.find(hop.spindle * 0.5, hop.highest);
  purity_ = line.purity;
  if (!lineStands(line, hop)) return false;
  return (growing_ && lineCounts(line.frequency, hop.spindle)) ||
         (newsGrowing_ && lineIsNew(channels, line.frequency, hop.spindle));
}

// ... or growth too fast for one, or on an order; and none of it is the load's.
bool RatioJudge::grows(std::span<const RatioChannel> channels, LineFinder& lines, const RatioHop& hop) {
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

// Growth may come and go from hop to hop; what glides through the spectrum does so for shorter (conditioned_block.h).
bool RatioJudge::growsLongEnough(std::span<const RatioChannel> channels, LineFinder& lines, const RatioHop& hop) {
  const bool now = hop.levelTrend > kFalling && grows(channels, lines, hop);
  notGrowing_ = now ? 0.0 : notGrowing_ + hop.length.value;
  const bool goesOn = now || (growsFor_ > 0.0 && notGrowing_ < kGrowsOn * hop.alarmWait.value);
  growsFor_ = goesOn ? growsFor_ + hop.length.value : 0.0;
  return now && growsFor_ >= hop.alarmWait.value;
}

void RatioJudge::follow(LineFinder& lines, const RatioHop& hop) {
  if (!alarming()) return line_.forget();
  const bool ringing = calm_.floorGone() && severity_ < full_;
  line_.follow(lines, hop, {onOrder_, doubling_, mostChanged_, severity_, ringing});
  purity_ = line_.purity();
}

void RatioJudge::fill(Verdict& v, Hertz spindle) const {
  v.state = v.phase == CutPhase::AirCutting ? CutState::AirCutting : state_;
  v.severity = Ratio(severity_);
  v.frequency = line_.frequency();
  v.frequencySd = line_.sd();
  v.sinceOnset = Seconds(sinceOnset_);
  v.feedSinceOnset = Metres(feedSinceOnset_);
  v.indicators = {severity_, line_.frequency().value, changed_, floor_, evidence_, purity_};
  if (v.alarming() && byShare_) {
    v.severity = Ratio(std::max(severity_, share_.share()));
    v.frequency = share_.line();
    v.reason = {ReasonCode::LineOffHarmonics, {share_.share(), ShareTest::kFull, share_.line().value}};
  } else if (v.state == CutState::Chatter) {
    v.reason = {ReasonCode::EnergyRatioHigh, {severity_, over_}};
  } else if (v.state == CutState::Onset) {
    v.reason = {ReasonCode::EnergyRatioGrowing, {changed_, floor_}};
  } else if (v.phase == CutPhase::RunUp) {
    v.reason = {ReasonCode::SpindleRunUp, {toRpm(v.spindle).value}};
  } else if (v.phase == CutPhase::Steady && !learned_) {
    v.reason = {ReasonCode::Learning, {(OnsetTest::kLearnTurns + kSettleTurns) / spindle.value}};
  }
  if (v.alarming()) v.kind = line_.kind(teeth_, spindle);
  if (v.state == CutState::Stable && v.phase == CutPhase::Steady && forced_) v.kind = ChatterKind::Forced;
}

}  // namespace stillcut::detect
