#include "app/session/lobes/margin_watch.h"

#include <utility>

namespace stillcut::app {
namespace {

constexpr int kMostSilent = 3;  // a margin that was told stands so many stretches that told nothing

std::vector<int> vibrations(const CutSetup& setup) {
  std::vector<int> channels;
  for (std::size_t i = 0; i < setup.channels.size(); ++i) {
    switch (setup.channels[i].quantity) {
      case SensorQuantity::Acceleration:
      case SensorQuantity::Velocity:
      case SensorQuantity::Displacement:
      case SensorQuantity::Force:
      case SensorQuantity::Sound:
        channels.push_back(static_cast<int>(i));
        break;
      default:
        break;
    }
  }
  return channels;
}

}  // namespace

MarginWatch::MarginWatch(LearnedWorker& worker, const CutSetup& setup, const learn::StretchParams& params)
    : worker_(worker), collector_(vibrations(setup), params) {}

void MarginWatch::look(const Snapshot& snapshot) {
  takeAnswer();
  const bool judged = snapshot.inCharge >= 0 && snapshot.inCharge < snapshot.detectorCount && snapshot.running;
  if (!judged || !collector_.look(snapshot.verdicts[static_cast<std::size_t>(snapshot.inCharge)])) {
    anew_ = true;
    ofBefore_ = true;
    silent_ = 0;
    told_.reset();
    return;
  }
  auto stretch = collector_.take();
  if (!stretch || asked_) return;
  asked_ = worker_.margin().number + 1;
  ofBefore_ = false;
  worker_.listen(std::move(*stretch), std::exchange(anew_, false));
}

void MarginWatch::takeAnswer() {
  if (!asked_) return;
  const LearnedWorker::Margin answer = worker_.margin();
  if (answer.number < *asked_) return;
  asked_.reset();
  if (ofBefore_) return;
  silent_ = answer.margin ? 0 : silent_ + 1;
  if (answer.margin || silent_ > kMostSilent) told_ = answer.margin;
}

}  // namespace stillcut::app
