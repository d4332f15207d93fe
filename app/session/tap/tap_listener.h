// TapListener: reads a device on a thread of its own and hands its samples over in SI units. Who takes them late makes
// the device wait, which tells its own losses. Thread: GUI, but for the reading itself.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/daq/daq_source.h"

namespace stillcut::app {

struct HeardBlock {
  std::vector<std::vector<double>> samples;  // by channel [SI unit]
  bool gap = false, clipped = false;
};

class TapListener {
 public:
  struct Device {
    std::shared_ptr<const Clock> clock;  // outlives the source; may be null
    std::unique_ptr<daq::DaqSource> source;
    std::vector<ChannelInfo> told;  // of a profile; as many as the device has, else not used
  };
  enum class State { Off, Opening, Running, Ended };

  ~TapListener() { stop(); }

  // What was listened to before ends first. `open` runs on the reading thread.
  void listen(std::function<Result<Device>()> open);
  void stop();
  State state() const;
  // Once it runs.
  std::vector<ChannelInfo> channels() const;
  Hertz rate() const;
  // Ended: why; empty for a plain end.
  Message problem() const;
  // What has been heard since the last call.
  std::vector<HeardBlock> take();

 private:
  struct Shared {
    mutable std::mutex mutex;
    std::condition_variable_any room;
    State state = State::Opening;
    Message problem;
    std::vector<ChannelInfo> channels;
    Hertz rate{};
    std::deque<HeardBlock> heard;
    daq::DaqSource* reading = nullptr;  // to be stopped; null: none
  };
  static void read(Shared& shared, const std::function<Result<Device>()>& open, const std::stop_token& stop);

  std::shared_ptr<Shared> shared_;
  std::jthread thread_;
};

}  // namespace stillcut::app
