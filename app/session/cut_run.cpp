#include "app/session/cut_run.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QFileInfo>
#include <cstdio>
#include <limits>
#include <utility>

#include "app/compose/active_setup.h"
#include "app/compose/known_lobes.h"
#include "app/compose/left_overrides.h"
#include "app/compose/profile_rig.h"
#include "app/compose/scenario_rig.h"
#include "app/session/session_view.h"
#include "core/milling/simulation/scenario.h"
#include "core/pipeline/catalog.h"
#include "core/rt/realtime_thread.h"
#include "ui/base/say.h"

namespace stillcut::app {
namespace {

// Live stream time is the steady clock's.
qint64 wallAtLiveZero() {
  return QDateTime::currentMSecsSinceEpoch() - toNs(SteadyClock().now()) / 1'000'000;
}

}  // namespace

CutRun::CutRun(std::unique_ptr<Rig> rig, ui::SessionInfo info, std::string configuration)
    : rig_(std::move(rig)), info_(std::move(info)), configuration_(std::move(configuration)) {}

Status CutRun::recordInto(const std::string& folder) {
  recordings_ = QString::fromStdString(folder);
  return rig_->recordInto(folder, configuration_, deletions_.teller());
}

Status CutRun::recordAt(const std::string& fileOrFolder) {
  const bool folder = QFileInfo(QString::fromStdString(fileOrFolder)).isDir();
  return folder ? recordInto(fileOrFolder) : rig_->recordToNew(fileOrFolder, configuration_);
}

Status CutRun::recordAsSaid(const config::Profile& profile, const std::string& path) {
  recordings_ = QString::fromStdString(app::recordingFolder(profile, path));
  return recordAsProfileSays(*rig_, profile, path, deletions_.teller());
}

void CutRun::start(const std::filesystem::path& flights, const ProgramLog& log) {
  flightLog_.emplace(rig_->flights(), flights);
  flightLog_->start();
  // With a real sensor, a page that has to come back from the disk would keep the worker waiting. Where it is not
  // permitted the cut is watched all the same.
  if (rig_->device().live() && !rt::lockMemory()) {
    std::fputs("stillcut: memory is not locked: not permitted (the package's limits allow it to the group stillcut)\n",
               stderr);
    log.write(LogLevel::Warning, "memory is not locked: not permitted");
  }
  runLog_.emplace(log).begin(*rig_, origin_);
  rig_->start({});
}

Status CutRun::stop() {
  if (active_) active_->stop();  // its ramp is over long before the disk is
  const Status recorded = rig_->stop();
  if (cuts_) cuts_->finish();
  const Status flown = flightLog_ ? flightLog_->finish() : Status(Done{});
  if (runLog_) runLog_->end(*rig_, recorded ? flown : recorded);
  runLog_.reset();
  return recorded ? flown : recorded;
}

const Snapshot* CutRun::read() {
  live_ = rig_->read();
  if (rig_->finished() && !recordingClosed_) {
    recordingClosed_ = true;
    (void)rig_->closeRecording().ok();  // recorder() says what went wrong
  }
  if (runLog_) runLog_->look(*rig_, live_);
  if (live_ == nullptr) return nullptr;
  takeOwnLimits(info_.limits, *rig_);
  if (cuts_) cuts_->look(*live_);
  if (margin_) margin_->look(*live_);
  authority_ = live_->authority;
  if (live_->machine.link.effect.value > 0.0) effect_ = live_->machine.link.effect;
  if (!began_) {
    const PathHealth& health = live_->health;
    began_ = live_->time - toDuration(health.blockLength * static_cast<double>(health.blocks));
  }
  if (lobes_ && !lobes_->started()) lobes_->setStart(*began_);
  return live_;
}

void CutRun::tellMargin() {
  LearnedWorker* worker = lobes_ ? lobes_->learnedWorker() : nullptr;
  if (worker != nullptr) margin_ = std::make_unique<MarginWatch>(*worker, rig_->setup());
}

void CutRun::readSignal(const std::function<void(const SampleBlock&)>& sink) {
  rig_->signal().read([&](const SampleBlock& block) {
    if (margin_) margin_->hear(block);
    sink(block);
  });
}

double CutRun::vibrationWithout(Instant t) const {
  if (!without_ || !began_) return std::numeric_limits<double>::quiet_NaN();
  return without_->vibrationAt(secondsBetween(*began_, t));
}

void CutRun::send(const OperatorInput& input) {
  if (input.action == OperatorAction::SetAuthority && input.authority != Authority::Off) authority_ = input.authority;
  rig_->send(input);
  // Back to what was programmed is: nothing of Stillcut acts, also not through the table.
  if (input.action == OperatorAction::BackToProgrammed && active_) active_->stop();
}

std::optional<RunsLink> CutRun::linkTold() const {
  if (!rig_->hasLink() || rig_->linkInfo().simulated) return std::nullopt;
  const cnc::LinkInfo info = rig_->linkInfo();
  RunsLink told{info, std::string(info.label), {}, {}, effect_};
  if (live_ == nullptr) return told;
  told.state = live_->machine;
  told.age = std::max(Seconds(), secondsBetween(told.state.time, SteadyClock().now()));  // live stream time is this
  return told;
}

bool CutRun::commandsMachine() const {
  return rig_->hasLink() && !rig_->linkInfo().simulated && authority_ != Authority::Off;
}

config::Profile CutRun::asProfile() const {
  if (!profile_.empty()) {
    if (auto loaded = config::loadProfile(profile_, pipeline::fullCatalog(), knownIds()); loaded)
      return std::move(*loaded);
  }
  config::Profile profile;
  profile.cut = rig_->setup();
  profile.strategy = rig_->chain().parts().strategy->describe().id;
  profile.allowAuto = false;
  return profile;
}

ui::LinkStatus CutRun::link() const {
  if (!rig_->finished()) {
    const auto left = rig_->leftInMachine();
    return {left ? ui::sayCore(leftSentence(*left)) : QString(),
            ui::sayCore(rig_->device().trouble()),
            {},
            rig_->releaseNotYetBack()};
  }
  const Message fault = rig_->device().fault();
  return {{},
          fault.empty() ? QCoreApplication::translate("Session", "The run has ended") : ui::sayCore(fault),
          {},
          rig_->releaseNotYetBack()};
}

ui::RecorderView CutRun::recorder() const {
  const record::Recorder* recorder = rig_->recorder();
  // Of what else is kept of the run: flight recordings, and what its cuts have taught.
  Message beside = flightLog_ ? flightLog_->problem() : Message();
  if (beside.empty() && cuts_) beside = cuts_->problem();
  if (recorder == nullptr && beside.empty()) return {};
  if (recorder == nullptr) return {ui::RecorderView::State::Failed, {}, ui::sayCore(beside)};
  const record::RecorderStatus status = recorder->status();
  ui::RecorderView shown;
  if (recordingClosed_ && status.fault.empty()) return shown;  // it ended with the run
  shown.state = status.recording ? ui::RecorderView::State::Recording : ui::RecorderView::State::Failed;
  shown.length = Seconds(static_cast<double>(status.written) * info_.setup.blockFrames / info_.setup.rate.value);
  shown.problem = ui::sayCore(status.fault);
  shown.waiting = status.recording && status.written > 0 && !status.writing;
  return shown;
}

namespace {

Result<std::unique_ptr<CutRun>> openSimulatedRun(const std::string& path, bool live, const config::ParamSet& wanted) {
  const auto scenario = milling::loadScenario(path);
  if (!scenario) return scenario.error();
  ScenarioOptions options;
  options.params = wanted;
  // A work-holder is no strategy of the machine's: beside its loop the cut is watched.
  options.methods.strategy = scenario->strategy == "active" ? "monitor" : scenario->strategy;
  options.live = live;
  options.watched = true;
  auto built = buildScenarioRig(*scenario, options);
  if (!built) return built.error();

  const config::ParamSet params = built->rig->params();
  ui::SessionInfo info = sessionInfo(*built->rig);
  info.wallMsAtStreamZero = live ? wallAtLiveZero() : QDateTime::currentMSecsSinceEpoch();
  auto run = std::make_unique<CutRun>(std::move(built->rig), std::move(info), milling::scenarioText(*scenario));
  run->simulates(path);
  run->setLobes(std::make_unique<LobeWorker>(*scenario));
  if (active::SimulatedDuplex::check(*scenario)) run->setActive(makeSimulatedActiveLoopController(*scenario, params));
  if (scenario->grantsAuto) run->send({OperatorAction::GrantBySimulation, Authority::Auto});
  run->again = [path, live, wanted] { return openSimulatedRun(path, live, wanted); };
  if (live && scenario->grantsAuto) run->compareWith(std::make_unique<UncontrolledCut>(*scenario));
  return run;
}

}  // namespace

Result<std::unique_ptr<CutRun>> openScenarioRun(const std::string& path, bool live) {
  return openSimulatedRun(path, live, {});
}

Result<std::unique_ptr<CutRun>> openDemonstrationRun(const std::string& path, bool live) {
  config::ParamSet params;
  const Status later = params.set(pipeline::fullCatalog(), "stable-pocket.confirm", "1500", "demonstration");
  if (!later) return later.error();
  return openSimulatedRun(path, live, params);
}

Status checkProfileRun(const std::string& path) {
  const auto profile = config::loadProfile(path, pipeline::fullCatalog(), knownIds());
  if (!profile) return profile.error();
  if (auto parts = makeProfileParts(*profile, path, nullptr, AnalogOutputs::LeftAlone); !parts) return parts.error();
  if (auto known = stableSpeeds(*profile, modelFile(*profile, path)); !known) return known.error();
  if (auto limits = safety::gateLimits(profile->params, profile->cut, path, {}); !limits) return limits.error();
  if (auto lobes = LobeWorker::ofProfile(*profile, path); !lobes) return lobes.error();
  if (profile->active.id.empty()) return Done{};
  auto table = makeActiveParts(*profile);
  return table ? Status(Done{}) : Status(table.error());
}

Result<std::unique_ptr<CutRun>> openProfileRun(const std::string& path, Recorded recorded) {
  const config::ParamCatalog catalog = pipeline::fullCatalog();
  const auto profile = config::loadProfile(path, catalog, knownIds());
  if (!profile) return profile.error();
  auto rig = buildProfileRig(*profile, path);
  if (!rig) return rig.error();
  ui::SessionInfo info = sessionInfo(**rig);
  info.wallMsAtStreamZero = wallAtLiveZero();
  auto run = std::make_unique<CutRun>(std::move(rig).value(), std::move(info), profileOrigin(*profile, path));
  if (!profile->active.id.empty()) {
    auto parts = makeActiveParts(*profile);
    if (!parts) return parts.error();
    run->setActive(std::make_unique<ActiveLoopController>(std::move(parts->device), parts->options, activeClock()));
  }
  run->madeFrom(path);
  // What cannot be recorded is watched all the same, and the screen says so.
  if (recorded == Recorded::AsProfileSays) (void)run->recordAsSaid(*profile, path).ok();
  auto lobes = LobeWorker::ofProfile(*profile, path);
  if (!lobes) return lobes.error();
  const auto cut = evidenceOf(*profile, path);
  if (*lobes && cut) (*lobes)->learnFrom(defaultCutStore(), *cut);
  run->setLobes(std::move(lobes).value());
  if (cut && *cut) run->tellMargin();
  if (profile->source.id == "simulated") run->again = [path, recorded] { return openProfileRun(path, recorded); };
  // A replay and a simulation are no cuts of the shop. What the model lacks for learning, the lobes have complained of.
  const bool real = profile->source.id != "replay" && profile->source.id != "simulated";
  if (real && cut && *cut) run->keepCuts(std::make_unique<EvidenceLog>(**cut, defaultCutStore()));
  return run;
}

}  // namespace stillcut::app
