#include "core/daq/measured_samples.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>

#include "core/daq/device_messages.h"

namespace stillcut::daq {
namespace {

constexpr auto kLook = std::chrono::milliseconds(20);

std::string seconds(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g s", value);
  return text;
}

// Stops the device when it is not wanted any more, or has been silent for too long: a read() that waits returns then.
class Watch {
 public:
  Watch(DaqSource& device, const MeasureRequest& request, Duration most)
      : thread_(
            [this, &device, &request, until = std::chrono::steady_clock::now() + most](const std::stop_token& stop) {
              std::unique_lock lock(mutex_);
              const auto over = [&] {
                return (request.ended != nullptr && request.ended->load(std::memory_order_relaxed)) ||
                       std::chrono::steady_clock::now() >= until;
              };
              while (!stop.stop_requested() && !over()) wake_.wait_for(lock, stop, kLook, [] { return false; });
              if (!stop.stop_requested()) device.stop();
            }) {}

 private:
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::jthread thread_;  // last: it ends before what it uses
};

}  // namespace

void LongestStretch::take(const SampleBlock& block) {
  if (block.has(kBlockGap) && length() > 0) {
    broken_ = true;
    if (length() >= best_.front().size()) best_.swap(now_);
    for (std::vector<float>& channel : now_) channel.clear();
  }
  for (std::size_t c = 0; c < now_.size(); ++c) {
    const std::span<const float> more = block.channel(static_cast<int>(c));
    now_[c].insert(now_[c].end(), more.begin(), more.end());
  }
}

std::size_t LongestStretch::longest() const {
  return std::max(length(), best_.front().size());
}

std::vector<std::vector<float>> LongestStretch::samples() && {
  return std::move(length() >= best_.front().size() ? now_ : best_);
}

Result<MeasuredSamples> measure(DaqSource& device, const SourceFormat& format, const MeasureRequest& request) {
  const double rate = format.rate.value;
  const auto wanted = static_cast<std::size_t>(request.length.value * rate);
  const Duration most = 2 * toDuration(request.length) + request.patience;
  SampleBlock block;
  block.allocate(static_cast<int>(format.channels.size()), format.blockFrames);
  LongestStretch stretch(format.channels.size());
  {
    const Watch watch(device, request, most);
    Instant begin{};
    bool any = false;
    while (stretch.length() < wanted && device.read(block)) {
      if (!std::exchange(any, true)) begin = block.firstSample;
      stretch.take(block);
      if (block.end() - begin > most) break;
    }
  }
  device.stop();
  if (!device.fault().empty()) return Error{{}, device.fault()};
  if (stretch.length() < wanted) {
    const std::string longest = seconds(static_cast<double>(stretch.longest()) / rate);
    return Error{theDevice(), notInOnePiece(),
                 stretch.broken() ? message("the longest was %1 of %2: samples are lost again and again", longest,
                                            seconds(request.length.value))
                                  : message("the longest was %1 of %2", longest, seconds(request.length.value))};
  }
  MeasuredSamples heard{std::move(stretch).samples(), format.rate, format.channels};
  if (request.told.size() != format.channels.size()) return heard;
  heard.channels = request.told;
  for (std::size_t c = 0; c < request.told.size(); ++c) {
    const double own = format.channels[c].scale / request.told[c].scale;
    if (own == 1.0) continue;
    for (float& v : heard.samples[c]) v = static_cast<float>(own * static_cast<double>(v));
  }
  return heard;
}

}  // namespace stillcut::daq
