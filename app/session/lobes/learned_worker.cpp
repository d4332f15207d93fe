#include "app/session/lobes/learned_worker.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <system_error>
#include <utility>
#include <vector>

#include "core/learn/evidence_store.h"
#include "core/learn/machine_prior.h"
#include "core/learn/next_cut.h"
#include "core/learn/stability_map.h"
#include "core/learn/stable_margin.h"
#include "ui/base/say.h"

namespace stillcut::app {
namespace {

using ui::LearnedLobes;

constexpr int kNice = 10;  // behind the cut and the screen
constexpr double kRisk = 0.1;

learn::MachinePrior priorOf(const milling::CutModel& model) {
  std::vector<learn::PriorMode> modes;
  for (const milling::Mode& mode : model.modes) modes.push_back({mode, {}});
  return learn::priorOfTap(modes, model.material);
}

ui::LearnedAdvice adviceOf(const learn::LearnedAdvice& a) {
  return {{a.speed, a.depth}, a.probabilityStable};
}

LearnedLobes failed(const Error& error) {
  LearnedLobes answer;
  answer.state = LearnedLobes::State::Failed;
  answer.problem = ui::sayError(error);
  return answer;
}

// What is clamped otherwise is another tool. An empty field of the filter would take all of them.
bool clampedAlike(const learn::Assembly& a, const learn::Assembly& b) {
  constexpr double kAlike_m = 0.5e-3;
  return a.holder == b.holder && std::abs(a.stickOut.value - b.stickOut.value) <= kAlike_m;
}

// Empty where nothing has been kept so far: the first judged cut makes the file.
Result<std::vector<learn::CutEvidence>> cutsOf(const LearnedWorker::Work& work) {
  std::error_code unknown;
  if (!std::filesystem::exists(work.store, unknown)) return std::vector<learn::CutEvidence>();
  const auto store = learn::EvidenceStore::openToRead(work.store);
  if (!store) return store.error();
  const learn::Assembly& now = work.cut->assembly;
  std::vector<learn::Assembly> names{now};
  if (const learn::Assembly before = byNameAlone(now); !(before == now)) names.push_back(before);
  std::vector<learn::CutEvidence> all;
  for (const learn::Assembly& a : names) {
    auto cuts = store->cuts({a.machine, a.tool, a.holder, {}});
    if (!cuts) return cuts.error();
    std::ranges::copy_if(*cuts, std::back_inserter(all),
                         [&a](const learn::CutEvidence& cut) { return clampedAlike(cut.assembly, a); });
  }
  std::ranges::stable_sort(all, {}, &learn::CutEvidence::time_s);
  return all;
}

learn::MapRequest requestOf(const LearnedWorker::Work& work) {
  learn::MapRequest request;
  request.engagement = work.cut->engagement;
  request.teeth = work.cut->teeth;
  request.lowest = work.frame.lowest;
  request.highest = work.frame.highest;
  request.deepest = work.frame.maxAxialDepth;
  return request;
}

// Advice keeps to the speeds that the machine reaches; the map shows all of the diagram.
void advise(LearnedLobes& answer, learn::LobePosterior& posterior, const LearnedWorker::Work& work) {
  learn::MapRequest within = requestOf(work);
  if (work.frame.reachHigh > work.frame.reachLow) {
    within.lowest = work.frame.reachLow;
    within.highest = work.frame.reachHigh;
  }
  answer.risk = kRisk;
  answer.best = adviceOf(learnedAdvice(posterior, within, kRisk));
  learn::TrialLimits limits;
  limits.engagement = within.engagement;
  limits.teeth = within.teeth;
  limits.lowest = within.lowest;
  limits.highest = within.highest;
  limits.deepest = within.deepest;
  limits.risk = kRisk;
  const auto next = nextCut(posterior, limits);
  if (!next) return;
  answer.next = {{next->speed, next->depth}, next->probabilityStable};
  if (next->removalNow > 0.0) answer.gain = next->removalExpected / next->removalNow - 1.0;
}

// Everything that was kept, and the tool's modes. Empty: it was stopped.
Result<std::optional<learn::LobePosterior>> posteriorOf(const LearnedWorker::Work& work, const std::stop_token& stop) {
  constexpr double kDeeper = 3.0;  // than the cut that runs, whose margin is asked for
  const auto cuts = cutsOf(work);
  if (!cuts) return cuts.error();
  const learn::MapRequest request = requestOf(work);
  const Metres deepest = std::max(request.deepest, work.cut->depth * kDeeper);
  std::optional<learn::LobePosterior> posterior(std::in_place, priorOf(work.model),
                                                learn::rangeOf(*cuts, request.lowest, request.highest, deepest));
  for (const learn::CutEvidence& cut : *cuts) {
    if (stop.stop_requested()) return std::optional<learn::LobePosterior>();
    if (const Status added = posterior->add(cut); !added) return added.error();
  }
  return posterior;
}

LearnedLobes learnedOf(const LearnedWorker::Work& work, learn::LobePosterior& posterior) {
  LearnedLobes answer;
  answer.state = posterior.cuts().empty() ? LearnedLobes::State::NoCuts : LearnedLobes::State::Known;
  if (posterior.cuts().empty()) return answer;
  for (const learn::CutEvidence& cut : posterior.cuts()) {
    answer.cuts.push_back({{cut.speed, cut.depth},
                           cut.outcome == learn::CutOutcome::Chatter,
                           cut.frequency,
                           cut.frequencySd,
                           cut.time_s});
  }
  answer.forgotten = posterior.forgotten();
  learn::StabilityMap map = stabilityMap(posterior, requestOf(work));
  answer.speeds = std::move(map.speeds);
  answer.depths = std::move(map.depths);
  answer.probability = std::move(map.probability);
  advise(answer, posterior, work);
  return answer;
}

// Modes are looked for where the tool has them.
std::optional<ui::DepthMargin> marginOf(const LearnedWorker::Work& work, learn::LobePosterior& posterior,
                                        const learn::SteadyStretch& heard) {
  learn::DecayParams band;
  for (const milling::Mode& mode : work.model.modes) {
    band.lowest = std::min(band.lowest, mode.frequency * 0.7);
    band.highest = std::max(band.highest, mode.frequency * 1.3);
  }
  const learn::DecayAnswer decay = learn::slowestDecay(heard.channels, heard.rate, heard.speed, band);
  if (!decay.decay) return std::nullopt;
  const learn::StableCut cut{work.cut->engagement, work.cut->teeth, heard.speed, work.cut->depth};
  const learn::MarginAnswer answer = learn::stableMargin(posterior, cut, *decay.decay);
  if (!answer.margin) return std::nullopt;
  return ui::DepthMargin{answer.margin->rise, answer.margin->low, answer.margin->high};
}

}  // namespace

void LearnedWorker::learn() {
  const std::scoped_lock lock(mutex_);
  again_ = true;
  begin();
}

void LearnedWorker::listen(learn::SteadyStretch stretch, bool anew) {
  if (!work_.cut) return;
  const std::scoped_lock lock(mutex_);
  heard_ = std::move(stretch);
  anew_ = anew_ || anew;
  begin();
}

LearnedWorker::Margin LearnedWorker::margin() const {
  const std::scoped_lock lock(mutex_);
  return margin_;
}

// Under the lock.
void LearnedWorker::begin() {
  if (busy_) return;
  busy_ = true;
  if (thread_.joinable()) thread_.join();  // it has left the lock for good
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

std::shared_ptr<const LearnedLobes> LearnedWorker::newest() const {
  const std::scoped_lock lock(mutex_);
  return newest_;
}

void LearnedWorker::run(const std::stop_token& stop) {
  setpriority(PRIO_PROCESS, 0, kNice);  // on Linux: of this thread
  for (;;) {
    bool lobes = false, anew = false;
    std::optional<learn::SteadyStretch> heard;
    {
      const std::scoped_lock lock(mutex_);
      if ((!again_ && !heard_) || stop.stop_requested()) {
        busy_ = false;
        return;
      }
      lobes = std::exchange(again_, false);
      anew = std::exchange(anew_, false) || lobes;
      heard = std::exchange(heard_, std::nullopt);
    }
    Status read = Done{};
    if (work_.cut && (anew || !posterior_)) {
      auto made = posteriorOf(work_, stop);
      if (made && !made.value()) continue;  // stopped
      posterior_.reset();
      if (made) posterior_.emplace(std::move(**made));
      if (!made) read = made.error();
    }
    if (lobes) {
      auto answer = std::make_shared<const LearnedLobes>(!read        ? failed(read.error())
                                                         : posterior_ ? learnedOf(work_, *posterior_)
                                                                      : LearnedLobes());
      const std::scoped_lock lock(mutex_);
      newest_ = std::move(answer);
    }
    if (!heard) continue;
    const auto margin = posterior_ ? marginOf(work_, *posterior_, *heard) : std::nullopt;
    const std::scoped_lock lock(mutex_);
    margin_ = {margin_.number + 1, margin};
  }
}

}  // namespace stillcut::app
