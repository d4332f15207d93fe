// RatioJudge on chatter that is there from the entry on: no calm stretch was ever heard that it could have grown from.
#include <algorithm>
#include <cmath>

#include "core/detect/ratio_judge.h"

namespace stillcut::detect {
namespace {

constexpr double kEntryChatterTurns = 8.0;  // chatter, or a calm cut, stands for so long
constexpr double kEntryChatterSeconds = 0.1;
constexpr double kAboveCalm = 4.0;  // in energy, as onset_test.h asks of growth
constexpr double kBandPart = 0.5;   // of what the harmonics left, in the band of the line
constexpr double kRingsDown = 0.5;  // what a change of the cut excited, and chatter does not: it has side lines too
constexpr double kSettled = 1.6;    // chatter that was there from the entry has long found its size
constexpr int kSideLines = 2;       // one may be there by chance
constexpr double kSameLine = 4.0 / RatioJudge::kLineTurns;  // orders: a line that grows is no better known

}  // namespace

void RatioJudge::learnCalm(std::span<const RatioChannel> channels) noexcept {
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const auto learn = [](double& calm, const OnsetTest& onset) {
      if (onset.learned()) calm = calm > 0.0 ? std::min(calm, onset.floor()) : onset.floor();
    };
    learn(calmFloor_[i], channels[i].growth.onset());
    learn(calmNews_[i], channels[i].news.onset());
  }
  const bool quiet = severity_ < kHysteresis * kSidedRatio;
  if (quiet) calmTurns_ += 1.0 / kHopsPerTurn;
  wasCalm_ = calmTurns_ > kEntryChatterTurns;
}

// Is the high ratio of some channel the line's, and more than the channel is used to? Noise and lines folded into a
// weak signal make a ratio too. Of a line near a harmonic the difference passes so little that its ratio falls as the
// line grows; there the news hears it.
bool RatioJudge::aboveCalm(std::span<const RatioChannel> channels, const EnergyChain& chain) const noexcept {
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const RatioChannel& c = channels[i];
    const bool above =
        c.growth.changed() >= kAboveCalm * calmFloor_[i] || c.news.changed() >= kAboveCalm * calmNews_[i];
    if (c.ratio < chatterRatio_ || !above) continue;
    const double part = chain.bandPart(static_cast<int>(i), line_.frequency);
    if (part > kBandPart) return true;
  }
  return false;
}

// Chatter that was there from the entry has no floor to grow from, so a fixed ratio decides, for one and the same line
// over many turns: the paper's, or, until the cut has once been calm and of a line with side lines, a fifth of it.
bool RatioJudge::fromEntry(std::span<const RatioChannel> channels, LineFinder& lines, const RatioHop& hop) noexcept {
  // A quiet axis may hear nothing but noise and folded lines: where no floor was learned, all together must be high.
  const bool full = severity_ >= chatterRatio_ && joint_ >= chatterRatio_;
  const double least = kSidedRatio * (highTurns_ > 0.0 ? kHysteresis : 1.0);
  const bool steady = hop.phase == CutPhase::Steady;
  if (!(full || (joint_ >= least && !wasCalm_)) || !(steady || hop.phase == CutPhase::Exit)) {
    highTurns_ = 0.0;
    sinceEntryLook_ = kLookHops;
    return false;
  }
  // Chatter that beats goes through its lows as well, where the tool might leave, and drowns now and then what the
  // speed is followed by: that does not count, and takes nothing away.
  if (!steady || hop.steadyTurns < kSettleTurns) return false;
  if (++sinceEntryLook_ < kLookHops) return false;
  sinceEntryLook_ = 0;
  const bool stands = lineStands(lines, hop);
  const bool sided = stands && !wasCalm_ && lineHasSides(lines, hop.spindle);
  const bool same = std::abs(line_.frequency.value - entryLine_.value) < kSameLine * hop.spindle.value;
  if (stands && !sided) {
    const bool moves = hop.levelTrend > kSettled || hop.levelTrend * kSettled < 1.0;
    if (moves || !full || !aboveCalm(channels, *hop.chain)) return false;
  }
  entryLine_ = line_.frequency;
  entryMost_ = std::max(highTurns_ > 0.0 ? entryMost_ : 0.0, joint_);
  const bool falls = sided && joint_ < kRingsDown * entryMost_;
  highTurns_ = stands && same && !falls ? highTurns_ + static_cast<double>(kLookHops) / kHopsPerTurn : 0.0;
  if (highTurns_ <= std::max(kEntryChatterTurns, kEntryChatterSeconds * hop.spindle.value)) return false;
  sided_ = sided;
  return true;
}

// Does the line, or the one that was followed and is still there, have side lines? Two modes that chatter take turns in
// being the stronger one.
bool RatioJudge::lineHasSides(const LineFinder& lines, Hertz spindle) noexcept {
  const auto sides = [&](Hertz line) { return lines.sideLines(line, spindle * teeth_) >= kSideLines; };
  const Hertz reach = spindle * kSameLine;
  if (highTurns_ > 0.0 && std::abs(line_.frequency.value - entryLine_.value) > reach.value) {
    const LineFinder::Peak held = lines.near(entryLine_, reach);
    const LineFinder::Peak strongest = lines.near(line_.frequency, reach);
    if (strongest.power < kOtherLine * held.power && sides(held.frequency)) {
      line_.frequency = held.frequency;
      return true;
    }
  }
  return sides(line_.frequency);
}

}  // namespace stillcut::detect
