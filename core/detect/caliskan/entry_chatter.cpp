#include "core/detect/caliskan/entry_chatter.h"

#include <algorithm>
#include <cmath>

#include "core/detect/caliskan/chatter_line.h"

namespace stillcut::detect {
namespace {

constexpr double kEntryChatterTurns = 8.0;  // chatter, or a calm cut, stands for so long
constexpr double kEntryChatterSeconds = 0.1;
// Of the chatter ratio, where the line has side lines: a fifth of the vibration's amplitude. What else makes a ratio,
// as noise, chips and lines that reach the sensor and not the tool, has none whole tooth passings beside it.
constexpr double kSidedPart = 0.2;
constexpr double kAboveCalm = 4.0;  // in energy, as onset_test.h asks of growth
constexpr double kBandPart = 0.5;   // of what the harmonics left, in the band of the line
constexpr double kRingsDown = 0.5;  // what a change of the cut excited, and chatter does not: it has side lines too
constexpr double kSettled = 1.6;    // chatter that was there from the entry has long found its size
constexpr int kSideLines = 2;       // one may be there by chance
constexpr double kSameLine = 4.0 / kLineTurns;  // orders: a line that grows is no better known

double leastTurns(Hertz spindle) {
  return std::max(kEntryChatterTurns, kEntryChatterSeconds * spindle.value);
}

}  // namespace

void EntryChatter::leaveCut() {
  highTurns_ = calmTurns_ = 0.0;
  sided_ = wasCalm_ = false;
  calmFloor_ = calmNews_ = {};
  line_ = {};
}

double EntryChatter::sidedRatio() const {
  return kSidedPart * chatterRatio_;
}

void EntryChatter::learnCalm(std::span<const RatioChannel> channels, double worst, const RatioHop& hop) {
  bool learned = true;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const auto learn = [&](double& calm, const OnsetTest& onset) {
      if (onset.learned()) calm = calm > 0.0 ? std::min(calm, onset.floor()) : onset.floor();
      learned = learned && calm > 0.0;
    };
    learn(calmFloor_[i], channels[i].growth.onset());
    learn(calmNews_[i], channels[i].news.onset());
  }
  if (worst < kHysteresis * sidedRatio() && hop.steadyTurns >= kSettleTurns) calmTurns_ += 1.0 / kHopsPerTurn;
  wasCalm_ = wasCalm_ || (learned && calmTurns_ > leastTurns(hop.spindle));
}

// Is the high ratio of some channel the line's, and more than the channel is used to? Noise and lines folded into a
// weak signal make a ratio too. Of a line near a harmonic the difference passes so little that its ratio falls as the
// line grows; there the news hears it.
bool EntryChatter::aboveCalm(std::span<const RatioChannel> channels, const EnergyChain& chain) const {
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

bool EntryChatter::begins(std::span<const RatioChannel> channels, const Ratios& ratios, LineFinder& lines,
                          const RatioHop& hop) {
  looked_ = false;
  // A quiet axis may hear nothing but noise and folded lines: where no floor was learned, all together must be high.
  const bool full = std::min(ratios.worst, ratios.joint) >= chatterRatio_;
  const double least = sidedRatio() * (highTurns_ > 0.0 ? kHysteresis : 1.0);
  const bool steady = hop.phase == CutPhase::Steady;
  if (!(full || (ratios.joint >= least && !wasCalm_)) || !(steady || hop.phase == CutPhase::Exit)) {
    highTurns_ = 0.0;
    sinceLook_ = kLookHops;
    return false;
  }
  // Chatter that beats goes through its lows as well, where the tool might leave, and drowns now and then what the
  // speed is followed by: that does not count, and takes nothing away.
  if (!steady || hop.steadyTurns < kSettleTurns) return false;
  if (++sinceLook_ < kLookHops) return false;
  sinceLook_ = 0;
  looked_ = true;
  line_ = lines.find(hop.spindle * 0.5, hop.highest);
  const bool stands = lineStands(line_, hop);
  const bool sided = stands && !wasCalm_ && lineHasSides(lines, hop);
  const bool same = std::abs(line_.frequency.value - entryLine_.value) < kSameLine * hop.spindle.value;
  if (stands && !sided) {
    const bool moves = hop.levelTrend > kSettled || hop.levelTrend * kSettled < 1.0;
    if (moves || !full || !aboveCalm(channels, *hop.chain)) return false;
  }
  entryLine_ = line_.frequency;
  entrySided_ = sided;
  entryMost_ = std::max(highTurns_ > 0.0 ? entryMost_ : 0.0, ratios.joint);
  const bool falls = sided && ratios.joint < kRingsDown * entryMost_;
  highTurns_ = stands && same && !falls ? highTurns_ + static_cast<double>(kLookHops) / kHopsPerTurn : 0.0;
  if (highTurns_ <= leastTurns(hop.spindle)) return false;
  sided_ = sided;
  return true;
}

// Has the line side lines? Two modes that chatter take turns in being the stronger one: the one that was followed is
// taken where it still is there, for what it was.
bool EntryChatter::lineHasSides(const LineFinder& lines, const RatioHop& hop) {
  if (highTurns_ > 0.0) {
    const Hertz kept = lines.keep(entryLine_, line_.frequency, hop.spindle * kSameLine);
    const bool another = kept.value != line_.frequency.value;
    line_.frequency = kept;
    if (another) return entrySided_;
  }
  return lines.sideLines(line_.frequency, hop.spindle * hop.teeth) >= kSideLines;
}

}  // namespace stillcut::detect
