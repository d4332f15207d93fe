#include "app/session/lobes/lobe_close_ups.h"

#include <sys/resource.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "app/session/lobes/lobe_limit.h"
#include "core/milling/stability/advice.h"
#include "core/milling/stability/exact_lobes.h"

namespace stillcut::app {
namespace {

constexpr int kNice = 10;  // behind the cut and the screen
constexpr Rpm kNarrowest{1.0};

struct Stretch {
  Rpm from{}, to{};
  bool reached = true;
};

// What the machine reaches first; where nobody has said what that is, everything.
std::vector<Stretch> stretchesOf(const ui::LobeFrame& frame) {
  if (!(frame.reachHigh > frame.reachLow)) return {{frame.lowest, frame.highest, true}};
  std::vector<Stretch> all{{frame.reachLow, frame.reachHigh, true}};
  if (frame.reachLow - frame.lowest > kNarrowest) all.push_back({frame.lowest, frame.reachLow, false});
  if (frame.highest - frame.reachHigh > kNarrowest) all.push_back({frame.reachHigh, frame.highest, false});
  return all;
}

// Every limit of unlike teeth takes some twenty times as long.
bool unlikeTeeth(const milling::Tool& tool) {
  return !tool.pitch.empty() || tool.helix != 0.0 || !tool.toothHelix.empty();
}

milling::AdviceRequest requestOf(const milling::CutModel& model, const ui::LobeFrame& frame, Metres depth,
                                 const Stretch& stretch) {
  milling::AdviceRequest request;
  request.depth = depth;
  request.lowest = stretch.from;
  request.highest = stretch.to;
  request.feedPerTooth = frame.feedPerTooth;
  request.threads = 1;
  if (unlikeTeeth(model.tool)) {
    request.steps = 64;
    request.finest = Rpm(1.0);
  }
  return request;
}

}  // namespace

LobeCloseUps::~LobeCloseUps() {
  thread_.request_stop();
  const std::scoped_lock lock(mutex_);
  current_.request_stop();
}

void LobeCloseUps::look(const ui::SpeedDepth& at) {
  {
    const std::scoped_lock lock(mutex_);
    if (last_ == at) return;
    last_ = wanted_ = at;
    current_.request_stop();
  }
  if (!thread_.joinable()) thread_ = std::jthread([this](const std::stop_token& end) { work(end); });
  asked_.notify_one();
}

std::shared_ptr<const ui::LobeCloseUp> LobeCloseUps::newest() const {
  const std::scoped_lock lock(mutex_);
  return newest_;
}

void LobeCloseUps::work(const std::stop_token& end) {
  setpriority(PRIO_PROCESS, 0, kNice);  // on Linux: of this thread
  while (true) {
    ui::SpeedDepth at;
    std::stop_token stop;
    {
      std::unique_lock lock(mutex_);
      if (!asked_.wait(lock, end, [this] { return wanted_.has_value(); }) || end.stop_requested()) return;
      at = *std::exchange(wanted_, std::nullopt);
      current_ = std::stop_source();
      stop = current_.get_token();
    }
    answer(at, stop);
  }
}

// The limit of one speed is known at once, and told before the pockets are. They depend on the depth alone: whoever
// moves along the speeds keeps them.
void LobeCloseUps::answer(const ui::SpeedDepth& at, const std::stop_token& stop) {
  const auto lobes = milling::ExactLobes::make(model_, "model");
  if (!lobes) return;  // the diagram says why
  ui::LobeCloseUp closeUp;
  closeUp.at = at;
  const auto limitAt = [&](Rpm speed, Metres deepest) -> std::optional<ui::LobeLimit> {
    if (!lobes->checkSpeed(speed)) return std::nullopt;
    const auto limits = lobes->limits(speed, {.maxAxialDepth = deepest}, stop);
    return limits ? std::optional(lobeLimit(limits.value())) : std::nullopt;
  };
  const Metres deepest = std::max(frame_.maxAxialDepth, at.depth);
  closeUp.limit = limitAt(at.speed, deepest);
  if (stop.stop_requested()) return;
  if (const auto before = newest(); before && before->complete && before->at.depth == at.depth) {
    closeUp.pockets = before->pockets;
    closeUp.deepest = before->deepest;
    closeUp.pocketsKnown = closeUp.complete = true;
    return tell(closeUp);
  }
  tell(closeUp);
  for (const Stretch& stretch : stretchesOf(frame_)) {
    const auto advice = milling::adviseSpeeds(model_, requestOf(model_, frame_, at.depth, stretch), "model", stop);
    if (!advice || !advice->finished) return;
    for (const milling::SpeedPocket& found : advice->pockets) {
      ui::Pocket pocket{found.from.speed, found.to.speed, found.best};
      const auto below = limitAt(found.best, std::max(deepest, at.depth * 4.0));
      if (stop.stop_requested()) return;
      pocket.limit = below ? below->depth : found.limit;
      pocket.limited = below && below->limited;
      pocket.removal = found.removal;
      pocket.open = !(found.from.frequency.value > 0.0) || !(found.to.frequency.value > 0.0);
      pocket.reachable = stretch.reached;
      if (found.quietest) {
        pocket.quietest = found.quietest->speed;
        pocket.vibration = found.quietest->forced.acceleration;
      }
      closeUp.pockets.push_back(pocket);
    }
    if (advice->deepest && (!closeUp.deepest || advice->deepest->depth > closeUp.deepest->depth)) {
      closeUp.deepest = {advice->deepest->speed, advice->deepest->depth};
    }
    closeUp.pocketsKnown = true;
    std::ranges::sort(closeUp.pockets, {}, &ui::Pocket::from);
    tell(closeUp);
  }
  closeUp.complete = true;
  tell(closeUp);
}

void LobeCloseUps::tell(const ui::LobeCloseUp& closeUp) {
  const std::scoped_lock lock(mutex_);
  newest_ = std::make_shared<ui::LobeCloseUp>(closeUp);
}

}  // namespace stillcut::app
