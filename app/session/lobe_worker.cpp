#include "app/session/lobe_worker.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/compose/known_lobes.h"
#include "app/compose/profile_rig.h"
#include "app/session/lobes/lobe_limit.h"
#include "core/milling/linear_force.h"
#include "core/milling/stability/lobe_refine.h"
#include "core/milling/stability/lobe_sweep.h"
#include "ui/base/say.h"

namespace stillcut::app {
namespace {

constexpr int kNice = 10;                // behind the cut and the screen
constexpr double kFinestShare = 1e-4;    // of a stretch: finer than any screen shows
constexpr std::size_t kMostAdded = 600;  // speeds of a stretch
constexpr std::size_t kStartsKept = 64;  // more jumps than the points on the screen are of

milling::LobeMethod methodOf(ui::LobeMethodChoice method) {
  switch (method) {
    case ui::LobeMethodChoice::ZerothOrder:
      return milling::LobeMethod::ZerothOrder;
    case ui::LobeMethodChoice::SemiDiscretization:
      return milling::LobeMethod::SemiDiscretization;
    case ui::LobeMethodChoice::Exact:
      return milling::LobeMethod::Exact;
  }
  return milling::LobeMethod::Exact;
}

LobeWorker::Cut cutOf(const milling::Scenario& scenario) {
  LobeWorker::Cut cut;
  const milling::Programme& programme = scenario.programme;
  cut.model = scenario.model;
  cut.model.engagement.radialImmersion = programme.immersion.highest(cut.model.engagement.radialImmersion);
  cut.frame = usualFrame(cut.model);
  cut.frame.name = QString::fromStdString(scenario.name);
  cut.frame.programmed = programme.speed;
  cut.frame.reachLow = programme.speed * scenario.overrides.lowestSpeed.value;
  cut.frame.reachHigh = programme.speed * scenario.overrides.highestSpeed.value;
  cut.frame.lowest = std::min(cut.frame.lowest, cut.frame.reachLow);
  cut.frame.highest = std::max(cut.frame.highest, cut.frame.reachHigh);
  cut.frame.depth = Metres(programme.depth.highest(0.0));
  cut.frame.maxAxialDepth = std::max(cut.frame.depth * 2.5, Metres(0.5e-3));
  cut.frame.feedPerTooth = programme.feedPerTooth;
  milling::lineariseForLobes(cut.model, programme.feedPerTooth);
  if (programme.depth.along == milling::Along::Time) cut.depth = programme.depth;
  return cut;
}

}  // namespace

ui::LobeFrame usualFrame(const milling::CutModel& model) {
  const auto [slow, fast] =
      std::minmax_element(model.modes.begin(), model.modes.end(),
                          [](const milling::Mode& a, const milling::Mode& b) { return a.frequency < b.frequency; });
  ui::LobeFrame frame;
  const double perTooth = 60.0 / model.tool.teeth;
  frame.lowest = Rpm(std::round(perTooth * slow->frequency.value / 3.5 / 100.0) * 100.0);
  frame.highest = Rpm(std::round(perTooth * fast->frequency.value * 1.25 / 100.0) * 100.0);
  frame.depth = Metres(1e-3);
  frame.maxAxialDepth = Metres(5e-3);
  frame.teeth = model.tool.teeth;
  frame.widthOfCut = model.tool.diameter * model.engagement.radialImmersion;
  return frame;
}

LobeWorker::LobeWorker(Cut cut) : cut_(std::move(cut)), closeUps_(cut_.model, cut_.frame) {}

LobeWorker::LobeWorker(const milling::Scenario& scenario) : LobeWorker(cutOf(scenario)) {}

Result<std::unique_ptr<LobeWorker>> LobeWorker::ofProfile(const config::Profile& profile, const std::string& path) {
  if (profile.model.empty()) return std::unique_ptr<LobeWorker>();
  auto loaded = cutOfProfile(profile, modelFile(profile, path));
  if (!loaded) return loaded.error();
  const auto reach = speedsInReach(profile, path);
  if (!reach) return reach.error();
  Cut cut;
  cut.model = std::move(loaded->model);
  cut.frame = usualFrame(cut.model);
  cut.frame.name = QString::fromStdString(loaded->name);
  cut.frame.programmed = profile.cut.nominalSpeed;
  cut.frame.maxAxialDepth = loaded->maxAxialDepth;
  cut.frame.depthKnown = profile.depth.value > 0.0;
  if (cut.frame.depthKnown) cut.frame.depth = profile.depth;
  cut.frame.maxAxialDepth = std::max(cut.frame.maxAxialDepth, cut.frame.depth * 1.25);
  if (reach->high > reach->low) {
    cut.frame.reachLow = reach->low;
    cut.frame.reachHigh = reach->high;
    cut.frame.lowest = std::min(cut.frame.lowest, reach->low);
    cut.frame.highest = std::max(cut.frame.highest, reach->high);
  }
  cut.frame.feedPerTooth = feedPerTooth(profile, cut.model.tool.teeth);
  milling::lineariseForLobes(cut.model, cut.frame.feedPerTooth);
  return std::make_unique<LobeWorker>(std::move(cut));
}

void LobeWorker::learnFrom(const std::filesystem::path& store, const std::optional<learn::CutEvidence>& cut) {
  learned_ = std::make_unique<LearnedWorker>(LearnedWorker::Work{cut, cut_.model, cut_.frame, store});
}

void LobeWorker::setStart(Instant start, Instant from) {
  if (!starts_.empty() && from < starts_.back().from) starts_.clear();
  starts_.push_back({from, start});
  if (starts_.size() > kStartsKept) starts_.erase(starts_.begin());
}

Metres LobeWorker::axialDepthAt(Instant t) const {
  if (cut_.depth.empty() || starts_.empty()) return cut_.frame.depth;
  auto begun = starts_.begin();
  while (begun + 1 != starts_.end() && (begun + 1)->from <= t) ++begun;
  return Metres(cut_.depth.at(secondsBetween(begun->start, t).value, 0.0, cut_.frame.depth.value));
}

void LobeWorker::ask(const ui::LobeQuestion& question) {
  cancel();
  {
    const std::scoped_lock lock(mutex_);
    progress_ = {ui::LobeProgress::State::Running, 0.0, {}};
  }
  thread_ = std::jthread([this, question](const std::stop_token& stop) { compute(question, stop); });
}

void LobeWorker::cancel() {
  if (!thread_.joinable()) return;
  thread_.request_stop();
  thread_.join();
}

void LobeWorker::compute(const ui::LobeQuestion& question, const std::stop_token& stop) {
  setpriority(PRIO_PROCESS, 0, kNice);  // on Linux: of this thread
  const std::vector<Rpm> speeds = milling::speedsAcross(cut_.model, question.from, question.to, question.steps);
  milling::SweepOptions options;
  options.method = methodOf(question.method);
  options.limits.maxAxialDepth = question.maxAxialDepth;
  options.limits.firstOnly = question.method != ui::LobeMethodChoice::Exact;  // the exact one knows islands
  options.threads = 1;
  options.progress = [this](double share) {
    const std::scoped_lock lock(mutex_);
    progress_.share = share;
  };
  const auto sweep = milling::sweepLobes(cut_.model, speeds, options, "model", stop);
  if (!sweep) return finish(ui::LobeProgress::State::Failed, ui::sayError(sweep.error()));
  if (!sweep->finished) return finish(ui::LobeProgress::State::Cancelled);
  tell(question, *sweep);
  refine(question, *sweep, options, stop);
}

// Where the question is before where nobody cuts.
void LobeWorker::refine(const ui::LobeQuestion& question, milling::LobeSweep sweep, milling::SweepOptions options,
                        const std::stop_token& stop) {
  options.progress = {};
  std::vector<std::pair<Rpm, Rpm>> stretches{{question.from, question.to}};
  if (cut_.frame.reachHigh > cut_.frame.reachLow)
    stretches.insert(stretches.begin(), {cut_.frame.reachLow, cut_.frame.reachHigh});
  for (const auto& [from, to] : stretches) {
    milling::RefineOptions fine;
    fine.from = from;
    fine.to = to;
    fine.finest = std::max(Rpm(1.0), (to - from) * kFinestShare);
    fine.edgesAt = cut_.frame.depth;
    fine.mostSpeeds = sweep.speeds.size() + kMostAdded;
    auto finer = milling::refineLobes(sweep, cut_.model, options, fine, "model", stop);
    if (!finer) return finish(ui::LobeProgress::State::Failed, ui::sayError(finer.error()));
    if (!finer->finished) return finish(ui::LobeProgress::State::Cancelled);
    sweep = std::move(*finer);
    tell(question, sweep);
  }
  finish(ui::LobeProgress::State::Done);
}

void LobeWorker::tell(const ui::LobeQuestion& question, const milling::LobeSweep& sweep) {
  auto diagram = std::make_shared<ui::LobeDiagram>();
  diagram->question = question;
  for (const milling::SpeedLimits& limits : sweep.speeds) diagram->limits.push_back(lobeLimit(limits));
  for (const Message& warning : sweep.warnings) diagram->warnings << ui::sayCore(warning);
  const std::scoped_lock lock(mutex_);
  diagram->number = ++answers_;
  diagram_ = std::move(diagram);
}

void LobeWorker::finish(ui::LobeProgress::State state, const QString& problem) {
  const std::scoped_lock lock(mutex_);
  progress_ = {state, state == ui::LobeProgress::State::Done ? 1.0 : progress_.share, problem};
}

ui::LobeProgress LobeWorker::progress() const {
  const std::scoped_lock lock(mutex_);
  return progress_;
}

std::shared_ptr<const ui::LobeDiagram> LobeWorker::diagram() const {
  const std::scoped_lock lock(mutex_);
  return diagram_;
}

}  // namespace stillcut::app
