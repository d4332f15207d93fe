#include "core/safety/flight_recorder.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace stillcut::safety {
namespace {

constexpr double kMostEntries = 20000.0;

std::string_view kindName(RequestKind k) {
  constexpr std::array<std::string_view, 4> kNames{"none", "set", "hold", "release"};
  const auto i = static_cast<std::size_t>(k);
  return i < kNames.size() ? kNames[i] : "?";
}

std::string flags(const MachineState& m) {
  std::string s;
  if (!m.valid) s += " invalid";
  if (!m.linkUp) s += " link-down";
  if (!m.programRunning) s += " no-program";
  if (m.feedHold) s += " feed-hold";
  if (!m.atSpeed) s += " not-at-speed";
  if (!m.overridesEnabled) s += " locked";
  if (!m.controlOurs) s += " not-ours";
  if (m.block != OverrideInhibit::None) s += " " + std::string(name(m.block));
  return s.empty() ? " ok" : s;
}

std::string line(const FlightEntry& e, Instant zero) {
  char head[160];
  std::snprintf(head, sizeof head, "%9.3f  %-6s %-7s %-7s %8.1f Hz er %.3f", secondsBetween(zero, e.time).value,
                std::string(name(e.authority)).c_str(), e.verdict.valid ? "valid" : "invalid",
                std::string(name(e.verdict.state)).c_str(), e.verdict.frequency.value, e.verdict.severity.value);
  char wish[120];
  std::snprintf(wish, sizeof wish, " | %-7s %8.0f rpm %7.0f mm/min", std::string(kindName(e.request.kind)).c_str(),
                e.request.speed.value, toMmPerMin(e.request.feed));
  char command[120];
  if (!e.hasCommand) {
    std::snprintf(command, sizeof command, " | no command            ");
  } else if (e.command.kind == CommandKind::Release) {
    std::snprintf(command, sizeof command, " | release               ");
  } else {
    std::snprintf(command, sizeof command, " | speed %5.1f %% feed %5.1f %%", 100.0 * e.command.speed.value,
                  100.0 * e.command.feed.value);
  }
  char machine[200];
  std::snprintf(machine, sizeof machine,
                " | %8.0f of %.0f rpm, knobs %.0f/%.0f %%, overrides %.0f/%.0f %%, age %.3f s,",
                e.machine.actualSpeed.value, e.machine.programmedSpeed.value, 100.0 * e.machine.operatorSpeed.value,
                100.0 * e.machine.operatorFeed.value, 100.0 * e.machine.speedOverride.value,
                100.0 * e.machine.feedOverride.value, secondsBetween(e.machine.time, e.time).value);
  std::string s = std::string(head) + wish + command + machine + flags(e.machine);
  if (e.gate.code != ReasonCode::None) s += " | " + sentence(e.gate);
  if (!e.verdict.valid && e.verdict.reason.code != ReasonCode::None) s += " | " + sentence(e.verdict.reason);
  return s;
}

}  // namespace

FlightEntry flightEntry(const GateInput& in, const GateOutput& out) STILLCUT_RT {
  FlightEntry e;
  e.time = in.now;
  e.verdict = in.verdict;
  e.request = in.request;
  e.machine = in.machine;
  e.authority = out.authority;
  e.gate = out.reason;
  e.hasCommand = out.command.has_value();
  if (out.command) e.command = out.command->record();
  return e;
}

void FlightRecorder::prepare(Seconds blockLength) {
  const double blocks = blockLength.value > 0.0 ? std::ceil(kSpan / blockLength.value) : kMostEntries;
  span_ = static_cast<std::size_t>(std::clamp(blocks, 1.0, kMostEntries));
  ring_.assign(span_ + span_ / 4 + 1, FlightEntry{});
  pushed_ = 0;
  slots_ = std::make_unique<Slot[]>(kSlots);
  for (int i = 0; i < kSlots; ++i) slots_[static_cast<std::size_t>(i)].entries.resize(span_);
  write_ = copying_ = begun_ = 0;
  read_ = 0;
  missed_ = 0;
  missedTold_ = 0;
}

void FlightRecorder::push(const FlightEntry& entry) STILLCUT_RT {
  if (ring_.empty()) return;
  ring_[pushed_ % ring_.size()] = entry;
  ++pushed_;
  copyPortion();
}

bool FlightRecorder::capture(const Reason& cause, Instant now) STILLCUT_RT {
  if (ring_.empty()) return false;
  Slot& slot = slots_[static_cast<std::size_t>(write_)];
  if (begun_ == kSlots || slot.full.load(std::memory_order_acquire)) {
    missed_.fetch_add(1, std::memory_order_relaxed);
    return false;
  }
  slot.time = now;
  slot.cause = cause;
  slot.count = std::min(pushed_, span_);
  slot.first = pushed_ - slot.count;
  slot.copied = 0;
  write_ = (write_ + 1) % kSlots;
  ++begun_;
  copyPortion();
  return true;
}

void FlightRecorder::copyPortion() STILLCUT_RT {
  if (begun_ == 0) return;
  Slot& slot = slots_[static_cast<std::size_t>(copying_)];
  for (std::size_t i = 0; i < kPortion && slot.copied < slot.count; ++i, ++slot.copied) {
    slot.entries[slot.copied] = ring_[(slot.first + slot.copied) % ring_.size()];
  }
  if (slot.copied < slot.count) return;
  slot.full.store(true, std::memory_order_release);
  copying_ = (copying_ + 1) % kSlots;
  --begun_;
}

void FlightRecorder::finish() {
  while (begun_ > 0) copyPortion();
}

bool FlightRecorder::take(FlightRecording& into) {
  if (slots_ == nullptr) return false;
  Slot& slot = slots_[static_cast<std::size_t>(read_)];
  if (!slot.full.load(std::memory_order_acquire)) return false;
  into.time = slot.time;
  into.cause = slot.cause;
  into.missed = missed() - missedTold_;
  missedTold_ += into.missed;
  into.entries.assign(slot.entries.begin(), slot.entries.begin() + static_cast<std::ptrdiff_t>(slot.count));
  slot.full.store(false, std::memory_order_release);
  read_ = (read_ + 1) % kSlots;
  return true;
}

std::string render(const FlightRecording& recording) {
  char head[200];
  const double span =
      recording.entries.empty() ? 0.0 : secondsBetween(recording.entries.front().time, recording.time).value;
  std::snprintf(head, sizeof head, "Flight recording at %.3f s of the stream, the %.1f s before it\n",
                sinceEpoch(recording.time).value, span);
  std::string text = std::string(head) + "Cause: " + sentence(recording.cause) + "\n";
  if (recording.missed > 0) {
    text += std::to_string(recording.missed) + " more causes found no room for a recording of their own\n";
  }
  text += "   time s  authority, verdict | request | command | machine | why\n";
  for (const FlightEntry& e : recording.entries) text += line(e, recording.time) + "\n";
  return text;
}

}  // namespace stillcut::safety
