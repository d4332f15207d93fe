#include "app/session/lobes/learned_worker.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <system_error>
#include <vector>

#include "core/learn/evidence_store.h"
#include "core/learn/machine_prior.h"
#include "core/learn/next_cut.h"
#include "core/learn/stability_map.h"
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

// Nothing: it was stopped.
std::optional<LearnedLobes> learnedOf(const LearnedWorker::Work& work, const std::stop_token& stop) {
  LearnedLobes answer;
  if (!work.cut) return answer;
  const auto cuts = cutsOf(work);
  if (!cuts) return failed(cuts.error());
  answer.state = cuts->empty() ? LearnedLobes::State::NoCuts : LearnedLobes::State::Known;
  if (cuts->empty()) return answer;
  const learn::MapRequest request = requestOf(work);
  learn::LobePosterior posterior(priorOf(work.model),
                                 learn::rangeOf(*cuts, request.lowest, request.highest, request.deepest));
  for (const learn::CutEvidence& cut : *cuts) {
    if (stop.stop_requested()) return std::nullopt;
    if (const Status added = posterior.add(cut); !added) return failed(added.error());
  }
  for (const learn::CutEvidence& cut : posterior.cuts()) {
    answer.cuts.push_back({{cut.speed, cut.depth},
                           cut.outcome == learn::CutOutcome::Chatter,
                           cut.frequency,
                           cut.frequencySd,
                           cut.time_s});
  }
  answer.forgotten = posterior.forgotten();
  learn::StabilityMap map = stabilityMap(posterior, request);
  answer.speeds = std::move(map.speeds);
  answer.depths = std::move(map.depths);
  answer.probability = std::move(map.probability);
  advise(answer, posterior, work);
  return answer;
}

}  // namespace

void LearnedWorker::learn() {
  const std::scoped_lock lock(mutex_);
  again_ = true;
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
    {
      const std::scoped_lock lock(mutex_);
      if (!again_ || stop.stop_requested()) {
        busy_ = false;
        return;
      }
      again_ = false;
    }
    auto answer = learnedOf(work_, stop);
    const std::scoped_lock lock(mutex_);
    if (answer) newest_ = std::make_shared<const LearnedLobes>(std::move(*answer));
  }
}

}  // namespace stillcut::app
