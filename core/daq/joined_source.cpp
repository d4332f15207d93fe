#include "core/daq/joined_source.h"

#include <algorithm>
#include <stop_token>
#include <thread>
#include <utility>

#include "core/dsp/clip_watch.h"
#include "core/dsp/rate_watch.h"
#include "core/dsp/repeat_watch.h"
#include "core/model/block_copy.h"
#include "core/model/device_flags.h"

namespace stillcut::daq {
namespace {

constexpr double kStretch = 0.1;                            // s of a look for repeated values
constexpr double kHeld = 2.0;                               // s of each device
constexpr auto kPatience = std::chrono::milliseconds(250);  // so old a block may become before it is given up
constexpr auto kNap = std::chrono::milliseconds(1);

}  // namespace

struct JoinedSource::Follower {
  Follower(JoinedPart& part, const SourceFormat& format, Hertz to)
      : device(*part.device), delay(toDuration(part.delay)), channels(static_cast<int>(format.channels.size())) {
    const auto blocks = static_cast<std::size_t>(kHeld * format.rate.value / format.blockFrames) + 2;
    ring = std::make_unique<rt::SpscRing<SampleBlock>>(
        blocks, [&](SampleBlock& slot) { slot.allocate(channels, format.blockFrames); });
    spare.allocate(channels, format.blockFrames);
    clips.resize(format.channels.size());
    repeats.resize(format.channels.size());
    for (const ChannelInfo& c : format.channels) holds.push_back(c.quantity == SensorQuantity::SpindleSpeed);
    rates.prepare(format.rate);
    stretch = static_cast<int>(kStretch * format.rate.value);
    aligner.prepare(format.rate, to, channels, static_cast<int>(kHeld * format.rate.value));
  }
  // Its own thread.
  void run(const std::stop_token& stop) {
    bool lost = false;
    while (!stop.stop_requested()) {
      SampleBlock* slot = ring->reserve();
      SampleBlock& into = slot != nullptr ? *slot : spare;
      if (!device.read(into)) break;
      judge(into);
      if (slot == nullptr) {
        lost = true;
        continue;
      }
      if (std::exchange(lost, false)) into.flags |= kBlockGap;
      into.firstSample -= delay;
      ring->commit();
    }
    ended.store(true, std::memory_order_release);
  }
  // What cannot be seen any more once it is interpolated, or is brought to another's rate.
  void judge(SampleBlock& block) noexcept {
    rates.push(block);
    looked += block.frames;
    int other = rates.wrong() ? 0 : -1;
    for (std::size_t c = 0; c < clips.size(); ++c) {
      const std::span<const float> samples = block.channel(static_cast<int>(c));
      if (clips[c].see(samples)) block.flags |= kBlockClipped;
      for (const float v : samples) repeats[c].see(v);
      if (looked >= stretch) repeats[c].judge();
      if (other < 0 && repeats[c].repeats() && !holds[c]) other = static_cast<int>(c);
    }
    if (looked >= stretch) looked = 0;
    if (rates.pending() > 0.0) block.flags |= kBlockRateUnverified;
    if (other >= 0) block.flags |= rateMismatchOf(other);
  }
  // The reader's thread.
  void collect() noexcept {
    while (SampleBlock* block = ring->front()) {
      aligner.push(*block);
      unchecked = block->has(kBlockRateUnverified);
      otherRate = block->has(kBlockRateMismatch) ? rateMismatchChannel(*block) : -1;
      if (block->has(kBlockClipped)) {
        if (!clipped) clippedFrom = block->firstSample;
        clipped = true;
        clippedTo = block->end();
      }
      ring->pop();
    }
    residual_s.store(aligner.residual().value, std::memory_order_relaxed);
    rate_Hz.store(aligner.rate().value, std::memory_order_relaxed);
  }

  // Something between these two was at its limit. In what is asked for only once.
  bool takeClipped(Instant from, Instant to) noexcept {
    const bool within = clipped && clippedFrom < to && clippedTo > from;
    if (clippedTo <= to) clipped = false;
    return within;
  }

  DaqSource& device;
  Duration delay;
  int channels;
  std::vector<dsp::ClipWatch> clips;
  std::vector<dsp::RepeatWatch> repeats;
  std::vector<bool> holds;  // a speed is reported now and then
  dsp::RateWatch rates;
  int stretch = 0, looked = 0;  // frames in which repeats are counted
  bool clipped = false;
  bool unchecked = false;  // its newest block
  int otherRate = -1;      // the channel of another rate; -1: none
  Instant clippedFrom{}, clippedTo{};
  std::unique_ptr<rt::SpscRing<SampleBlock>> ring;
  SampleBlock spare;
  ClockAligner aligner;
  std::atomic<bool> ended{false};
  std::atomic<double> residual_s{0.0}, rate_Hz{0.0};
  std::unique_ptr<rt::RealtimeThread> thread;
};

JoinedSource::JoinedSource(std::vector<JoinedPart> parts, const Clock& clock)
    : parts_(std::move(parts)), clock_(clock) {}

JoinedSource::~JoinedSource() {
  JoinedSource::stop();
  for (auto& follower : followers_) follower->thread.reset();
}

Result<SourceFormat> JoinedSource::open() {
  for (JoinedPart& part : parts_) {
    auto format = part.device->open();
    if (!format) return format.error();
    if (&part == &parts_.front()) {
      format_ = *format;
      ownChannels_ = static_cast<int>(format->channels.size());
      own_.allocate(ownChannels_, format->blockFrames);
      continue;
    }
    followers_.push_back(std::make_unique<Follower>(part, *format, format_.rate));
    format_.channels.insert(format_.channels.end(), format->channels.begin(), format->channels.end());
    if (format_.doubt.empty()) format_.doubt = format->doubt;
  }
  return format_;
}

void JoinedSource::start() {
  started_ = true;
  for (auto& follower : followers_) {
    follower->thread =
        std::make_unique<rt::RealtimeThread>(rt::ThreadRequest{.name = "device", .scheduling = rt::Scheduling::Fifo},
                                             [f = follower.get()](const std::stop_token& stop) { f->run(stop); });
  }
}

// What a device has begun after will not come any more.
JoinedSource::Reach JoinedSource::reach(Instant from, Instant to) noexcept {
  bool all = true;
  bool never = false;
  for (auto& f : followers_) {
    f->collect();
    never = never || (f->aligner.begun() && f->aligner.first() > from);
    all = all && f->aligner.begun() && f->aligner.last() >= to;
  }
  return never ? Reach::Never : all ? Reach::Whole : Reach::NotYet;
}

bool JoinedSource::read(SampleBlock& block) noexcept {
  if (!started_) start();
  while (!stopped_.load(std::memory_order_relaxed)) {
    if (!parts_.front().device->read(own_)) return false;
    const Duration delay = toDuration(parts_.front().delay);
    const Instant from = own_.firstSample - delay;
    const Instant to = own_.end() - delay;
    const Instant patience = own_.end() + kPatience;
    Reach reached = reach(from, to);
    while (reached == Reach::NotYet && clock_.now() < patience && !stopped_.load(std::memory_order_relaxed)) {
      std::this_thread::sleep_for(kNap);
      reached = reach(from, to);
    }
    if (reached != Reach::Whole) {
      missing_ += own_.lostFrames + static_cast<std::uint64_t>(own_.frames);
      continue;
    }
    copyBlock(own_, block);
    block.firstSample = from;
    if (!std::exchange(handedOut_, true)) missing_ = 0;  // nothing was there before the first
    block.lostFrames = own_.lostFrames + missing_;
    if (std::exchange(missing_, 0) > 0) block.flags |= kBlockGap;
    int channel = ownChannels_;
    const double step = 1.0 / own_.rate.value;
    for (auto& f : followers_) {
      if (f->takeClipped(from, to)) block.flags |= kBlockClipped;
      if (f->unchecked) block.flags |= kBlockRateUnverified;
      if (f->otherRate >= 0 && !block.has(kBlockRateMismatch)) block.flags |= rateMismatchOf(channel + f->otherRate);
      for (int c = 0; c < f->channels; ++c, ++channel) {
        const std::span<float> out = block.channel(channel);
        for (std::size_t i = 0; i < out.size(); ++i) {
          out[i] = f->aligner.value(c, from + toDuration(Seconds(static_cast<double>(i) * step)));
        }
      }
    }
    return true;
  }
  return false;
}

void JoinedSource::stop() noexcept {
  stopped_.store(true, std::memory_order_relaxed);
  for (JoinedPart& part : parts_) part.device->stop();
}

Message JoinedSource::fault() const {
  for (const JoinedPart& part : parts_) {
    if (Message fault = part.device->fault(); !fault.empty()) return fault;
  }
  return {};
}

Message JoinedSource::trouble() const {
  for (const JoinedPart& part : parts_) {
    if (Message trouble = part.device->trouble(); !trouble.empty()) return trouble;
  }
  return {};
}

bool JoinedSource::live() const {
  return std::all_of(parts_.begin(), parts_.end(), [](const JoinedPart& p) { return p.device->live(); });
}

std::vector<AlignedClock> JoinedSource::clocks() const {
  std::vector<AlignedClock> all;
  for (const auto& f : followers_) {
    all.push_back({Hertz(f->rate_Hz.load(std::memory_order_relaxed)),
                   Seconds(f->residual_s.load(std::memory_order_relaxed)), f->channels});
  }
  return all;
}

}  // namespace stillcut::daq
