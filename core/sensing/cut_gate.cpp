#include "core/sensing/cut_gate.h"

#include <algorithm>
#include <cmath>

namespace stillcut::detect {
namespace {

constexpr double kFloorSeconds = 0.2;   // level over which the floor is taken: tonal hum beats inside it
constexpr double kBegins = 0.3;         // s; of a recording, in which ...
constexpr double kFromSilence = 1e6;    // ... 60 dB over the floor is the first sound after silence, and no cut
constexpr double kCloseRelative = 0.6;  // the gate closes at this part of its opening level
constexpr double kEntryTurns = 8.0;     // shortest entry
constexpr double kSlowTurns = 6.0;      // memory against which entry and exit are seen
constexpr double kSettled = 1.6;        // 2 dB: the level no longer moves
constexpr double kLeaps = 4.0;          // 6 dB up within the memory: more than chatter makes before it is heard
constexpr double kFalling = 0.5;        // 3 dB down within the memory: the tool leaves
constexpr double kStayTurns = 3.0;    // a level that falls stands still for a moment, and the tool leaves all the same
constexpr double kStillTurns = 20.0;  // ... but not for so long: a cut that goes on with less is no exit
constexpr double kCutsOn = 2.0;       // times the level that opens the gate
constexpr double kLongTurns = 40.0;   // memory against which a slow exit is seen ...
constexpr double kSinking = 0.35;     // ... 4.5 dB down
constexpr double kLongestEntry = 120.0;  // turns; then whatever is there counts as the cut

// First-order follower, exact for any step.
void follow(double& state, double target, double step, double timeConstant) {
  state += (1.0 - std::exp(-step / timeConstant)) * (target - state);
}

}  // namespace

void CutGate::prepare(const CutSetup& setup) {
  channels_ = std::min<std::size_t>(setup.channels.size(), kMaxChannels);
  reset();
}

void CutGate::reset() noexcept {
  fast_ = {};
  floor_ = {};
  cutFloor_ = {};
  calm_ = {};
  slow_ = long_ = level_ = elapsed_ = sinceChange_ = quiet_ = settled_ = whole_ = louder_ = still_ = stillAt_ = 0.0;
  airSeen_ = forced_ = speedKnown_ = false;
  phase_ = CutPhase::AirCutting;
}

void CutGate::go(CutPhase phase) noexcept {
  if (phase == phase_) return;
  phase_ = phase;
  sinceChange_ = 0.0;
}

void CutGate::learnFloor(std::span<const double> meanSquares, double seconds) noexcept {
  // A growing memory at first, so that the floor is a mean and not one lucky block.
  const double memory = std::clamp(elapsed_, 2.0 * seconds, kFloorSeconds);
  for (std::size_t c = 0; c < channels_; ++c) {
    const bool young = elapsed_ < 0.25 * kFloorSeconds;
    // The first block may be longer than that, and digital silence is no level to compare with.
    if (!young && floor_[c] <= 0.0) {
      calm_[c] = floor_[c] = meanSquares[c];
      continue;
    }
    // What begins with silence, as compressed sound does, has shown no air yet.
    if (elapsed_ < kBegins && meanSquares[c] > kFromSilence * floor_[c]) calm_[c] = floor_[c] = meanSquares[c];
    follow(calm_[c], meanSquares[c], seconds, memory);
    floor_[c] = young ? calm_[c] : std::min(floor_[c], calm_[c]);
  }
}

// What is loud within a cut that no air was heard before is chatter, and no proof that its floor was air. There air is
// heard when the tool leaves: the floor falls as far as a cut is above it. It falls from where it was in the steady
// cut; what a tool that is in the material at once shakes loose is far above that.
void CutGate::hearAir() noexcept {
  if (phase_ == CutPhase::AirCutting && level_ > openRatio_) airSeen_ = true;
  for (std::size_t c = 0; c < channels_ && phase_ == CutPhase::Exit; ++c) {
    if (floor_[c] * openRatio_ < cutFloor_[c]) airSeen_ = true;
  }
}

CutPhase CutGate::next(double revolution) const noexcept {
  const bool loud = level_ > openRatio_ * (phase_ == CutPhase::AirCutting ? 1.0 : kCloseRelative);
  const bool cutting = loud || (forced_ && !airSeen_);
  if (!cutting && quiet_ > revolution) return CutPhase::AirCutting;
  if (phase_ == CutPhase::AirCutting) return cutting ? CutPhase::Entry : CutPhase::AirCutting;
  const double fast = level_;
  const bool settled = settled_ > 0.0;
  if (phase_ == CutPhase::Entry || phase_ == CutPhase::RunUp) {
    const double turns = sinceChange_ / revolution;
    if (!speedKnown_) return turns > kLongestEntry ? CutPhase::RunUp : phase_;
    if (phase_ == CutPhase::RunUp) return CutPhase::Entry;
    return turns > kEntryTurns && (settled || turns > kLongestEntry) ? CutPhase::Steady : CutPhase::Entry;
  }
  // A spindle whose own sound lies on its teeth was no cut yet: this is where the tool enters.
  if (phase_ == CutPhase::Steady && !airSeen_ && level_ > kLeaps * slow_) return CutPhase::Entry;
  if (phase_ == CutPhase::Exit && still_ > kStillTurns * revolution) return CutPhase::Steady;
  if (fast < kFalling * slow_ || fast < kSinking * long_) return CutPhase::Exit;
  if (phase_ == CutPhase::Exit && std::max(settled_, louder_) > kStayTurns * revolution) return CutPhase::Steady;
  return phase_;
}

void CutGate::advance(std::span<const double> meanSquares, Seconds seconds, Seconds revolution) noexcept {
  const double dt = seconds.value;
  elapsed_ += dt;
  sinceChange_ += dt;
  learnFloor(meanSquares, dt);
  level_ = 0.0;
  for (std::size_t c = 0; c < channels_; ++c) {
    follow(fast_[c], meanSquares[c], dt, std::max(revolution.value, dt));
    if (floor_[c] > 0.0) level_ = std::max(level_, fast_[c] / floor_[c]);
  }
  if (elapsed_ < 0.25 * kFloorSeconds) {
    slow_ = long_ = level_;
    return;
  }
  const double limit = openRatio_ * kCloseRelative;
  quiet_ = level_ < limit ? quiet_ + dt : 0.0;
  hearAir();
  const bool settled = level_ < kSettled * slow_ && slow_ < kSettled * level_;
  settled_ = settled ? settled_ + dt : 0.0;
  louder_ = phase_ == CutPhase::Exit && level_ > whole_ ? louder_ + dt : 0.0;
  const bool cuts = phase_ == CutPhase::Exit && level_ > kCutsOn * openRatio_;
  const bool stands = cuts && level_ < kSettled * stillAt_ && stillAt_ < kSettled * level_;
  still_ = stands ? still_ + dt : 0.0;
  if (!stands) stillAt_ = level_;
  const CutPhase before = phase_;
  const double steady = sinceChange_;
  go(next(revolution.value));
  if (before == CutPhase::AirCutting && phase_ == CutPhase::Entry) {
    slow_ = level_;
    cutFloor_ = floor_;
  }
  if (before == CutPhase::Steady && phase_ == CutPhase::Exit) whole_ = std::max(slow_, long_);
  if (before == CutPhase::Steady && phase_ != CutPhase::Steady && steady > kFloorSeconds) cutFloor_ = floor_;
  // A cut that goes on with less has not left; what it was before is no measure any more.
  if (before == CutPhase::Exit && phase_ == CutPhase::Steady) {
    long_ = level_;
    slow_ = std::min(slow_, level_);
  }
  follow(slow_, level_, dt, kSlowTurns * std::max(revolution.value, dt));
  if (phase_ == CutPhase::Entry || phase_ == CutPhase::RunUp) long_ = slow_;
  follow(long_, level_, dt, kLongTurns * std::max(revolution.value, dt));
}

}  // namespace stillcut::detect
