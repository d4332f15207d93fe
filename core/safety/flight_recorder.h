// FlightRecorder: the last seconds of verdicts, requests, commands and machine states, always. A fault, a refusal or a
// change of authority keeps a copy (GateOutput::flight), which another thread takes and writes as text.
// Thread: push() and capture() on the worker, real-time; take() and render() on one other thread.
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
};

class FlightRecorder {
 public:
  static constexpr double kSpan = 10.0;  // [s] kept
  static constexpr int kSlots = 3;       // recordings that may wait to be taken

  // Set-up: room for kSpan of blocks of this length (at most 20000 of them). Forgets everything.
  void prepare(Seconds blockLength);
  void push(const FlightEntry& entry) STILLCUT_RT;
  // Copies what there is. False, and counted, when every slot still waits to be taken.
  bool capture(const Reason& cause, Instant now) STILLCUT_RT;
  // Moves the oldest waiting recording out; false when there is none. Allocates.
  bool take(FlightRecording& into);
  std::uint64_t missed() const STILLCUT_RT { return missed_.load(std::memory_order_relaxed); }

 private:
  struct Slot {
    std::atomic<bool> full{false};
    Instant time{};
    Reason cause;
    std::size_t count = 0;
    std::vector<FlightEntry> entries;
  };

  std::vector<FlightEntry> ring_;
  std::size_t pushed_ = 0;
  std::unique_ptr<Slot[]> slots_;
  int write_ = 0;  // worker
  int read_ = 0;   // taker
  std::atomic<std::uint64_t> missed_{0};
};

// One line per step, times relative to the cause, with a heading a person understands.
std::string render(const FlightRecording& recording);

}  // namespace stillcut::safety
