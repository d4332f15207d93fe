// Air, entry, steady cut, exit told apart from the level of the signal (a cut gate is part of Caliskan's method: its
// ratio is high in air, and entry and exit are to be disregarded).
//
// A tool that leaves does not make the cut louder than it was: vibration in a narrow band falls now and then, and where
// it then grows, it is growth in the cut.
//
// The air floor is the lowest level seen; a cut is 6 dB above it. A recording that starts inside a cut has no air to
// compare with: then forced vibration found at the teeth (told by the speed tracker) opens the gate.
// Thread: worker; everything but prepare() is real-time.
#pragma once

#include <array>
#include <span>

#include "core/model/cut_setup.h"
#include "core/sensing/conditioned_block.h"

namespace stillcut::detect {

class CutGate {
 public:
  void prepare(const CutSetup& setup);
  // Mean square of a cut over that of air.
  void setOpenRatio(double ratio) noexcept { openRatio_ = ratio; }
  void reset() noexcept;

  // Mean squares of the channels over `seconds`; `revolution` is the present length of one turn.
  void advance(std::span<const double> meanSquares, Seconds seconds, Seconds revolution) noexcept;
  // The tracker found forced vibration at the teeth, or a speed at all.
  void setForced(bool forced) noexcept { forced_ = forced; }
  void setSpeedKnown(bool known) noexcept { speedKnown_ = known; }

  CutPhase phase() const noexcept { return phase_; }
  bool inCut() const noexcept { return phase_ != CutPhase::AirCutting; }
  bool airSeen() const noexcept { return airSeen_; }
  // Mean square of a channel in air; 0 until learned.
  double airFloor(int channel) const noexcept { return airSeen_ ? floor_[static_cast<std::size_t>(channel)] : 0.0; }
  // Of the last turn over the last few: what grows is above 1, a tool that leaves well below.
  double trend() const noexcept { return slow_ > 0.0 ? level_ / slow_ : 1.0; }
  double level() const noexcept { return level_; }  // mean square over the floor, loudest channel

 private:
  void go(CutPhase phase) noexcept;
  void hearAir() noexcept;
  void learnFloor(std::span<const double> meanSquares, double seconds) noexcept;
  CutPhase next(double revolution) const noexcept;

  double openRatio_ = 4.0;
  std::size_t channels_ = 0;
  std::array<double, kMaxChannels> fast_{};      // one turn
  std::array<double, kMaxChannels> floor_{};     // lowest 0.2 s level
  std::array<double, kMaxChannels> cutFloor_{};  // when the cut began or, later, when it began to fall
  std::array<double, kMaxChannels> calm_{};      // 0.2 s level
  double slow_ = 0.0;                            // fast level followed over several turns
  double long_ = 0.0;                            // ... over many
  double level_ = 0.0;
  double elapsed_ = 0.0;
  double sinceChange_ = 0.0;
  double quiet_ = 0.0;    // how long the level has been below the limit
  double settled_ = 0.0;  // how long it has not moved
  double whole_ = 0.0;    // level from which it fell, in an exit
  double louder_ = 0.0;   // how long it has been above that since
  double still_ = 0.0;    // how long, in an exit, the level has stood where it was ...
  double stillAt_ = 0.0;  // ... here
  bool airSeen_ = false;
  bool forced_ = false;
  bool speedKnown_ = false;
  CutPhase phase_ = CutPhase::AirCutting;
};

}  // namespace stillcut::detect
