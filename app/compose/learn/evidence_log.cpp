#include "app/compose/learn/evidence_log.h"

#include <ctime>
#include <iterator>

#include "app/compose/profile_rig.h"
#include "app/compose/resource_folder.h"
#include "core/learn/evidence_store.h"
#include "core/milling/stability/lobe_case.h"

namespace stillcut::app {
namespace {

constexpr Seconds kLook{1.0};  // how often the disk's thread looks by itself

Status write(const std::filesystem::path& path, const std::vector<learn::CutEvidence>& cuts) {
  std::error_code failed;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), failed);
  if (failed) return Error{path.parent_path().string(), message("cannot be made"), foreign(failed.message())};
  auto store = learn::EvidenceStore::open(path);
  if (!store) return store.error();
  const auto added = store->addAll(cuts);
  return added ? Status(Done{}) : Status(added.error());
}

}  // namespace

std::filesystem::path defaultCutStore() {
  return userFolder("XDG_DATA_HOME", ".local/share") / "cuts.sqlite";
}

Result<std::optional<learn::CutEvidence>> evidenceOf(const config::Profile& profile, const std::string& profilePath) {
  const bool said = !profile.model.empty() && profile.depth.value > 0.0 && profile.cut.teeth > 0 &&
                    !profile.cut.machine.empty() && !profile.cut.tool.empty() && profile.pitch.empty();
  if (!said) return std::optional<learn::CutEvidence>();
  const auto model = milling::loadLobeCase(modelFile(profile, profilePath));
  if (!model) return model.error();
  if (model->model.turning) return std::optional<learn::CutEvidence>();  // what is learned is of milling
  learn::CutEvidence cut;
  cut.assembly.machine = profile.cut.machine;
  cut.assembly.tool = profile.cut.tool;
  cut.assembly.holder = profile.holder;
  cut.assembly.stickOut = profile.stickOut;
  cut.teeth = profile.cut.teeth;
  cut.diameter = profile.cut.toolDiameter.value > 0.0 ? profile.cut.toolDiameter : model->model.tool.diameter;
  cut.depth = profile.depth;
  cut.engagement = model->model.engagement;
  cut.source = profilePath;
  return std::optional(cut);
}

EvidenceLog::EvidenceLog(learn::CutEvidence common, std::filesystem::path store)
    : common_(std::move(common)), store_(std::move(store)) {
  thread_.emplace(rt::ThreadRequest{"cuts"}, [this](const std::stop_token& stop) { run(stop); });
}

void EvidenceLog::look(const Snapshot& snapshot) {
  if (snapshot.inCharge < 0 || snapshot.inCharge >= snapshot.detectorCount) return;
  keep(collector_.look(snapshot.verdicts[static_cast<std::size_t>(snapshot.inCharge)]));
}

void EvidenceLog::keep(const std::optional<learn::CollectedCut>& cut) {
  if (!cut) return;
  learn::CutEvidence evidence = common_;
  evidence.id = learn::newEvidenceId();
  evidence.speed = cut->speed;
  evidence.outcome = cut->outcome;
  evidence.frequency = cut->frequency;
  evidence.frequencySd = cut->frequencySd;
  evidence.time_s = static_cast<std::int64_t>(std::time(nullptr));
  {
    const std::scoped_lock lock(lock_);
    waiting_.push_back(std::move(evidence));
  }
  wakeup_.notify();
}

void EvidenceLog::finish() {
  keep(collector_.end());
  if (thread_) {
    thread_->requestStop();
    wakeup_.notify();
    thread_.reset();
  }
  writeWaiting();
}

Message EvidenceLog::problem() const {
  const std::scoped_lock lock(lock_);
  return problem_;
}

void EvidenceLog::run(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    writeWaiting();
    wakeup_.waitFor(kLook);
  }
}

// What could not be written waits for the next time.
void EvidenceLog::writeWaiting() {
  std::vector<learn::CutEvidence> cuts;
  {
    const std::scoped_lock lock(lock_);
    cuts.swap(waiting_);
  }
  if (cuts.empty()) return;
  const Status written = write(store_, cuts);
  const std::scoped_lock lock(lock_);
  problem_ = written ? Message() : written.error().asMessage();
  if (!written) waiting_.insert(waiting_.begin(), std::move_iterator(cuts.begin()), std::move_iterator(cuts.end()));
}

}  // namespace stillcut::app
