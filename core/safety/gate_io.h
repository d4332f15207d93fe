// What goes into the gate and what comes out of it, each block. Plain values, no storage of their own. Thread: worker.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "core/model/event.h"
#include "core/model/machine_state.h"
#include "core/model/operator_input.h"
#include "core/model/override_command.h"
#include "core/model/override_request.h"
#include "core/model/verdict.h"

namespace stillcut::safety {

inline constexpr int kMaxGateEvents = 8;

struct GateInput {
  Instant now{};                // stream time: end of the block
  Seconds dt{};                 // measured time since the previous step
  OverrideRequest request;      // of the strategy in charge
  Verdict verdict;              // of the detector in charge
  MachineState machine;         // newest read
  double vibration = -1.0;      // rms of the first channel, SI; negative: unknown
  bool strategyFailed = false;  // for good: there is nobody whose wishes to follow
  std::span<const OperatorInput> inputs;
};

// The operator's knobs by which absolute wishes are divided while something of ours is in force. A knob that is turned
// then scales what is in force; a strategy that saw it turned would count it twice.
struct WishKnobs {
  Ratio speed{1.0}, feed{1.0};
};

// Whether authority would be given to whoever asks for it. What is none, from a damaged file, is not.
constexpr bool grants(Authority wanted, bool autoAllowed) {
  return wanted == Authority::Auto ? autoAllowed : wanted == Authority::Off || wanted == Authority::Advise;
}

struct GateOutput {
  std::optional<OverrideCommand> command;  // to the link's mailbox; none while nothing is in force
  bool commanding = false;                 // a Set is in force
  Authority authority = Authority::Off;
  Instant authoritySince{};
  bool autoAllowed = false;
  bool adviceOpen = false;         // the request waits for accept or refuse
  std::uint32_t adviceNumber = 0;  // of the one on the desk; accepting needs it
  OverrideRequest advice;          // the one on the desk, as accepting would execute it
  struct Judged {
    MoveOutcome outcome = MoveOutcome::None;
    double timesAsLoud = 0.0;  // vibration over that before the move; 0: not known
    int withoutHelp = 0;       // moves in a row
    bool endsAuto = false;
  };
  Judged judged;  // in this step: what came of a move
  bool operatorHold = false;
  std::optional<WishKnobs> knobs;  // of the next step's wish; none: as the machine tells them
  Reason reason;                   // why the gate does what it does now
  bool flight = false;  // fault, refusal or change of authority: keep the last seconds (FlightRecorder::capture)
  Reason flightCause;   // the first of them in this step
  int eventCount = 0;   // Event::number is left to whoever counts a run's events
  int eventsLost = 0;   // in this step: found no room, the most important were kept
  std::array<Event, kMaxGateEvents> events{};
};

}  // namespace stillcut::safety
