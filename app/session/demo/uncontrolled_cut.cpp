#include "app/session/demo/uncontrolled_cut.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "app/compose/scenario_rig.h"

namespace stillcut::app {
namespace {

constexpr int kNice = 15;  // behind the cut, the screen and the lobes
constexpr Seconds kStep{0.05};

}  // namespace

UncontrolledCut::UncontrolledCut(milling::Scenario scenario)
    : thread_([this, scenario = std::move(scenario)](const std::stop_token& stop) { run(scenario, stop); }) {}

void UncontrolledCut::run(const milling::Scenario& scenario, const std::stop_token& stop) {
  setpriority(PRIO_PROCESS, 0, kNice);  // on Linux: of this thread
  ScenarioOptions options;
  options.methods.strategy = "monitor";
  options.watched = true;
  auto built = buildScenarioRig(scenario, options);
  if (!built) return;
  Rig& rig = *built->rig;
  double sum = 0.0;
  int blocks = 0;
  std::optional<Instant> begin;
  while (!stop.stop_requested() && rig.advance()) {
    const Snapshot* seen = rig.read();
    if (seen == nullptr) continue;
    if (!begin) begin = seen->time - toDuration(seen->health.blockLength * static_cast<double>(seen->health.blocks));
    sum += seen->vibrationRms * seen->vibrationRms;
    ++blocks;
    const auto steps = static_cast<std::size_t>(secondsBetween(*begin, seen->time) / kStep);
    const std::scoped_lock lock(mutex_);
    if (steps <= rms_.size()) continue;
    rms_.resize(steps, static_cast<float>(std::sqrt(sum / blocks)));
    sum = 0.0;
    blocks = 0;
  }
}

double UncontrolledCut::vibrationAt(Seconds t) const {
  const std::scoped_lock lock(mutex_);
  if (!(t.value >= 0.0) || t / kStep >= static_cast<double>(rms_.size()))
    return std::numeric_limits<double>::quiet_NaN();
  return rms_[static_cast<std::size_t>(t / kStep)];
}

}  // namespace stillcut::app
