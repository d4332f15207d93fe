#include "app/session/tap/tap_listener.h"

#include <utility>

namespace stillcut::app {
namespace {

constexpr std::size_t kMostWaiting = 64;  // blocks: a second or so

HeardBlock inSi(const SampleBlock& block, const std::vector<ChannelInfo>& channels) {
  HeardBlock heard;
  heard.gap = block.has(kBlockGap);
  heard.clipped = block.has(kBlockClipped);
  for (int c = 0; c < block.channels; ++c) {
    const double scale = channels[static_cast<std::size_t>(c)].scale;
    std::vector<double> samples;
    samples.reserve(static_cast<std::size_t>(block.frames));
    for (const float v : block.channel(c)) samples.push_back(scale * static_cast<double>(v));
    heard.samples.push_back(std::move(samples));
  }
  return heard;
}

}  // namespace

void TapListener::listen(std::function<Result<Device>()> open) {
  stop();
  shared_ = std::make_shared<Shared>();
  thread_ = std::jthread(
      [shared = shared_, open = std::move(open)](const std::stop_token& stop) { read(*shared, open, stop); });
}

void TapListener::read(Shared& shared, const std::function<Result<Device>()>& open, const std::stop_token& stop) {
  const auto end = [&](Message problem) {
    const std::scoped_lock lock(shared.mutex);
    shared.reading = nullptr;
    shared.state = State::Ended;
    shared.problem = std::move(problem);
  };
  auto device = open();
  if (!device) return end(device.error().asMessage());
  const auto format = device->source->open();
  if (!format) return end(format.error().asMessage());
  std::vector<ChannelInfo> channels = format->channels;
  if (device->told.size() == channels.size()) {
    // What the device knows of its own scale is in its samples' units already where a profile tells none.
    for (std::size_t c = 0; c < channels.size(); ++c) {
      channels[c].name = device->told[c].name.empty() ? channels[c].name : device->told[c].name;
      channels[c].quantity = device->told[c].quantity;
      channels[c].axis = device->told[c].axis;
    }
  }
  SampleBlock block;
  block.allocate(static_cast<int>(channels.size()), format->blockFrames);
  {
    const std::scoped_lock lock(shared.mutex);
    if (stop.stop_requested()) return;
    shared.channels = channels;
    shared.rate = format->rate;
    shared.reading = device->source.get();
    shared.state = State::Running;
  }
  while (!stop.stop_requested() && device->source->read(block)) {
    HeardBlock heard = inSi(block, channels);
    std::unique_lock lock(shared.mutex);
    shared.room.wait(lock, stop, [&] { return shared.heard.size() < kMostWaiting; });
    if (!stop.stop_requested()) shared.heard.push_back(std::move(heard));
  }
  end(device->source->fault());
}

void TapListener::stop() {
  if (!thread_.joinable()) return;
  thread_.request_stop();
  {
    const std::scoped_lock lock(shared_->mutex);
    if (shared_->reading != nullptr) shared_->reading->stop();
  }
  thread_.join();
  shared_.reset();
}

TapListener::State TapListener::state() const {
  if (!shared_) return State::Off;
  const std::scoped_lock lock(shared_->mutex);
  return shared_->state;
}

std::vector<ChannelInfo> TapListener::channels() const {
  const std::scoped_lock lock(shared_->mutex);
  return shared_->channels;
}

Hertz TapListener::rate() const {
  const std::scoped_lock lock(shared_->mutex);
  return shared_->rate;
}

Message TapListener::problem() const {
  const std::scoped_lock lock(shared_->mutex);
  return shared_->problem;
}

std::vector<HeardBlock> TapListener::take() {
  std::vector<HeardBlock> heard;
  if (!shared_) return heard;
  {
    const std::scoped_lock lock(shared_->mutex);
    for (HeardBlock& block : shared_->heard) heard.push_back(std::move(block));
    shared_->heard.clear();
  }
  shared_->room.notify_all();
  return heard;
}

}  // namespace stillcut::app
