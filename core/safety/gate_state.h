// The gate's one state, and what may follow what. Every command hangs on it: a Set is sent in Engaged, Returning and
// LettingGo and in no other state, a Release in OwesRelease and in no other. There is no way from LettingGo or
// OwesRelease back to Engaged that does not go through a Release and Idle.
//
//   state        what is in force      each step, all input being well         each step with trouble
//   Idle         nothing of ours       ask, or take the overrides              nothing, and say why
//   Engaged      a Set                 follow the wish by the ramp             hold; after gate.hold-time give up
//   Returning    a Set                 to 100 % at the slow rate, by a wish    hold; after gate.hold-time give up
//   LettingGo    a Set                 to 100 % at full rate, whoever wishes   the same, or drop where nothing can be
//                                                                              steered
//   OwesRelease  what was dropped      send the Release                        send the Release
//
// Plain values: any thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace stillcut::safety {

enum class GateState : std::uint8_t { Idle, Engaged, Returning, LettingGo, OwesRelease };
inline constexpr std::size_t kGateStates = 5;

// What happens to it.
enum class GateCause : std::uint8_t {
  Takes,    // the overrides are taken
  Follows,  // a wish for a speed, or to stay
  Returns,  // a wish for 100 %
  GivesUp,  // somebody or something wants the programmed values, and the machine can be steered there
  Drops,    // at 100 %, or where nothing can be steered any more
  Sends,    // the Release is out
  Recalls,  // the operator wants what an earlier run may have left in force to be released
};
inline constexpr std::size_t kGateCauses = 7;

constexpr GateState after(GateState state, GateCause cause) noexcept {
  using enum GateState;
  constexpr std::array<std::array<GateState, kGateCauses>, kGateStates> kTable{{
      // clang-format off
      //                Takes        Follows      Returns      GivesUp      Drops        Sends        Recalls
      /* Idle */        {Engaged,     Idle,        Idle,        Idle,        Idle,        Idle,        OwesRelease},
      /* Engaged */     {Engaged,     Engaged,     Returning,   LettingGo,   OwesRelease, Engaged,     Engaged},
      /* Returning */   {Returning,   Engaged,     Returning,   LettingGo,   OwesRelease, Returning,   Returning},
      /* LettingGo */   {LettingGo,   LettingGo,   LettingGo,   LettingGo,   OwesRelease, LettingGo,   LettingGo},
      /* OwesRelease */ {OwesRelease, OwesRelease, OwesRelease, OwesRelease, OwesRelease, Idle,        OwesRelease},
      // clang-format on
  }};
  return kTable[static_cast<std::size_t>(state)][static_cast<std::size_t>(cause)];
}

// A Set of ours is in force.
constexpr bool commands(GateState state) noexcept {
  return state == GateState::Engaged || state == GateState::Returning || state == GateState::LettingGo;
}

}  // namespace stillcut::safety
