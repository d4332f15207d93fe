// Verdict: what a detector says after one block. Plain values: any thread.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/base/time.h"
#include "core/base/units.h"
#include "core/model/reason.h"

namespace stillcut {

enum class CutState : std::uint8_t { AirCutting, Stable, Onset, Chatter };
enum class CutPhase : std::uint8_t { AirCutting, RunUp, Entry, Steady, Exit };
enum class ChatterKind : std::uint8_t { Unknown, Hopf, Flip, Forced };

// Names as files spell them: "air", "stable", "onset", "chatter"; "air", "runup", "entry", ...; "hopf", ...
std::string_view name(CutState s);
std::string_view name(CutPhase p);
std::string_view name(ChatterKind k);

inline constexpr int kMaxIndicators = 8;

// Plain value, trivially copyable. An invalid verdict never means "stable": read `valid` first, `reason` says why.
struct Verdict {
  Instant time{};  // of the last sample used
  std::uint64_t blockSequence = 0;
  CutState state = CutState::AirCutting;
  CutPhase phase = CutPhase::AirCutting;
  ChatterKind kind = ChatterKind::Unknown;
  bool valid = false;
  bool earlyWarning = false;
  Reason reason;
  Hertz frequency{};                                // dominant chatter frequency; 0: none
  Hertz frequencySd{};                              // its standard deviation
  Ratio severity{};                                 // energy ratio, chatter to total, 0..1
  Hertz spindle{};                                  // spindle frequency used
  Seconds sinceOnset{};                             // 0 unless onset or chatter
  Metres feedSinceOnset{};                          // length of path marked since onset, where the feed is known
  std::array<double, kMaxIndicators> indicators{};  // named by the detector's describe(), for series and screens

  bool alarming() const { return valid && (state == CutState::Onset || state == CutState::Chatter); }
};

}  // namespace stillcut
