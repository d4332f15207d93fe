// MachineSetup: the parts a machine can be made of, profiles and tools of the user's folder, and trials of what was
// chosen. Putting a profile in force is the session's. Thread: GUI; a trial runs apart.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/session/background_task.h"
#include "app/session/device_preview_runner.h"
#include "app/session/machine_trial.h"
#include "ui/facade/setup_controller.h"

namespace stillcut::app {

// Of a link: how long a look at the machine took, and an order to act; 0: not measured.
struct LinkDelays {
  config::ComponentChoice link;
  Seconds look{}, effect{};
};

class MachineSetup final : public ui::SetupController {
 public:
  // Empty: nothing can be kept.
  void keepIn(const QString& folder) { folder_ = folder; }
  // Where recordings go when nobody says otherwise.
  void recordIn(const QString& folder) { recordings_ = folder; }
  // The session: what runs, and how another cut takes its place.
  std::function<config::Profile()> running;
  // Where it fails it calls `putBack`, before the machine before runs again: what was saved for this start goes.
  std::function<Status(const std::string& profile, const std::function<void()>& putBack)> begin;
  std::function<Status()> beginDemonstration;
  std::function<LinkDelays()> measured;                  // by the run
  std::function<std::optional<RunsLink>()> linkTold;     // of the run's real machine; nothing: it has none
  std::function<std::vector<ui::JoinedClock>()> clocks;  // of the run's device
  std::function<ui::RecordingNow()> recorded;            // by the run
  std::string inForce;                                   // file of the profile that runs; empty: none

  // Profiles that name a device, for whoever listens to one without a cut: "" is what is being put together.
  QStringList devices() const;
  Result<config::Profile> withDevice(const QString& name) const;
  std::string profileFileOrNew(const QString& name) const;

  bool poll() override;
  std::vector<ui::ComponentOption> sources() const override;
  std::vector<ui::ComponentOption> links() const override;
  std::vector<ui::ComponentOption> detectors() const override;
  std::vector<ui::ComponentOption> strategies() const override;
  std::vector<config::SettingDecl> sourceSettings(const config::Profile& profile) const override;
  std::vector<config::SettingDecl> linkSettings(const config::Profile& profile) const override;
  config::ParamTable recordParams() const override;
  QString usualRecordings() const override { return recordings_; }
  ui::RecordingNow recordingNow() const override { return recorded ? recorded() : ui::RecordingNow(); }
  QStringList profiles() const override;
  QStringList shippedProfiles() const override;
  Result<config::Profile> loadShipped(const QString& name) const override;
  QString profileInForce() const override;
  Result<config::Profile> load(const QString& name) const override;
  Result<QString> save(const config::Profile& profile, const QString& name) override;
  config::Profile draft() const override { return running ? running() : config::Profile(); }
  void keepDraft(const config::Profile& profile) override;
  std::optional<config::Profile> keptDraft() const override;
  void lookForDevices() override;
  const std::vector<ui::FoundDevice>& devicesHere() const override { return devicesHere_; }
  void listen(const config::Profile& profile, const QString& name) override;
  void stopPreview() override { listener_.stop(); }
  ui::DevicePreview heard() override;
  void calibrate(const config::Profile& profile, const QString& name, int channel, const QString& level,
                 Hertz frequency) override;
  void knock(const config::Profile& profile, const QString& name, int channel) override;
  const ui::SensorTrial& sensorTrial() const override { return sensorTrial_; }
  void findMachines(const QString& typed) override;
  void stopFinding() override { searching_.askToEnd(); }
  const ui::MachineSearch& search() const override { return search_; }
  void testLink(const config::Profile& profile, const QString& name) override;
  void stopTest() override { testing_.askToEnd(); }
  const ui::LinkTest& linkTest() const override { return linkTest_; }
  void tryOut(const config::Profile& profile, const QString& name) override;
  const std::vector<ui::TrialStep>& trial() const override { return trial_; }
  Status start(const config::Profile& profile, const QString& name) override;
  Status startDemonstration() override;
  Result<std::vector<ui::ToolEntry>> tools() const override;
  Result<QString> cutFile(const ui::ToolEntry& tool) override;
  Status checkToolFile(const QString& file, ToolFile kind) const override;
  Status saveTools(const std::vector<ui::ToolEntry>& tools) override;

 private:
  void ask(std::function<ui::SensorTrial(const std::atomic<bool>& ended)> sensors);
  std::optional<RunsLink> heldByRun(const config::Profile& profile) const;
  std::string profileFile(const QString& name) const;
  std::string besideProfiles(const QString& file) const;
  config::Profile withDelays(config::Profile profile) const;
  std::string draftFile() const;

  QString folder_, recordings_;
  std::vector<ui::TrialStep> trial_;
  LinkDelays tried_;
  ui::SensorTrial sensorTrial_;
  ui::MachineSearch search_;
  std::vector<ui::FoundDevice> devicesHere_;
  ui::LinkTest linkTest_;
  LinkStepBox steps_;  // of the test that runs
  BackgroundTask task_, asking_, searching_, testing_, looking_;
  DevicePreviewRunner listener_;
};

}  // namespace stillcut::app
