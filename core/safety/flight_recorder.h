// FlightRecorder: the last seconds of verdicts, requests, commands and machine states, always. A fault, a refusal or a
// change of authority keeps a copy (GateOutput::flight), which another thread takes and writes as text. Ten seconds are
// a megabyte: the copy is made in portions, one a step, from a ring that is a quarter longer than what is copied, so
// that no step costs more than kPortion entries. Thread: push() and capture() on the worker, real-time; take() and
// render() on one other thread; finish() on any once the worker has stopped.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "core/base/realtime.h"
#include "core/safety/gate_io.h"

namespace stillcut::safety {

struct FlightEntry {
  Instant time{};
  Verdict verdict;
  OverrideRequest request;
  MachineState machine;
  Authority authority = Authority::Off;
  Reason gate;
  bool hasCommand = false;
  CommandRecord command;
};

FlightEntry flightEntry(const GateInput& in, const GateOutput& out) STILLCUT_RT;

struct FlightRecording {
  Instant time{};
  Reason cause;
  std::vector<FlightEntry> entries;  // oldest first
  std::uint64_t missed = 0;          // recordings since the one before that found no room
};

class FlightRecorder {
 public:
  static constexpr double kSpan = 10.0;  // [s] kept
  static constexpr int kSlots = 3;       // recordings that may wait to be taken
  static constexpr std::size_t kPortion = 128;

  // Set-up: room for kSpan of blocks of this length (at most 20000 of them). Forgets everything.
  void prepare(Seconds blockLength);
  void push(const FlightEntry& entry) STILLCUT_RT;
  // Keeps what there is; it can be taken when the steps that follow have copied it. False, and counted, when every slot
  // still waits to be taken.
  bool capture(const Reason& cause, Instant now) STILLCUT_RT;
  // No step follows: copies what is left to be copied.
  void finish();
  // Moves the oldest waiting recording out; false when there is none. Allocates.
  bool take(FlightRecording& into);
  std::uint64_t missed() const STILLCUT_RT { return missed_.load(std::memory_order_relaxed); }

 private:
  struct Slot {
    std::atomic<bool> full{false};
    Instant time{};
    Reason cause;
    std::size_t first = 0;   // number of its oldest entry
    std::size_t count = 0;   // entries it shall have
    std::size_t copied = 0;  // entries it has
    std::vector<FlightEntry> entries;
  };

  void copyPortion() STILLCUT_RT;

  std::vector<FlightEntry> ring_;
  std::size_t span_ = 0;  // entries kept
  std::size_t pushed_ = 0;
  std::unique_ptr<Slot[]> slots_;
  int write_ = 0;                 // worker: the next slot to take
  int copying_ = 0;               // worker: the oldest slot that is not complete
  int begun_ = 0;                 // worker: slots from copying_ on that have been taken
  int read_ = 0;                  // taker
  std::uint64_t missedTold_ = 0;  // taker
  std::atomic<std::uint64_t> missed_{0};
};

// One line per step, times relative to the cause, with a heading a person understands.
std::string render(const FlightRecording& recording);

}  // namespace stillcut::safety
