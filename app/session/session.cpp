#include "app/session/session.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QFileInfo>
#include <cstdio>
#include <utility>

#include "app/compose/active_setup.h"
#include "app/compose/profile_rig.h"
#include "app/compose/scenario_rig.h"
#include "app/session/run_tuning.h"
#include "app/session/session_view.h"
#include "core/control/fuzzy.h"
#include "core/milling/simulation/scenario.h"
#include "core/pipeline/catalog.h"
#include "core/rt/realtime_thread.h"
#include "core/session/session_folder.h"
#include "ui/base/say.h"
#include "ui/shell/main_window.h"

namespace stillcut::app {
namespace {

// Of what was on the screen.
bool isAnswer(OperatorAction action) {
  switch (action) {
    case OperatorAction::Accept:
    case OperatorAction::Refuse:
    case OperatorAction::TrueAlarm:
    case OperatorAction::FalseAlarm:
    case OperatorAction::ReportChatter:
      return true;
    default:
      return false;
  }
}

// Live stream time is the steady clock's.
qint64 wallAtLiveZero() {
  return QDateTime::currentMSecsSinceEpoch() - toNs(SteadyClock().now()) / 1'000'000;
}

}  // namespace

Session::Session(std::unique_ptr<Rig> rig, ui::SessionInfo info, std::string configuration)
    : rig_(std::move(rig)), info_(std::move(info)), configuration_(std::move(configuration)) {
  replays_.mayShow = [this] { return mayShowReplay(); };
  replays_.tuned = [this] { return tunedSettings(); };
  replays_.began = [this](bool another) {
    if (another) {
      replayTuned_.open(replays_.rig()->params());
    } else {
      replayTuned_.resend();
    }
  };
  cutTuned_.open(rig_->params());
  machine_.running = [this] { return runningProfile(); };
  machine_.measured = [this] { return LinkDelays{runningProfile().link, {}, effect_}; };
  machine_.recorded = [this] { return deletions_.told(rig_->recorder()); };
  machine_.clocks = [this] { return joinedClocks(rig_->device()); };
  machine_.begin = [this](const std::string& path) {
    return switchTo([this, &path] {
      return asAsked(openProfileSession(path, asked_.empty() ? Recorded::AsProfileSays : Recorded::Otherwise));
    });
  };
}

Session::~Session() {
  (void)stop().ok();
}

Status Session::recordInto(const std::string& folder) {
  recordings_ = QString::fromStdString(folder);
  return rig_->recordInto(folder, configuration_, deletions_.teller());
}

Status Session::recordAsAsked(const std::string& fileOrFolder) {
  asked_ = fileOrFolder;
  return recordAsked();
}

Status Session::recordAsked() {
  const bool folder = QFileInfo(QString::fromStdString(asked_)).isDir();
  return folder ? recordInto(asked_) : recordTo(record::freeSessionPath(asked_));
}

Result<std::unique_ptr<Session>> Session::asAsked(Result<std::unique_ptr<Session>> next) const {
  if (asked_.empty() || !next) return next;
  (*next)->asked_ = asked_;
  const Status recording = (*next)->recordAsked();
  if (!recording) return recording.error();
  return next;
}

Status Session::recordAsSaid(const config::Profile& profile, const std::string& path) {
  recordings_ = QString::fromStdString(recordingFolder(profile, path));
  return recordAsProfileSays(*rig_, profile, path, deletions_.teller());
}

void Session::keepRecordingsIn(const QString& folder) {
  machine_.recordIn(folder);
  replays_.setFolder(recordings_.isEmpty() ? folder : recordings_);
}

void Session::start() {
  flightLog_.emplace(rig_->flights(), flights_);
  flightLog_->start();
  // With a real sensor, a page that has to come back from the disk would keep the worker waiting. Where it is not
  // permitted the cut is watched all the same.
  if (rig_->device().live() && !rt::lockMemory()) {
    std::fputs("stillcut: memory is not locked: not permitted (the package's limits allow it to the group stillcut)\n",
               stderr);
  }
  rig_->start({});
}

void Session::endWith(const ui::MainWindow& window, std::function<void(const Error&)> tell) {
  QObject::connect(&window, &ui::MainWindow::closed, [this, tell = std::move(tell)] {
    if (const Status kept = stop(); !kept) tell(kept.error());
  });
}

Status Session::stop() {
  if (!rig_) return Done{};      // another session has taken it over
  if (active_) active_->stop();  // its ramp is over long before the disk is
  const Status recorded = rig_->stop();
  const Status flown = flightLog_ ? flightLog_->finish() : Status(Done{});
  return recorded ? flown : recorded;
}

void Session::demonstrateWith(const std::string& scenario) {
  machine_.beginDemonstration = [this, scenario] {
    return switchTo([this, &scenario] { return asAsked(openScenarioSession(scenario, true)); });
  };
}

Status Session::switchTo(const Opening& open) {
  if (rig_->hasLink() && !rig_->linkInfo().simulated && authority_ != Authority::Off) {
    return Error{message("start"), message("the machine is under our authority"), message("set it to Off first")};
  }
  if (Status kept = stop(); !kept) return kept;
  auto next = open();
  if (!next)
    return Error{next.error().where, next.error().what,
                 message("%1; the cut before has been stopped", next.error().why)};
  flightLog_.reset();
  live_ = nullptr;
  rig_ = std::move((*next)->rig_);
  info_ = std::move((*next)->info_);
  configuration_ = std::move((*next)->configuration_);
  profile_ = std::move((*next)->profile_);
  lobes_ = std::move((*next)->lobes_);
  active_ = std::move((*next)->active_);
  deletions_ = std::move((*next)->deletions_);
  recordings_ = (*next)->recordings_;
  if (!recordings_.isEmpty()) replays_.setFolder(recordings_);
  machine_.inForce = profile_;
  tuned_.clear();
  cutTuned_.open(rig_->params());
  authority_ = Authority::Off;
  effect_ = {};
  ++runs_;
  start();
  return Done{};
}

// Of a profile all of it; of a scenario what a profile can say of it.
config::Profile Session::runningProfile() const {
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

const Snapshot* Session::pull() {
  live_ = rig_->read();
  if (live_ != nullptr) authority_ = live_->authority;
  if (live_ != nullptr && live_->machine.link.effect.value > 0.0) effect_ = live_->machine.link.effect;
  if (lobes_ && live_ != nullptr && !lobes_->started()) {
    const PathHealth& health = live_->health;
    lobes_->setStart(live_->time - toDuration(health.blockLength * static_cast<double>(health.blocks)));
  }
  tune();
  return shown() ? replays_.replayed() : live_;
}

void Session::showChannel(int channel) {
  if (shown()) {
    replays_.showChannel(channel);
  } else {
    rig_->showChannel(channel);
  }
}

void Session::send(const OperatorInput& input, std::uint32_t seen) {
  if (isAnswer(input.action) && (shown() || seen != generation())) return;
  if (input.action == OperatorAction::SetAuthority && input.authority != Authority::Off) {
    authority_ = input.authority;
    (void)replays_.showEverywhere(false).ok();  // whoever puts us in command sees the machine
  }
  rig_->send(input);
  // Back to what was programmed is: nothing of Stillcut acts, also not through the table.
  if (input.action == OperatorAction::BackToProgrammed && active_) active_->stop();
}

void Session::tune() {
  constexpr int kInputsPerTick = 4;  // as many as one block takes
  if (live_ != nullptr) {
    for (const OperatorInput& input : cutTuned_.take(kInputsPerTick)) {
      const config::ParamDecl* decl = noteTuned(input);
      if (active_ && decl != nullptr) active_->tune(decl->key, input.value);
      rig_->send(input);
    }
  }
  if (replays_.rig() == nullptr) return;
  for (const OperatorInput& input : replayTuned_.take(kInputsPerTick)) {
    noteTuned(input);
    replays_.send(input);
  }
}

const config::ParamDecl* Session::noteTuned(const OperatorInput& input) {
  const config::ParamCatalog catalog = pipeline::fullCatalog();
  for (const config::ParamDecl* decl : catalog.all()) {
    if (config::parameterId(decl->key) != input.parameter) continue;
    config::ParamSet value;
    if (value.set(*decl, input.value, "tune")) tuned_[std::string(decl->key)] = value.text(*decl);
    return decl;
  }
  return nullptr;
}

// A machine that we command may not go out of sight.
Status Session::mayShowReplay() const {
  if (!rig_->hasLink() || rig_->linkInfo().simulated || authority_ == Authority::Off) return Done{};
  return Error{message("replay"), message("the machine is under our authority"), message("set it to Off first")};
}

QStringList Session::tunedSettings() const {
  QStringList settings;
  for (const auto& [key, value] : tuned_) {
    settings.push_back(QStringLiteral("%1=%2").arg(QString::fromStdString(key), QString::fromStdString(value)));
  }
  return settings;
}

const std::vector<ui::TunableComponent>& Session::tunableParts() const {
  if (partsOf_ != generation()) {
    parts_ = app::tunableParts(shownRig());
    partsOf_ = generation();
  }
  return parts_;
}

const RuleTables* Session::rulesNow() {
  const auto* fuzzy = dynamic_cast<const control::Fuzzy*>(shownRig().chain().parts().strategy.get());
  if (fuzzy == nullptr) return nullptr;
  fuzzy->tellRules(rules_);
  return &rules_;
}

Result<QString> Session::saveValues(const config::ParamSet& values) {
  return keepValues({values, shownRig().params()}, profile_, stateFolder_);
}

ui::LinkStatus Session::link() const {
  if (!rig_->finished()) return {{}, ui::sayCore(rig_->device().trouble())};
  const Message fault = rig_->device().fault();
  return {{}, fault.empty() ? QCoreApplication::translate("Session", "The run has ended") : ui::sayCore(fault)};
}

ui::RecorderView Session::recorder() const {
  const record::Recorder* recorder = rig_->recorder();
  const Message flightProblem = flightLog_ ? flightLog_->problem() : Message();
  if (recorder == nullptr && flightProblem.empty()) return {};
  if (recorder == nullptr) {
    return {ui::RecorderView::State::Failed, {}, ui::sayCore(flightProblem)};
  }
  const record::RecorderStatus status = recorder->status();
  ui::RecorderView shown;
  shown.state = status.recording ? ui::RecorderView::State::Recording : ui::RecorderView::State::Failed;
  shown.length = Seconds(static_cast<double>(status.written) * info_.setup.blockFrames / info_.setup.rate.value);
  shown.problem = ui::sayCore(status.fault);
  shown.waiting = status.recording && status.written > 0 && !status.writing;
  return shown;
}

Result<std::unique_ptr<Session>> openScenarioSession(const std::string& path, bool live) {
  const auto scenario = milling::loadScenario(path);
  if (!scenario) return scenario.error();
  ScenarioOptions options;
  // A work-holder is no strategy of the machine's: beside its loop the cut is watched.
  options.methods.strategy = scenario->strategy == "active" ? "monitor" : scenario->strategy;
  options.live = live;
  options.watched = true;
  auto built = buildScenarioRig(*scenario, options);
  if (!built) return built.error();

  const config::ParamSet params = built->rig->params();
  ui::SessionInfo info = sessionInfo(*built->rig);
  info.wallMsAtStreamZero = live ? wallAtLiveZero() : QDateTime::currentMSecsSinceEpoch();
  auto session = std::make_unique<Session>(std::move(built->rig), std::move(info), milling::scenarioText(*scenario));
  session->setLobes(std::make_unique<LobeWorker>(*scenario));
  if (active::SimulatedDuplex::check(*scenario))
    session->setActive(makeSimulatedActiveLoopController(*scenario, params));
  if (scenario->grantsAuto) session->send({OperatorAction::GrantBySimulation, Authority::Auto}, session->generation());
  return session;
}

Result<std::unique_ptr<Session>> openProfileSession(const std::string& path, Recorded recorded) {
  const config::ParamCatalog catalog = pipeline::fullCatalog();
  const auto profile = config::loadProfile(path, catalog, knownIds());
  if (!profile) return profile.error();
  auto rig = buildProfileRig(*profile, path);
  if (!rig) return rig.error();
  ui::SessionInfo info = sessionInfo(**rig);
  info.wallMsAtStreamZero = wallAtLiveZero();
  auto session = std::make_unique<Session>(std::move(rig).value(), std::move(info), profileOrigin(*profile, path));
  if (!profile->active.id.empty()) {
    auto parts = makeActiveParts(*profile);
    if (!parts) return parts.error();
    session->setActive(std::make_unique<ActiveLoopController>(std::move(parts->device), parts->options, activeClock()));
  }
  session->madeFrom(path);
  if (recorded == Recorded::AsProfileSays) {
    if (const Status recording = session->recordAsSaid(*profile, path); !recording) return recording.error();
  }
  auto lobes = LobeWorker::ofProfile(*profile, path);
  if (!lobes) return lobes.error();
  session->setLobes(std::move(lobes).value());
  return session;
}

}  // namespace stillcut::app
