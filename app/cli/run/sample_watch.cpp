#include "app/cli/run/sample_watch.h"

#include <algorithm>
#include <utility>

namespace stillcut::app {
namespace {

constexpr Seconds kSilence{1.0};
constexpr double kBlocks = 5.0;

}  // namespace

SampleWatch::Turn SampleWatch::look(std::uint64_t blocks, Seconds length, Instant now) {
  if (blocks != blocks_) {
    blocks_ = blocks;
    was_ = silent(now);
    last_ = now;
    return std::exchange(stopped_, false) ? Turn::Resumed : Turn::None;
  }
  if (stopped_ || silent(now) < std::max(kSilence, kBlocks * length)) return Turn::None;
  stopped_ = true;
  return Turn::Stopped;
}

}  // namespace stillcut::app
