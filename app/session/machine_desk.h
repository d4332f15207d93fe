// MachineDesk: the parts a machine can be made of, profiles and tools of the user's folder, and trials of what was
// chosen. Putting a profile in force is the session's. Thread: GUI; a trial runs apart.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/session/background_task.h"
#include "app/session/device_listener.h"
#include "ui/models/setup_desk.h"

namespace stillcut::app {

class MachineDesk final : public ui::SetupDesk {
 public:
  // Empty: nothing can be kept.
  void keepIn(const QString& folder) { folder_ = folder; }
  // The session: what runs, and how another cut takes its place.
  std::function<config::Profile()> running;
  std::function<Status(const std::string& profile)> begin;
  std::function<Status()> beginDemonstration;
  std::string inForce;  // file of the profile that runs; empty: none

  bool poll() override;
  std::vector<ui::PartOption> sources() const override;
  std::vector<ui::PartOption> links() const override;
  std::vector<ui::PartOption> detectors() const override;
  std::vector<ui::PartOption> strategies() const override;
  std::vector<config::AskedSetting> sourceSettings(const config::Profile& profile) const override;
  std::vector<config::AskedSetting> linkSettings(const config::Profile& profile) const override;
  QStringList profiles() const override;
  QString profileInForce() const override;
  Result<config::Profile> load(const QString& name) const override;
  Result<QString> save(const config::Profile& profile, const QString& name) override;
  config::Profile draft() const override { return running ? running() : config::Profile(); }
  void listen(const config::Profile& profile, const QString& name) override;
  void stopListening() override { listener_.stop(); }
  ui::Heard heard() override { return listener_.heard(); }
  void tryOut(const config::Profile& profile, const QString& name) override;
  const std::vector<ui::TrialStep>& trial() const override { return trial_; }
  Status start(const QString& name) override;
  Status startDemonstration() override;
  Result<std::vector<ui::ToolEntry>> tools() const override;
  Status saveTools(const std::vector<ui::ToolEntry>& tools) override;

 private:
  std::string profileFile(const QString& name) const;

  QString folder_;
  std::vector<ui::TrialStep> trial_;
  BackgroundTask task_;
  DeviceListener listener_;
};

}  // namespace stillcut::app
