#include "core/session/recorder.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "core/model/block_copy.h"

namespace stillcut::record {
namespace {

constexpr std::size_t kFewestSlots = 64;
constexpr std::size_t kMostSlots = 8192;
constexpr Seconds kPollEvery{0.02};
constexpr std::chrono::milliseconds kToDiskEvery{500};

std::size_t slotsFor(const CutSetup& setup, Seconds buffer) {
  const double steps = std::ceil(buffer.value * setup.rate.value / std::max(1, setup.blockFrames));
  return std::clamp(static_cast<std::size_t>(std::clamp(steps, 1.0, 1e6)), kFewestSlots, kMostSlots);
}

}  // namespace

Result<std::unique_ptr<Recorder>> Recorder::create(const std::string& path, const SessionHeader& header,
                                                   const RecorderOptions& options) {
  Result<std::unique_ptr<SessionWriter>> writer = SessionWriter::create(path, header, {false, true, options.disk});
  if (!writer) return writer.error();
  return create(oneFile(std::move(*writer)), header.setup, options);
}

Result<std::unique_ptr<Recorder>> Recorder::create(const NextPath& nextPath, const SessionHeader& header,
                                                   const RecorderOptions& options) {
  Result<std::unique_ptr<SessionWriter>> writer = createUnderNextName(nextPath, header, {false, true, options.disk});
  if (!writer) return writer.error();
  return create(oneFile(std::move(*writer)), header.setup, options);
}

std::unique_ptr<Recorder> Recorder::stopped(const std::string& path, const Error& why, const CutSetup& setup) {
  RecorderOptions least;
  least.buffer = Seconds(0.0);
  std::unique_ptr<Recorder> recorder(new Recorder(nullptr, setup, least));
  recorder->path_ = path;
  recorder->stopWith(why.asMessage());
  return recorder;
}

std::unique_ptr<Recorder> Recorder::create(std::unique_ptr<StepSink> sink, const CutSetup& setup,
                                           const RecorderOptions& options) {
  return std::unique_ptr<Recorder>(new Recorder(std::move(sink), setup, options));
}

Recorder::Recorder(std::unique_ptr<StepSink> sink, const CutSetup& setup, const RecorderOptions& options)
    : options_(options),
      sink_(std::move(sink)),
      ring_(slotsFor(setup, options.buffer),
            [&setup](StepRecord& slot) {
              slot.input.block.allocate(static_cast<int>(setup.channels.size()), setup.blockFrames);
            }),
      path_(sink_ ? sink_->path() : std::string()) {}

Recorder::~Recorder() {
  (void)finish().ok();
}

void Recorder::startThread() {
  if (thread_) return;
  if (sink_) sink_->setPowerSafe();
  thread_.emplace(rt::ThreadRequest{"recorder"}, [this](const std::stop_token& stop) { run(stop); });
}

bool Recorder::push(const StepInput& input, const StepOutput& output) STILLCUT_RT {
  StepRecord* slot = recording_.load(std::memory_order_relaxed) ? ring_.reserve() : nullptr;
  const SampleBlock& block = input.block;
  if (slot == nullptr || block.channels != slot->input.block.channels ||
      block.frames > slot->input.block.capacityFrames) {
    dropped_.fetch_add(1, std::memory_order_relaxed);
    lostFrames_ += static_cast<std::uint64_t>(block.frames) + block.lostFrames;
    lost_ = true;
    return false;
  }
  copyBlock(block, slot->input.block);
  if (lost_) {
    slot->input.block.flags |= kBlockGap;
    slot->input.block.lostFrames += lostFrames_;
    lost_ = false;
    lostFrames_ = 0;
  }
  slot->input.machine = input.machine;
  slot->input.inputCount = input.inputCount;
  slot->input.inputs = input.inputs;
  slot->output = output;
  ring_.commit();
  return true;
}

bool Recorder::drain() {
  constexpr std::uint64_t kSpaceEvery = 256;
  while (StepRecord* slot = ring_.front()) {
    if (sink_ && written_.load() % kSpaceEvery == 0) {
      if (const Status s = checkSpace(); !s) stopWith(s.error().asMessage());
    }
    if (sink_) {
      if (const Status s = sink_->add(slot->input, slot->output); !s) stopWith(s.error().asMessage());
    }
    (sink_ ? written_ : dropped_).fetch_add(1);
    ring_.pop();
  }
  writing_.store(sink_ != nullptr && sink_->writer() != nullptr);
  return sink_ != nullptr;
}

void Recorder::run(const std::stop_token& stop) {
  auto onDisk = std::chrono::steady_clock::now();
  while (!stop.stop_requested()) {
    wakeup_.waitFor(kPollEvery);
    if (!drain()) continue;  // keeps emptying the ring
    const auto now = std::chrono::steady_clock::now();
    if (now - onDisk < kToDiskEvery) continue;
    onDisk = now;
    Status s = checkSpace();
    if (s) s = sink_->flush();
    if (!s) stopWith(s.error().asMessage());
  }
}

Status Recorder::checkSpace() {
  const std::string path = sink_->path();
  {
    const std::scoped_lock lock(faultLock_);
    path_ = path;
  }
  if (const SessionWriter* writer = sink_->writer(); writer != nullptr) {
    if (!writer->inPlace()) return Error{path, message("recording stopped: the file was deleted or moved away")};
    if (writer->cutShort()) return Error{path, message("recording stopped: the file was cut short by another program")};
  }
  return checkRoom(path, options_.reserveBytes);
}

// What was recorded is closed and stays; from here on steps are counted as dropped.
void Recorder::stopWith(const Message& fault) {
  recording_.store(false);
  {
    const std::scoped_lock lock(faultLock_);
    if (fault_.empty()) fault_ = fault;
  }
  sink_.reset();
}

Status Recorder::finish() {
  if (thread_) {
    thread_->requestStop();
    wakeup_.notify();
    thread_.reset();
  }
  drain();
  recording_.store(false);
  if (sink_) {
    const Status closed = sink_->close();
    sink_.reset();
    if (!closed) stopWith(closed.error().asMessage());
  }
  const std::scoped_lock lock(faultLock_);
  if (!fault_.empty()) return Error{{}, fault_};
  return Done{};
}

RecorderStatus Recorder::status() const {
  RecorderStatus s;
  s.recording = recording_.load();
  s.written = written_.load();
  s.dropped = dropped_.load();
  s.writing = writing_.load();
  const std::scoped_lock lock(faultLock_);
  s.path = path_;
  s.fault = fault_;
  return s;
}

}  // namespace stillcut::record
