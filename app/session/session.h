// Session: what the desktop shows, behind the facade the screens know. One rig, live on its threads or advanced block
// by block for a picture without waiting. Thread: GUI.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/compose/flight_log.h"
#include "app/compose/rig.h"
#include "app/session/lobe_worker.h"
#include "ui/shell/session_facade.h"

namespace stillcut::app {

class Session final : public ui::SessionFacade {
 public:
  // `rig` built with spec.watched; `configuration` is what a recording keeps as the text in force.
  Session(std::unique_ptr<Rig> rig, ui::SessionInfo info, std::string configuration);
  ~Session() override;

  // Before start(): everything goes to the session file as well.
  Status recordTo(const std::string& path) { return rig_->recordTo(path, configuration_); }
  // Before the window is made: where the screens keep what outlives a restart.
  void keepStateIn(const QString& folder) { stateFolder_ = folder; }
  // The model that the Lobes page looks at.
  void setLobes(std::unique_ptr<LobeWorker> lobes) { lobes_ = std::move(lobes); }
  // Threads on. Flight recordings go to `flights`.
  void start(const std::filesystem::path& flights);
  // Threads off; the machine has its programmed values back, what was recorded is on the disk. An error: not all of it.
  Status stop();
  // Instead of start(): one block at once. False: the source has ended.
  bool advance() { return rig_->advance(); }

  const ui::SessionInfo& info() const override { return info_; }
  const Snapshot* pull() override;
  void readSignal(const std::function<void(const SampleBlock&)>& sink) override { rig_->signal().read(sink); }
  void showChannel(int channel) override { rig_->showChannel(channel); }
  void send(const OperatorInput& input) override { rig_->send(input); }
  ui::RecorderStatus recorder() const override;
  ui::LinkStatus link() const override;
  ui::LobeService* lobes() override { return lobes_.get(); }
  QString stateFolder() const override { return stateFolder_; }

 private:
  std::unique_ptr<Rig> rig_;
  ui::SessionInfo info_;
  std::string configuration_;
  QString stateFolder_;
  std::unique_ptr<LobeWorker> lobes_;
  std::optional<FlightLog> flightLog_;  // goes before the rig it takes from
};

// A session on a scenario's simulated machine: live (paced to the clock, on threads) or for advance(). Auto is chosen
// at the start where the scenario grants it.
Result<std::unique_ptr<Session>> openScenarioSession(const std::string& path, bool live);

// A live session on the device and the machine of a profile. Authority starts Off.
Result<std::unique_ptr<Session>> openProfileSession(const std::string& path);

}  // namespace stillcut::app
