#include "app/session/machine_setup.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <filesystem>
#include <utility>

#include "app/compose/profile_rig.h"
#include "app/compose/resource_folder.h"
#include "app/io/alsa_driver.h"
#include "app/io/find_machines.h"
#include "app/io/iio_driver.h"
#include "app/session/machine_trial.h"
#include "app/session/sensor_trial.h"
#include "app/session/session_view.h"
#include "app/session/tool_cut.h"
#include "app/session/tool_library.h"
#include "core/cnc/registry.h"
#include "core/control/registry.h"
#include "core/daq/registry.h"
#include "core/detect/registry.h"
#include "core/pipeline/catalog.h"
#include "core/session/record_params.h"
#include "core/storage/atomic_file.h"
#include "ui/base/say.h"

namespace stillcut::app {
namespace {

constexpr Seconds kFindTime{0.5};  // for every 32 hosts
constexpr const char* kScenario = "scenario";

// What the simulated device shows where nobody has named a cut.
std::string usualScenario() {
  return (resourceFolder() / "scenarios/demo.toml").string();
}

QDir shippedFolder() {
  return QDir(QString::fromStdString((resourceFolder() / "profiles").string()));
}

QStringList profilesIn(const QDir& folder) {
  QStringList names;
  for (const QFileInfo& file : folder.entryInfoList({QStringLiteral("*.toml")}, QDir::Files, QDir::Name)) {
    names.push_back(file.completeBaseName());
  }
  return names;
}

config::Profile withScenario(config::Profile profile) {
  if (profile.source.id == "simulated") profile.source.settings.try_emplace(kScenario, usualScenario());
  return profile;
}

template <class Table>
std::vector<ui::ComponentOption> options(const Table& table) {
  std::vector<ui::ComponentOption> all;
  for (const auto& row : table) all.push_back({viewText(row.id), viewText(row.description)});
  return all;
}

template <class Table>
std::vector<ui::ComponentOption> methods(const Table& table) {
  std::vector<ui::ComponentOption> all;
  for (const auto& row : table) all.push_back({viewText(row.id), viewText(row.make()->describe().label)});
  return all;
}

// A file as it was before a start that may be refused.
class FileBefore {
 public:
  explicit FileBefore(std::string path) : path_(std::move(path)) {
    QFile file(QString::fromStdString(path_));
    if (file.open(QIODevice::ReadOnly)) content_ = file.readAll().toStdString();
  }
  void putBack() const {
    std::error_code gone;
    if (content_) {
      (void)writeFileAtomically(path_, *content_).ok();  // the disk has just taken as much
    } else {
      std::filesystem::remove(path_, gone);
    }
  }

 private:
  std::string path_;
  std::optional<std::string> content_;  // none: it was not there
};

bool sameLink(config::ComponentChoice a, config::ComponentChoice b) {
  for (config::ComponentChoice* link : {&a, &b}) {
    for (const std::string_view delay : {cnc::kSavedDelay, cnc::kSavedEffect}) link->settings.erase(std::string(delay));
  }
  return a.id == b.id && a.settings == b.settings;
}

}  // namespace

bool MachineSetup::poll() {
  const bool opened = listener_.poll();
  auto steps = steps_.take();
  linkTest_.steps.insert(linkTest_.steps.end(), steps.begin(), steps.end());
  bool changed = opened || !steps.empty();
  for (BackgroundTask* task : {&task_, &asking_, &searching_, &testing_, &looking_})
    changed = task->collect() || changed;
  return changed;
}

std::vector<ui::ComponentOption> MachineSetup::sources() const {
  auto all = options(daq::sourceTable());
  // What hits a tool is for the page Tap test; no cut is heard with it.
  std::erase_if(all, [](const ui::ComponentOption& source) { return source.id == QLatin1String("simulated-hammer"); });
  return all;
}

std::vector<ui::ComponentOption> MachineSetup::links() const {
  return options(cnc::linkTable());
}

std::vector<ui::ComponentOption> MachineSetup::detectors() const {
  return methods(detect::detectorTable());
}

std::vector<ui::ComponentOption> MachineSetup::strategies() const {
  return methods(control::strategyTable());
}

std::vector<config::SettingDecl> MachineSetup::sourceSettings(const config::Profile& profile) const {
  // The simulated device's cut is the profile's affair, for its machine runs in the same one.
  if (profile.source.id == "simulated")
    return {{kScenario, config::SettingDecl::Kind::Text, usualScenario(), 0.0, 0.0, {}}};
  std::vector<config::SettingDecl> asked;
  if (profile.source.id.empty()) return asked;
  daq::SourceRequest request;
  request.settings = profile.source.settings;
  request.channels = profile.cut.channels;
  request.asked = &asked;
  (void)daq::makeSource(profile.source.id, request).ok();
  return asked;
}

// The link itself is asked: it is made without a wire, which it says only after its settings.
std::vector<config::SettingDecl> MachineSetup::linkSettings(const config::Profile& profile) const {
  std::vector<config::SettingDecl> asked;
  if (profile.link.id.empty()) return asked;
  cnc::LinkRequest request;
  request.settings = profile.link.settings;
  request.asked = &asked;
  (void)cnc::makeLink(profile.link.id, request).ok();
  return asked;
}

config::ParamTable MachineSetup::recordParams() const {
  return record::recordParams();
}

std::string MachineSetup::profileFile(const QString& name) const {
  return QDir(folder_).filePath(QStringLiteral("profiles/%1.toml").arg(name)).toStdString();
}

QStringList MachineSetup::profiles() const {
  return folder_.isEmpty() ? QStringList() : profilesIn(QDir(QDir(folder_).filePath(QStringLiteral("profiles"))));
}

QStringList MachineSetup::shippedProfiles() const {
  return profilesIn(shippedFolder());
}

Result<config::Profile> MachineSetup::loadShipped(const QString& name) const {
  const std::string file = shippedFolder().filePath(name + QStringLiteral(".toml")).toStdString();
  return config::loadProfile(file, pipeline::fullCatalog(), knownIds());
}

QString MachineSetup::profileInForce() const {
  return inForce.empty() ? QString() : QFileInfo(QString::fromStdString(inForce)).completeBaseName();
}

Result<config::Profile> MachineSetup::load(const QString& name) const {
  return config::loadProfile(profileFile(name), pipeline::fullCatalog(), knownIds());
}

QStringList MachineSetup::devices() const {
  QStringList names = profiles();
  if (const auto begun = withDevice({}); begun && !begun->source.id.empty()) names.prepend(QString());
  return names;
}

Result<config::Profile> MachineSetup::withDevice(const QString& name) const {
  if (!name.isEmpty()) return load(name);
  return withScenario(keptDraft().value_or(draft()));
}

Result<QString> MachineSetup::save(const config::Profile& profile, const QString& name) {
  if (folder_.isEmpty()) return Error{message("profile"), message("there is no folder to keep it in")};
  const bool sayable = !name.isEmpty() && !name.contains(u'/') && !name.startsWith(u'.');
  if (!sayable)
    return Error{message("profile"), message("'%1' is no name for a file", name.toStdString()),
                 message("letters and digits")};
  const std::string file = profileFile(name);
  std::error_code problem;
  std::filesystem::create_directories(std::filesystem::path(file).parent_path(), problem);
  const config::ParamCatalog catalog = pipeline::fullCatalog();
  // What could not be read again is not written.
  const config::Profile complete = withDelays(withScenario(profile));
  const auto sound = config::parseProfile(config::profileText(complete, catalog), file, catalog, knownIds());
  if (!sound) return sound.error();
  if (const Status saved = config::saveProfile(complete, catalog, file); !saved) return saved.error();
  return QString::fromStdString(file);
}

// What was measured of this very link goes with it.
config::Profile MachineSetup::withDelays(config::Profile profile) const {
  const auto put = [&](const LinkDelays& delays) {
    if (profile.link.id.empty() || !sameLink(delays.link, profile.link)) return;
    if (delays.look.value > 0.0) cnc::saveDelay(profile.link.settings, cnc::kSavedDelay, delays.look);
    if (delays.effect.value > 0.0) cnc::saveDelay(profile.link.settings, cnc::kSavedEffect, delays.effect);
  };
  put(tried_);
  if (measured) put(measured());
  return profile;
}

// What the run tells of this very link; nothing: the run has another, or none.
std::optional<RunsLink> MachineSetup::heldByRun(const config::Profile& profile) const {
  if (!linkTold || !measured || !sameLink(measured().link, profile.link)) return std::nullopt;
  return linkTold();
}

std::string MachineSetup::profileFileOrNew(const QString& name) const {
  return profileFile(name.isEmpty() ? QStringLiteral("new") : name);
}

void MachineSetup::listen(const config::Profile& profile, const QString& name) {
  listener_.listen(withScenario(profile), profileFileOrNew(name));
}

ui::DevicePreview MachineSetup::heard() {
  ui::DevicePreview heard = listener_.heard();
  if (heard.state == ui::DevicePreview::State::Off && clocks) heard.clocks = clocks();
  return heard;
}

void MachineSetup::ask(std::function<ui::SensorTrial(const std::atomic<bool>& ended)> sensors) {
  listener_.stop();  // most devices can be opened once
  sensorTrial_ = {ui::SensorTrial::State::Runs, {}, {}};
  asking_.start(
      ui::TaskState::What::None, {},
      [this, sensors = std::move(sensors)](BackgroundTask::Progress& progress) -> Result<BackgroundTask::Apply> {
        return BackgroundTask::Apply([this, said = sensors(progress.stop)] { sensorTrial_ = said; });
      },
      [this](const Error& error) {
        sensorTrial_ = {ui::SensorTrial::State::Bad, ui::sayError(error), {}};
      },
      &listener_.opening());
}

void MachineSetup::calibrate(const config::Profile& profile, const QString& name, int channel, const QString& level,
                             Hertz frequency) {
  ask([profile, path = profileFileOrNew(name), channel, text = level.toStdString(), frequency](
          const std::atomic<bool>& ended) { return calibrateChannel(profile, path, channel, text, frequency, ended); });
}

void MachineSetup::knock(const config::Profile& profile, const QString& name, int channel) {
  ask([profile, path = profileFileOrNew(name), channel](const std::atomic<bool>& ended) {
    return knockAlong(profile, path, channel, ended);
  });
}

// A sound card is opened to be asked what it can, which takes a moment.
void MachineSetup::lookForDevices() {
  if (looking_.state().running) return;
  looking_.start(ui::TaskState::What::None, {}, [this](BackgroundTask::Progress&) -> Result<BackgroundTask::Apply> {
    std::vector<ui::FoundDevice> found;
    for (const daq::PcmDevice& card : alsaDevices()) {
      found.push_back({viewText(card.label.empty() ? card.name : card.label),
                       viewText(card.range),
                       {"alsa", {{"device", card.name}}},
                       {"microphone", SensorQuantity::Sound, 1.0, ""}});
    }
    if (const auto iio = iioDevices("local:")) {
      for (const daq::PcmDevice& device : *iio) {
        found.push_back({viewText(device.label.empty() ? device.name : device.label),
                         viewText(device.range),
                         {"iio", {{"device", device.name}}},
                         {"x", SensorQuantity::Acceleration, 1.0, "x"}});
      }
    }
    return BackgroundTask::Apply([this, found = std::move(found)] { devicesHere_ = found; });
  });
}

void MachineSetup::findMachines(const QString& typed) {
  search_ = {true, false, {}, {}};
  searching_.start(
      ui::TaskState::What::None, {},
      [this, typed = typed.toStdString()](BackgroundTask::Progress& progress) -> Result<BackgroundTask::Apply> {
        ui::MachineSearch found{false, true, {}, {}};
        const auto toEnd = [&progress] { return progress.stopped(); };
        auto hosts = hostsIn("localhost " + typed);
        if (!hosts) found.problem = ui::sayError(hosts.error());
        if (hosts) {
          for (FoundMachine& machine : app::findMachines(*hosts, kFindTime, toEnd)) {
            found.places.push_back({viewText(machine.where), viewText(machine.what), std::move(machine.link)});
          }
        }
        found.done = !toEnd() || !found.places.empty();
        return BackgroundTask::Apply([this, found] { search_ = found; });
      },
      [this](const Error& error) {
        search_ = {false, true, {}, ui::sayError(error)};
      });
}

void MachineSetup::testLink(const config::Profile& profile, const QString& name) {
  testing_.cancel();
  steps_.take();
  if (const auto run = heldByRun(profile)) {
    const bool good = run->state.valid;
    linkTest_ = {good ? ui::LinkTest::State::Good : ui::LinkTest::State::Bad, linkAsRunTells(*run)};
    if (good) tried_ = {profile.link, run->state.link.roundTrip, {}};
    return;
  }
  linkTest_ = {ui::LinkTest::State::Runs, {}};
  testing_.start(
      ui::TaskState::What::None, {},
      [this, profile,
       path = profileFileOrNew(name)](BackgroundTask::Progress& progress) -> Result<BackgroundTask::Apply> {
        const Seconds look = tryLinkOf(profile, path, steps_, progress.stop);
        const auto notGood = progress.stopped() ? ui::LinkTest::State::Off : ui::LinkTest::State::Bad;
        return BackgroundTask::Apply([this, look, notGood, link = profile.link] {
          auto last = steps_.take();
          linkTest_.steps.insert(linkTest_.steps.end(), last.begin(), last.end());
          linkTest_.state = look.value > 0.0 ? ui::LinkTest::State::Good : notGood;
          if (look.value > 0.0) tried_ = {link, look, {}};
        });
      },
      [this](const Error& error) {
        linkTest_.steps.push_back({QStringLiteral("Settings"), ui::sayError(error), false});
        linkTest_.state = ui::LinkTest::State::Bad;
      });
}

void MachineSetup::tryOut(const config::Profile& profile, const QString& name) {
  listener_.stop();  // most devices can be opened once
  trial_ = {{ui::TrialStep::What::Settings, ui::TrialStep::State::Runs, {}}};
  task_.start(
      ui::TaskState::What::None, {},
      [this, profile = withScenario(profile), run = heldByRun(profile),
       path = profileFileOrNew(name)](BackgroundTask::Progress&) -> Result<BackgroundTask::Apply> {
        return BackgroundTask::Apply(
            [this, link = profile.link, tried = tryProfile(profile, path, run ? &*run : nullptr)] {
              trial_ = tried.steps;
              tried_ = {link, tried.look, {}};
            });
      },
      [this](const Error& error) {
        trial_ = {{ui::TrialStep::What::Settings, ui::TrialStep::State::Bad, ui::sayError(error)}};
      },
      &listener_.opening());
}

Status MachineSetup::start(const config::Profile& profile, const QString& name) {
  if (!begin) return Error{message("profile"), message("cannot be put in force here")};
  const FileBefore file(profileFile(name)), older(profileFile(name) + std::string(config::kProfileBefore));
  const auto saved = save(profile, name);
  if (!saved) return saved.error();
  listener_.free();
  Status begun = begin(saved->toStdString(), [&] {
    file.putBack();
    older.putBack();
  });
  std::error_code gone;
  if (begun && !folder_.isEmpty()) std::filesystem::remove(draftFile(), gone);
  return begun;
}

std::string MachineSetup::draftFile() const {
  return QDir(folder_).filePath(QStringLiteral("draft.toml")).toStdString();
}

void MachineSetup::keepDraft(const config::Profile& profile) {
  if (folder_.isEmpty()) return;
  std::error_code problem;
  std::filesystem::create_directories(folder_.toStdString(), problem);
  // SAVE tells why a disk does not take it.
  (void)writeFileAtomically(draftFile(), config::profileText(profile, pipeline::fullCatalog())).ok();
}

std::optional<config::Profile> MachineSetup::keptDraft() const {
  if (folder_.isEmpty()) return std::nullopt;
  auto profile = config::loadProfile(draftFile(), pipeline::fullCatalog(), knownIds());
  return profile ? std::optional(std::move(*profile)) : std::nullopt;
}

Status MachineSetup::startDemonstration() {
  if (!beginDemonstration) return Error{message("demonstration"), message("cannot run here")};
  return beginDemonstration();
}

Result<std::vector<ui::ToolEntry>> MachineSetup::tools() const {
  if (folder_.isEmpty()) return std::vector<ui::ToolEntry>();
  return loadTools(QDir(folder_).filePath(QStringLiteral("tools.toml")).toStdString());
}

// As a profile finds it, which names it beside itself.
std::string MachineSetup::besideProfiles(const QString& file) const {
  return QDir(QDir(folder_).filePath(QStringLiteral("profiles"))).absoluteFilePath(file).toStdString();
}

Result<QString> MachineSetup::cutFile(const ui::ToolEntry& tool) {
  const std::string modes = besideProfiles(tool.modes);
  if (!holdsModesAlone(modes)) return tool.modes;
  if (folder_.isEmpty()) return Error{message("tools"), message("there is no folder to keep them in")};
  const QString path = QDir(QDir(folder_).filePath(QStringLiteral("cuts"))).absoluteFilePath(fileNameOf(tool.name));
  if (const Status written = writeCut(tool, modes, path.toStdString()); !written) return written.error();
  return path;
}

Status MachineSetup::checkToolFile(const QString& file, ToolFile kind) const {
  const std::string path = besideProfiles(file);
  return kind == ToolFile::Modes ? checkModesFile(path) : checkResponseFile(path);
}

Status MachineSetup::saveTools(const std::vector<ui::ToolEntry>& tools) {
  if (folder_.isEmpty()) return Error{message("tools"), message("there is no folder to keep them in")};
  return app::saveTools(tools, QDir(folder_).filePath(QStringLiteral("tools.toml")).toStdString());
}

}  // namespace stillcut::app
