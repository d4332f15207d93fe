#include "core/daq/replay_source.h"

#include <cmath>
#include <exception>
#include <utility>

namespace stillcut::daq {
namespace {

constexpr Seconds kLookAgain{1.0};  // while paused; every change wakes it before

}  // namespace

ReplaySource::ReplaySource(std::unique_ptr<record::RecordingReader> reader, const ReplayOptions& options)
    : reader_(std::move(reader)), options_(options), control_(options.control) {
  if (!control_) {
    control_ = std::make_shared<ReplayControl>();
    control_->setPace(options.pace);
  }
}

Result<SourceFormat> ReplaySource::open() {
  const record::RecordingFormat& recorded = reader_->format();
  const bool timed = options_.pace > 0.0 || options_.control;
  if (!std::isfinite(options_.pace) || options_.pace < 0.0 || (timed && options_.clock == nullptr)) {
    return Error{message("replay"), message("the pace must be zero (as fast as possible) or above, with a clock")};
  }
  SourceFormat format;
  format.rate = recorded.rate;
  format.blockFrames = recorded.blockFrames > 0 ? recorded.blockFrames : options_.blockFrames;
  if (format.blockFrames < 1) return Error{message("replay"), message("a block needs at least one frame")};
  for (const record::RecordedChannel& channel : recorded.channels) format.channels.push_back(channel.info);
  return format;
}

bool ReplaySource::read(SampleBlock& block) noexcept {
  if (stopped_.load() || !fault_.empty()) return false;
  try {
    return waitForTurn() && next(block) && waitFor(block);
  } catch (const std::exception& problem) {  // memory, from the libraries below
    fault_ = foreign(problem.what());
    return false;
  }
}

// Until the block may go out. False: stopped meanwhile.
bool ReplaySource::waitForTurn() noexcept {
  while (!stopped_.load()) {
    if (control_->mayGo()) return true;
    pace_ = 0.0;  // begins anew after the pause
    control_->waitFor(kLookAgain);
  }
  return false;
}

bool ReplaySource::next(SampleBlock& block) {
  if (const auto place = control_->takeGoTo()) {
    if (!started_) {  // where the recording begins is known from its first block
      const Result<bool> first = reader_->read(block);
      if (first && *first) recordedBegin_ = block.firstSample;
      started_ = first && *first;
    }
    if (!jump(*place)) return false;
  }
  const ReplayControl::Loop loop = control_->loop();
  if (loop.on && recorded_ && *recorded_ >= loop.to && !jump(loop.from)) return false;
  while (true) {
    const Result<bool> more = reader_->read(block);
    if (!more) {
      fault_ = more.error().asMessage();
      return false;
    }
    if (!*more && loop.on && recorded_ && *recorded_ > loop.from) {  // its end lies behind the recording's
      if (!jump(loop.from)) return false;
      continue;
    }
    if (!*more) return false;
    if (!started_) recordedBegin_ = block.firstSample;
    started_ = true;
    if (skipping_ && secondsBetween(recordedBegin_, block.end()) <= wanted_) continue;
    skipping_ = false;
    if (loop.on) block.flags &= ~kBlockEnd;
    recorded_ = secondsBetween(recordedBegin_, block.end());
    place(block);
    return true;
  }
}

// False: fault_ says why.
bool ReplaySource::jump(Seconds to) {
  const Instant place = recordedBegin_ + toDuration(to);
  Result<bool> found = started_ ? reader_->seek(place) : Result<bool>(false);
  if (found && !*found) {  // from the beginning, unless it lies ahead
    const bool ahead = recorded_ && *recorded_ <= to;
    if (!ahead && !options_.reopen) found = Error{message("replay"), message("this recording cannot be gone back in")};
    if (!ahead && options_.reopen) {
      auto again = options_.reopen();
      if (again) {
        reader_ = std::move(*again);
      } else {
        found = again.error();
      }
    }
    skipping_ = true;
    wanted_ = to;
  }
  if (!found) fault_ = found.error().asMessage();
  jumped_ = recorded_.has_value();
  return found.ok();
}

// A jump moves all that follows behind what was handed out before it.
void ReplaySource::place(SampleBlock& block) noexcept {
  if (jumped_) {
    jumped_ = false;
    shift_ = end_ - block.firstSample;
    sequenceShift_ = static_cast<std::int64_t>(sequence_ + 1 - block.sequence);
    block.flags |= kBlockGap;
    block.lostFrames = 0;
  }
  block.firstSample += shift_;
  block.sequence += static_cast<std::uint64_t>(sequenceShift_);
  end_ = block.end();
  sequence_ = block.sequence;
}

// A block exists when its last sample does. False: stopped meanwhile.
bool ReplaySource::waitFor(const SampleBlock& block) noexcept {
  while (!stopped_.load()) {
    const double pace = control_->paused() ? 0.0 : control_->pace();  // single steps are not waited for
    if (pace <= 0.0) {
      pace_ = 0.0;
      break;
    }
    const Instant now = options_.clock->now();
    if (pace != pace_) {
      pace_ = pace;
      dueFrom_ = now;
      pacedFrom_ = block.firstSample;
    }
    const Seconds left = secondsBetween(pacedFrom_, block.end()) / pace - secondsBetween(dueFrom_, now);
    if (left.value <= 0.0) break;
    control_->waitFor(left);
  }
  if (stopped_.load()) return false;
  control_->tellPosition(*recorded_);
  return true;
}

void ReplaySource::stop() noexcept {
  stopped_.store(true);
  control_->wake();
}

const StepInput* ReplaySource::recordedStep() const {
  const StepRecord* step = reader_->recordedStep();
  return step != nullptr ? &step->input : nullptr;
}

}  // namespace stillcut::daq
