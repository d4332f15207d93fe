#include "core/detect/caliskan/chatter_line.h"

#include <algorithm>
#include <cmath>

#include "core/detect/growth/turn_difference.h"
#include "core/dsp/order.h"

namespace stillcut::detect {
namespace {

constexpr double kLeastPurity = 0.4;   // chatter is a line; chips and knocks are not
constexpr double kLostPurity = 0.25;   // an alarm whose line sinks into the noise ...
constexpr double kLostTurns = 32.0;    // ... for so long was none, or is over
constexpr double kSameTurns = 16.0;    // memory of whether the strongest line stays the same
constexpr double kSameOffset = 0.08;   // tooth passings; with few teeth an order is much of one
constexpr double kLineReach = 0.25;    // orders within which a line is the same
constexpr double kLeastBetween = 0.5;  // line over severity from which it is not on an order
constexpr double kOnOrderSd = 2e-4;    // relative: as well as the spindle's speed is known
constexpr double kCaught = 0.1;        // orders: of a line so near an order holds nearly all, and turns with it
constexpr double kLeastOffset = 0.03;  // orders; nearer to a harmonic a line is forced
constexpr double kSpeedDoubts = 4.0;   // ... or within so many standard deviations of the harmonic's place
constexpr double kMostOffset = 0.25;   // ... at most; what turns by more a turn belongs to the next order as much
constexpr double kHalfToothSd = 0.02;  // tooth passings, of period doubling's place
// Orders over a relative change of speed in a turn: an order that moves across a mode of the damping z turns by 1 / (2
// pi z) of it a turn, here 0.5 %, and the difference's peak stands as far again from it.
constexpr double kPulled = 64.0;

// A line that is followed need not be looked at more often than verdicts are given, nor less often than every quarter
// of that spectrum.
constexpr Seconds kFollowing{10e-3};
constexpr int kMostLookHops = 4 * kHopsPerTurn;

int followingHops(Seconds hop) {
  return std::clamp(static_cast<int>(kFollowing / hop), kLookHops, kMostLookHops);
}

// Of the speed from the last turn but one to the last, relative; 0 where no machine tells a change.
double speedChange(const RatioHop& hop) {
  if (hop.marks == nullptr) return 0.0;
  const double unmarked = hop.rate / hop.spindle;
  const double turn = hop.marks->framesAgo(1.0, unmarked);
  const double before = hop.marks->framesAgo(2.0, turn + unmarked) - turn;
  return std::abs(before / turn - 1.0);
}

// While the speed changes its turns are where its angle says.
Hertz newLineNear(Hertz rough, const RatioHop& hop) {
  if (hop.marks == nullptr) return hop.newLine->frequency(rough, hop.spindle);
  NewLine::TurnsAgo ago{};
  const double turn = hop.rate / hop.spindle;
  for (std::size_t k = 1; k < ago.size(); ++k) ago[k] = hop.marks->framesAgo(static_cast<double>(k), ago[k - 1] + turn);
  return hop.newLine->frequency(rough, hop.spindle, ago);
}

}  // namespace

bool lineStands(const FoundLine& line, const RatioHop& hop) {
  const double doubt = kSpeedDoubts * line.frequency / hop.spindle * (hop.spindleSd / hop.spindle);
  const double least = std::max(kLeastOffset, std::min(std::max(doubt, kPulled * speedChange(hop)), kMostOffset));
  return line.purity >= kLeastPurity && std::abs(dsp::orderOffset(line.frequency, hop.spindle)) >= least;
}

void ChatterLine::forget() {
  frequency_ = {};
  frequencySd_ = spread_ = lostTurns_ = same_ = 0.0;
  sinceLook_ = 0;
  doubled_ = another_ = false;
}

void ChatterLine::stayOnOrder(double order, const RatioHop& hop) {
  another_ = frequency_.value > 0.0 && !sameAs(hop.spindle * order, hop);
  frequency_ = hop.spindle * order;
  frequencySd_ = kOnOrderSd * frequency_.value;
  spread_ = 0.0;
  lostTurns_ = same_ = 0.0;
}

void ChatterLine::move(Hertz next, const RatioHop& hop, int hops) {
  const double jump = std::abs(next.value - frequency_.value);
  if (!(frequency_.value > 0.0) || jump > kLineReach * hop.spindle.value) {  // the first line, or another one
    frequencySd_ = hop.spindle.value / kLineTurns;
  } else {
    frequencySd_ += (1.0 - std::exp(-hops * hop.length.value * hop.spindle.value)) * (jump - frequencySd_);
  }
  frequency_ = next;
}

void ChatterLine::follow(LineFinder& lines, const RatioHop& hop, const Evidence& evidence) {
  const int hops = frequency_.value > 0.0 ? followingHops(hop.length) : 1;
  if (++sinceLook_ < hops) return;
  sinceLook_ = 0;
  another_ = false;
  const FoundLine line = lines.find(hop.spindle * 0.5, hop.highest);
  purity_ = line.purity;
  spread_ = line.spread.value;
  // A line between the harmonics that is larger than what grows on them is what those orders have caught a part of.
  const double offset = std::abs(dsp::orderOffset(line.frequency, hop.spindle));
  const bool larger =
      evidence.changed > kLeastBetween * evidence.severity * RevolutionDifference::differenceGain(offset);
  // ... and so is what turns by more than a quarter of a turn a turn: the next order has as much of it.
  const bool caught = std::abs(evidence.onOrder - std::round(evidence.onOrder)) > kMostOffset;
  // ... but one beside an order that doubles and stands still is the doubling's own change of size.
  const double least = evidence.doubling ? kCaught : kLeastOffset;
  const bool between = offset >= least && line.purity >= (caught ? kLostPurity : kLeastPurity) && (larger || caught);
  const bool onOrder = evidence.onOrder > 0.0 && !between;
  doubled_ = onOrder && evidence.doubling;
  if (onOrder) return stayOnOrder(evidence.onOrder, hop);
  lostTurns_ = purity_ < kLostPurity ? lostTurns_ + static_cast<double>(hops) / kHopsPerTurn : 0.0;
  if (!(line.frequency.value > 0.0)) return;
  const double turns = static_cast<double>(hops) / kHopsPerTurn;
  same_ += (1.0 - std::exp(-turns / kSameTurns)) * (sameAs(line.frequency, hop) - same_);
  // While the speed changes lines are smeared, and what is left when it has arrived rings down at the mode's own
  // frequency: the chatter's is the one from before.
  if (frequency_.value > 0.0 && (!hop.revolutionsComparable || evidence.ringing)) return;
  const Hertz kept =
      frequency_.value > 0.0 ? lines.keep(frequency_, line.frequency, hop.spindle * kLineReach) : line.frequency;
  const bool same = sameAs(kept, hop);
  another_ = frequency_.value > 0.0 && !same;
  if (!same) same_ = 0.0;
  const Hertz newer = newLineNear(kept, hop);
  move(newer.value > 0.0 ? newer : kept, hop, hops);
}

// Teeth make of one line others, whole tooth passings away from it and from its mirror image: which of them is the
// strongest changes with the engagement.
bool ChatterLine::sameAs(Hertz line, const RatioHop& hop) const {
  if (hop.teeth < 1) return std::abs(line.value - frequency_.value) < kLineReach * hop.spindle.value;
  const Hertz tooth = hop.spindle * hop.teeth;
  const double away = std::abs(dsp::orderOffset(line, tooth)) - std::abs(dsp::orderOffset(frequency_, tooth));
  return std::abs(away) < std::min(kLineReach / hop.teeth, kSameOffset);
}

bool ChatterLine::stays() const {
  return same_ > 0.5;
}

bool ChatterLine::lost() const {
  return lostTurns_ > kLostTurns;
}

Hertz ChatterLine::sd() const {
  return Hertz(std::hypot(frequencySd_, spread_));
}

// Period doubling sits half way between the tooth-passing harmonics, whatever the speed; Hopf chatter anywhere else.
ChatterKind ChatterLine::kind(int teeth, Hertz spindle) const {
  if (teeth < 1 || !(frequency_.value > 0.0)) return ChatterKind::Unknown;
  if (doubled_) return ChatterKind::Flip;
  const double offset = std::abs(dsp::orderOffset(frequency_, spindle * teeth));
  const double doubt = kHalfToothSd + 2.0 * frequencySd_ / (spindle.value * teeth);
  return 0.5 - offset < doubt ? ChatterKind::Flip : ChatterKind::Hopf;
}

}  // namespace stillcut::detect
