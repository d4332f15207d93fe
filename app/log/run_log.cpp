#include "app/log/run_log.h"

#include <algorithm>
#include <cstdio>

#include "app/compose/left_overrides.h"

namespace stillcut::app {
namespace {

LogLevel levelOf(const Event& event) {
  switch (event.level) {
    case EventLevel::Info:
      return LogLevel::Info;
    case EventLevel::Warning:
      return LogLevel::Warning;
    case EventLevel::Fault:
      break;
  }
  return LogLevel::Error;
}

}  // namespace

void RunLog::begin(Rig& rig, const std::string& origin) {
  const daq::SourceFormat& format = rig.deviceFormat();
  char channels[64];
  std::snprintf(channels, sizeof channels, "%zu channels at %.6g Hz", format.channels.size(), format.rate.value);
  log_.write(LogLevel::Info, "run begins: " + origin + ", " + channels);
  if (!format.doubt.empty()) log_.write(LogLevel::Warning, "device: " + text(format.doubt));
  log_.write(LogLevel::Info,
             rig.hasLink() ? "machine: " + std::string(rig.linkInfo().label) : "no machine is connected");
  if (rig.recorder() != nullptr) log_.write(LogLevel::Info, "recording: " + rig.recorder()->status().path);
}

void RunLog::look(Rig& rig, const Snapshot* snapshot) {
  if (snapshot != nullptr) {
    events(*snapshot);
    if (rig.hasLink()) link(snapshot->machine);
  }
  if (const auto left = rig.leftInMachine(); left && !leftTold_) {
    leftTold_ = true;
    log_.write(LogLevel::Warning, text(leftSentence(*left)));
  }
  const std::string trouble = text(rig.device().trouble());
  if (trouble != trouble_) {
    trouble_ = trouble;
    log_.write(LogLevel::Warning, "device: " + (trouble.empty() ? std::string("samples come again") : trouble));
  }
  if (recorderFault_ || rig.recorder() == nullptr) return;
  const Message fault = rig.recorder()->status().fault;
  recorderFault_ = !fault.empty();
  if (recorderFault_) log_.write(LogLevel::Error, "recording stopped: " + text(fault));
}

void RunLog::events(const Snapshot& snapshot) {
  const std::uint64_t oldest = snapshot.eventCount > kEventsShown ? snapshot.eventCount - kEventsShown : 0;
  if (oldest > written_) log_.write(LogLevel::Warning, std::to_string(oldest - written_) + " events passed unseen");
  for (written_ = std::max(written_, oldest); written_ < snapshot.eventCount; ++written_) {
    const Event& event = snapshot.events[written_ % kEventsShown];
    log_.write(levelOf(event), sentence(event.reason));
  }
}

void RunLog::link(const MachineState& machine) {
  if (machine.linkUp != linkUp_) {
    linkUp_ = machine.linkUp;
    log_.write(linkUp_ ? LogLevel::Info : LogLevel::Warning, linkUp_ ? "link up" : "link down");
  }
  if (machine.block != inhibit_) {
    inhibit_ = machine.block;
    log_.write(LogLevel::Info, "overrides inhibited by: " + std::string(name(inhibit_)));
  }
}

void RunLog::end(Rig& rig, const Status& recorded) {
  look(rig, rig.read());
  const Message fault = rig.device().fault();
  if (!fault.empty()) log_.write(LogLevel::Error, "device: " + text(fault));
  if (!recorded) log_.write(LogLevel::Error, recorded.error().line());
  log_.write(LogLevel::Info, "run ends");
}

}  // namespace stillcut::app
