#include "app/session/session.h"

#include <QDateTime>
#include <utility>

#include "app/compose/catalog.h"
#include "app/compose/profile_rig.h"
#include "app/compose/scenario_rig.h"
#include "core/detect/energy_ratio.h"
#include "core/milling/scenario.h"

namespace stillcut::app {
namespace {

QString text(std::string_view s) {
  return QString::fromUtf8(s.data(), static_cast<qsizetype>(s.size()));
}

ui::SessionInfo makeInfo(const Rig& rig) {
  ui::SessionInfo info;
  info.setup = rig.setup();
  for (const auto& detector : rig.chain().parts().detectors) {
    const detect::DetectorInfo d = detector->describe();
    ui::DetectorInfo shown{text(d.id), text(d.label), {}};
    for (std::string_view indicator : d.indicators) shown.indicators.push_back(text(indicator));
    info.detectors.push_back(std::move(shown));
  }
  if (rig.hasLink()) {
    const cnc::LinkInfo link = rig.linkInfo();
    info.linkLabel = text(link.label);
    info.simulatedMachine = link.simulated;
    info.machineWatchdog = link.machineWatchdog;
  }
  info.limits.energyRatio = rig.params().real(detect::kErChatter);
  const CutSetup& cut = info.setup;
  if (cut.teeth > 0 && cut.nominalSpeed.value > 0.0) {
    info.feedPerTooth = Metres(cut.nominalFeed.value / toothPassing(cut.nominalSpeed, cut.teeth).value);
  }
  return info;
}

// Live stream time is the steady clock's.
qint64 wallAtLiveZero() {
  return QDateTime::currentMSecsSinceEpoch() - toNs(SteadyClock().now()) / 1'000'000;
}

}  // namespace

Session::Session(std::unique_ptr<Rig> rig, ui::SessionInfo info, std::string configuration)
    : rig_(std::move(rig)), info_(std::move(info)), configuration_(std::move(configuration)) {}

Session::~Session() {
  (void)stop().ok();
}

void Session::start(const std::filesystem::path& flights) {
  flightLog_.emplace(rig_->flights(), flights);
  flightLog_->start();
  rig_->start({});
}

Status Session::stop() {
  const Status recorded = rig_->stop();
  const Status flown = flightLog_ ? flightLog_->finish() : Status(Done{});
  return recorded ? flown : recorded;
}

const Snapshot* Session::pull() {
  const Snapshot* snapshot = rig_->read();
  if (lobes_ && snapshot != nullptr && !lobes_->started()) {
    const PathHealth& health = snapshot->health;
    lobes_->setStart(snapshot->time - toDuration(health.blockLength * static_cast<double>(health.blocks)));
  }
  return snapshot;
}

ui::LinkStatus Session::link() const {
  if (!rig_->finished()) return {};
  const std::string fault = rig_->device().fault();
  return {{}, fault.empty() ? QStringLiteral("the run has ended") : QString::fromStdString(fault)};
}

ui::RecorderStatus Session::recorder() const {
  const record::Recorder* recorder = rig_->recorder();
  const std::string flightProblem = flightLog_ ? flightLog_->problem() : "";
  if (recorder == nullptr && flightProblem.empty()) return {};
  if (recorder == nullptr) {
    return {ui::RecorderStatus::State::Failed, {}, QString::fromStdString(flightProblem)};
  }
  const record::RecorderStatus status = recorder->status();
  ui::RecorderStatus shown;
  shown.state = status.recording ? ui::RecorderStatus::State::Recording : ui::RecorderStatus::State::Failed;
  shown.length = Seconds(static_cast<double>(status.written) * info_.setup.blockFrames / info_.setup.rate.value);
  shown.problem = QString::fromStdString(status.fault);
  return shown;
}

Result<std::unique_ptr<Session>> openScenarioSession(const std::string& path, bool live) {
  const auto scenario = milling::loadScenario(path);
  if (!scenario) return scenario.error();
  ScenarioOptions options;
  options.methods.strategy = scenario->strategy;
  options.live = live;
  options.watched = true;
  auto built = buildScenarioRig(*scenario, options);
  if (!built) return built.error();

  ui::SessionInfo info = makeInfo(*built->rig);
  info.sourceLabel = QStringLiteral("%1 (%2)").arg(text("simulated cut"), text(scenario->name));
  info.wallMsAtStreamZero = live ? wallAtLiveZero() : QDateTime::currentMSecsSinceEpoch();
  auto session = std::make_unique<Session>(std::move(built->rig), std::move(info), milling::scenarioText(*scenario));
  session->setLobes(std::make_unique<LobeWorker>(*scenario));
  if (scenario->grantsAuto) session->send({OperatorAction::GrantBySimulation, Authority::Auto});
  return session;
}

Result<std::unique_ptr<Session>> openProfileSession(const std::string& path) {
  const config::ParamCatalog catalog = fullCatalog();
  const auto profile = config::loadProfile(path, catalog, knownIds());
  if (!profile) return profile.error();
  auto rig = buildProfileRig(*profile, path);
  if (!rig) return rig.error();
  ui::SessionInfo info = makeInfo(**rig);
  info.sourceLabel = QString::fromStdString(profile->source.id);
  info.wallMsAtStreamZero = wallAtLiveZero();
  return std::make_unique<Session>(std::move(rig).value(), std::move(info), config::profileText(*profile, catalog));
}

}  // namespace stillcut::app
