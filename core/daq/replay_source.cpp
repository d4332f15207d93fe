#include "core/daq/replay_source.h"

#include <cmath>
#include <exception>
#include <utility>

namespace stillcut::daq {

ReplaySource::ReplaySource(std::unique_ptr<record::RecordingReader> reader, const ReplayOptions& options)
    : reader_(std::move(reader)), options_(options) {}

Result<SourceFormat> ReplaySource::open() {
  const record::RecordingFormat& recorded = reader_->format();
  if (!std::isfinite(options_.pace) || options_.pace < 0.0 || (options_.pace > 0.0 && options_.clock == nullptr)) {
    return Error{"replay", "the pace must be zero (as fast as possible) or above, with a clock", ""};
  }
  SourceFormat format;
  format.rate = recorded.rate;
  format.blockFrames = recorded.blockFrames > 0 ? recorded.blockFrames : options_.blockFrames;
  if (format.blockFrames < 1) return Error{"replay", "a block needs at least one frame", ""};
  for (const record::RecordedChannel& channel : recorded.channels) format.channels.push_back(channel.info);
  return format;
}

bool ReplaySource::read(SampleBlock& block) noexcept {
  if (stopped_.load() || !fault_.empty()) return false;
  try {
    const Result<bool> more = reader_->read(block);
    if (!more) {
      fault_ = more.error().line();
      return false;
    }
    return *more && waitFor(block);
  } catch (const std::exception& problem) {  // memory, from the libraries below
    fault_ = problem.what();
    return false;
  }
}

// A block exists when its last sample does. False: stopped meanwhile.
bool ReplaySource::waitFor(const SampleBlock& block) noexcept {
  if (options_.pace <= 0.0) return true;
  if (!started_) {
    started_ = true;
    startedAt_ = options_.clock->now();
    firstSample_ = block.firstSample;
  }
  const Seconds due = secondsBetween(firstSample_, block.end()) / options_.pace;
  while (!stopped_.load()) {
    const Seconds left = due - secondsBetween(startedAt_, options_.clock->now());
    if (left.value <= 0.0) return true;
    wakeup_.waitFor(left);
  }
  return false;
}

void ReplaySource::stop() noexcept {
  stopped_.store(true);
  wakeup_.notify();
}

const StepInput* ReplaySource::recordedStep() const {
  const StepRecord* step = reader_->recordedStep();
  return step != nullptr ? &step->input : nullptr;
}

}  // namespace stillcut::daq
