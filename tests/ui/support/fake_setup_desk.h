// A desk of two devices, two links and a folder in memory.
#pragma once

#include <map>
#include <optional>
#include <utility>

#include "core/session/record_params.h"
#include "ui/facade/setup_controller.h"

namespace stillcut::ui {

class FakeSetupDesk final : public SetupController {
 public:
  bool poll() override { return std::exchange(changed, false); }
  std::vector<ComponentOption> sources() const override {
    return {{QStringLiteral("simulated"),
             QStringLiteral("A simulated cut from a scenario file, in real time or as fast as possible")},
            {QStringLiteral("alsa"), QStringLiteral("A sound card")}};
  }
  std::vector<ComponentOption> links() const override {
    return {
        {QStringLiteral("simulated"), QStringLiteral("The control of the simulated mill")},
        {QStringLiteral("linuxcnc"), QStringLiteral("LinuxCNC through linuxcncrsh and halrmt: host, port, hal_port")},
        {QStringLiteral("grbl"), QStringLiteral("GRBL")},
        {QStringLiteral("modbus"), QStringLiteral("Modbus")},
        {QStringLiteral("analog"), QStringLiteral("Analog")}};
  }
  std::vector<ComponentOption> detectors() const override {
    return {{QStringLiteral("energy-ratio"), QStringLiteral("Energy ratio")},
            {QStringLiteral("coherence"), QStringLiteral("Coherence")}};
  }
  std::vector<ComponentOption> strategies() const override {
    return {{QStringLiteral("monitor"), QStringLiteral("Monitoring only")},
            {QStringLiteral("stable-pocket"), QStringLiteral("Next stable pocket, checked")}};
  }
  std::vector<config::SettingDecl> sourceSettings(const config::Profile& profile) const override {
    if (profile.source.id != "simulated") return {};
    return {{"scenario", config::SettingDecl::Kind::Text, "", 0.0, 0.0, {}}};
  }
  // As the link itself asks: what its settings are hangs on those it has.
  std::vector<config::SettingDecl> linkSettings(const config::Profile& profile) const override {
    std::vector<config::SettingDecl> asked;
    if (profile.link.id != "linuxcnc") return asked;
    config::ComponentSettings settings(profile.link.settings, "link 'linuxcnc'", &asked);
    settings.text("host", "127.0.0.1");
    settings.whole("port", 5007, 1, 65535);
    settings.flag("adaptive_feed", false);
    settings.choice("restore", 0, {"program", "hundred"});
    settings.whole("lowest_speed_percent", 50, 1, 100);
    return asked;
  }
  config::ParamTable recordParams() const override { return record::recordParams(); }
  QString usualRecordings() const override { return QStringLiteral("/home/mill/recordings"); }
  RecordingNow recordingNow() const override { return recording; }
  QStringList profiles() const override {
    QStringList names;
    for (const auto& [name, profile] : kept) names.push_back(name);
    return names;
  }
  QStringList shippedProfiles() const override { return {QStringLiteral("microphone")}; }
  Result<config::Profile> loadShipped(const QString&) const override {
    config::Profile profile;
    profile.source.id = "alsa";
    profile.cut.machine = "Mill in bay 1";
    return profile;
  }
  QString profileInForce() const override { return inForce; }
  Result<config::Profile> load(const QString& name) const override {
    const auto found = kept.find(name);
    if (found == kept.end()) return Error{name.toStdString(), message("does not exist")};
    return found->second;
  }
  Result<QString> save(const config::Profile& profile, const QString& name) override {
    if (name.isEmpty())
      return Error{message("profile"), message("'' is no name for a file"), message("letters and digits")};
    kept[name] = profile;
    return name + QStringLiteral(".toml");
  }
  config::Profile draft() const override { return running; }
  void keepDraft(const config::Profile& profile) override { begun = profile; }
  std::optional<config::Profile> keptDraft() const override { return begun; }
  void lookForDevices() override { ++lookedForDevices; }
  const std::vector<FoundDevice>& devicesHere() const override { return pluggedIn; }
  std::vector<FoundDevice> pluggedIn;
  int lookedForDevices = 0;
  void listen(const config::Profile& profile, const QString&) override {
    listenedTo = QString::fromStdString(profile.source.id);
    ears.state = DevicePreview::State::Opening;
  }
  void stopPreview() override {
    listenedTo.clear();
    ears = {};
  }
  DevicePreview heard() override { return ears; }
  void calibrate(const config::Profile& profile, const QString&, int channel, const QString& level,
                 Hertz frequency) override {
    calibrated = QStringLiteral("%1 %2 %3").arg(channel).arg(level).arg(frequency.value);
    askedByHand = {SensorTrial::State::Runs, {}, {{channel, profile.cut.channels[static_cast<std::size_t>(channel)]}}};
  }
  void knock(const config::Profile& profile, const QString&, int channel) override {
    knockedAlong = channel;
    askedByHand = {SensorTrial::State::Runs, {}, {{channel, profile.cut.channels[static_cast<std::size_t>(channel)]}}};
  }
  const SensorTrial& sensorTrial() const override { return askedByHand; }
  void findMachines(const QString& typed) override {
    lookedAt.push_back(typed);
    finding = {true, false, {}, {}};
  }
  void stopFinding() override { finding.runs = false; }
  const MachineSearch& search() const override { return finding; }
  void testLink(const config::Profile& profile, const QString&) override {
    tested = profile.link;
    test = {LinkTest::State::Runs, {}};
  }
  void stopTest() override { test.state = LinkTest::State::Off; }
  const LinkTest& linkTest() const override { return test; }
  void tryOut(const config::Profile& profile, const QString&) override {
    steps = {{TrialStep::What::Settings, TrialStep::State::Good, {}},
             {TrialStep::What::Device, TrialStep::State::Good, QStringLiteral("25600 Hz, 2 channel(s)")},
             {TrialStep::What::Samples, TrialStep::State::Good, QStringLiteral("x 0.42 m/s2, y 0.39 m/s2")}};
    if (!profile.link.id.empty()) {
      steps.push_back({TrialStep::What::Link, TrialStep::State::Bad,
                       QStringLiteral("127.0.0.1:5007: connection refused (is linuxcncrsh running?)")});
      steps.push_back({TrialStep::What::Machine, TrialStep::State::Waits, {}});
    }
    changed = true;
  }
  const std::vector<TrialStep>& trial() const override { return steps; }
  Status start(const config::Profile& profile, const QString& name) override {
    if (refuse)
      return Error{message("start"), message("the machine is under our authority"), message("set it to Off first")};
    if (const auto saved = save(profile, name); !saved) return saved.error();
    inForce = name;
    return Done{};
  }
  Status startDemonstration() override {
    ++demonstrations;
    return Done{};
  }
  Result<std::vector<ToolEntry>> tools() const override { return shop; }
  Result<QString> cutFile(const ToolEntry& tool) override { return tool.modes; }
  Status checkToolFile(const QString& file, ToolFile) const override {
    if (!file.endsWith(QStringLiteral(".doc"))) return Done{};
    return Error{file.toStdString(), message("holds no [[mode]]")};
  }
  Status saveTools(const std::vector<ToolEntry>& tools) override {
    shop = tools;
    return Done{};
  }

  std::map<QString, config::Profile> kept;
  config::Profile running;
  std::optional<config::Profile> begun;
  std::vector<ToolEntry> shop;
  std::vector<TrialStep> steps;
  QString inForce, listenedTo, calibrated;
  DevicePreview ears;
  RecordingNow recording;
  SensorTrial askedByHand;
  int knockedAlong = -1;
  QStringList lookedAt;
  MachineSearch finding;
  config::ComponentChoice tested;
  LinkTest test;
  int demonstrations = 0;
  bool changed = false, refuse = false;
};

}  // namespace stillcut::ui
