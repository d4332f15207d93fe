// Session: what the desktop shows, behind the facade the screens know. One rig, live on its threads or advanced block
// by block for a picture without waiting. Thread: GUI.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "app/compose/flight_log.h"
#include "app/compose/rig.h"
#include "app/session/active_loop_controller.h"
#include "app/session/deletions.h"
#include "app/session/lobe_worker.h"
#include "app/session/machine_setup.h"
#include "app/session/replay_controller.h"
#include "app/session/run_tuning.h"
#include "ui/models/tune/tuning.h"
#include "ui/shell/session_facade.h"

namespace stillcut::ui {
class MainWindow;
}

namespace stillcut::app {

class Session final : public ui::SessionFacade, public ui::Tuning {
 public:
  // `rig` built with spec.watched; `configuration` is what a recording keeps as the text in force.
  Session(std::unique_ptr<Rig> rig, ui::SessionInfo info, std::string configuration);
  ~Session() override;

  // Before start(): everything goes to the session file as well.
  Status recordTo(const std::string& path) { return rig_->recordTo(path, configuration_); }
  // What was asked for when the program was started goes before what a profile says, also of those put in force later:
  // into the same folder, or into FILE-2.h5 and so on.
  Status recordAsAsked(const std::string& fileOrFolder);
  // The same as recordTo(), below a folder, as the parameters record.* say.
  Status recordInto(const std::string& folder);
  // The same where `profile`, of the file `path`, says so.
  Status recordAsSaid(const config::Profile& profile, const std::string& path);
  // The file that changed parameters are kept in.
  void madeFrom(const std::string& profile) { profile_ = machine_.inForce = profile; }
  // Before the window is made: where the screens keep what outlives a restart.
  void keepStateIn(const QString& folder) {
    stateFolder_ = folder;
    machine_.keepIn(folder);
  }
  // The model that the Lobes page looks at.
  void setLobes(std::unique_ptr<LobeWorker> lobes) { lobes_ = std::move(lobes); }
  // The active work-holder of the machine.
  void setActive(std::unique_ptr<ActiveLoopController> active) { active_ = std::move(active); }
  // What the Set up page may show of a first start.
  void demonstrateWith(const std::string& scenario);
  // Before start(): where flight recordings go.
  void keepFlightsIn(const std::filesystem::path& folder) { flights_ = folder; }
  // Threads on.
  void start();
  // The end of the window is the end of the run, as stop() says; `tell` has what went wrong.
  void endWith(const ui::MainWindow& window, std::function<void(const Error&)> tell);
  // Threads off; the machine has its programmed values back, what was recorded is on the disk. An error: not all of it.
  Status stop();
  // Instead of start(): one block at once. False: the source has ended.
  bool advance() { return rig_->advance(); }

  const ui::SessionInfo& info() const override { return shown() ? replays_.info() : info_; }
  std::uint32_t generation() const override { return runs_ + replays_.generation(); }
  const Snapshot* pull() override;
  bool replayShown() const override { return shown(); }
  bool replayStands() const override { return shown() && !replays_.replay().playing; }
  const ui::SessionInfo& liveInfo() const override { return info_; }
  const Snapshot* live() override { return live_; }
  void readSignal(const std::function<void(const SampleBlock&)>& sink) override { shownSignal().read(sink); }
  void showChannel(int channel) override;
  // Always to the cut. Whoever gives us authority over the machine has it back on every page.
  void send(const OperatorInput& input, std::uint32_t seen) override;
  ui::RecorderView recorder() const override;
  ui::LinkStatus link() const override;
  ui::LobeService* lobes() override { return shown() ? replays_.lobes() : lobes_.get(); }
  QString stateFolder() const override { return stateFolder_; }
  ui::Tuning* tuning() override { return this; }
  ui::SessionController* sessions() override { return &replays_; }
  ui::ActiveController* active() override { return active_.get(); }
  ui::SetupController* setup() override { return &machine_; }
  // Lists them, and puts them there when a profile does not say otherwise.
  void keepRecordingsIn(const QString& folder);

  std::uint32_t tuningRun() const override { return generation(); }
  const std::vector<ui::TunableComponent>& tunableParts() const override;
  const RuleTables* rulesNow() override;
  std::vector<ui::AutoReading> ownNow(const ui::TunableComponent& part) override {
    return ownReadings(shownRig(), part);
  }
  ui::TuningController& controller() override { return shown() ? replayTuned_ : cutTuned_; }
  Result<QString> saveValues(const config::ParamSet& values) override;

 private:
  bool shown() const { return replays_.shownEverywhere() && replays_.rig() != nullptr; }
  const Rig& shownRig() const { return shown() ? *replays_.rig() : *rig_; }
  pipeline::SignalTap& shownSignal() { return shown() ? *replays_.signal() : rig_->signal(); }
  Status mayShowReplay() const;
  // What was set on the Tune page reaches its run.
  void tune();
  const config::ParamDecl* noteTuned(const OperatorInput& input);
  QStringList tunedSettings() const;
  config::Profile runningProfile() const;
  // Another run takes the place of this one, whose machine gets its programmed values back first.
  using Opening = std::function<Result<std::unique_ptr<Session>>()>;
  Status switchTo(const Opening& open);
  Status recordAsked();
  // `next`, recorded as was asked for; as it is where nobody asked.
  Result<std::unique_ptr<Session>> asAsked(Result<std::unique_ptr<Session>> next) const;

  std::unique_ptr<Rig> rig_;
  ReplayController replays_;
  MachineSetup machine_;
  std::uint32_t runs_ = 0;
  std::filesystem::path flights_;
  ui::SessionInfo info_;
  std::string configuration_;
  QString stateFolder_;
  QString recordings_;  // folder of this run's; empty: not recorded into one
  std::string asked_;   // where everything is recorded; empty: as each run says
  Deletions deletions_;
  std::unique_ptr<LobeWorker> lobes_;
  std::unique_ptr<ActiveLoopController> active_;
  std::string profile_;                              // the run was made from; empty: none
  mutable std::vector<ui::TunableComponent> parts_;  // of run partsOf_
  mutable std::optional<std::uint32_t> partsOf_;
  const Snapshot* live_ = nullptr;        // as last read
  Authority authority_ = Authority::Off;  // as last seen
  Seconds effect_{};                      // of an order on the machine, as last seen
  ui::TuningController cutTuned_, replayTuned_;
  std::map<std::string, std::string> tuned_;
  RuleTables rules_;                    // as last told
  std::optional<FlightLog> flightLog_;  // goes before the rig it takes from
};

// A session on a scenario's simulated machine: live (paced to the clock, on threads) or for advance(). Auto is chosen
// at the start where the scenario grants it.
Result<std::unique_ptr<Session>> openScenarioSession(const std::string& path, bool live);

// A live session on the device and the machine of a profile. Authority starts Off. It is recorded as the profile says,
// unless it is recorded otherwise.
enum class Recorded { AsProfileSays, Otherwise };
Result<std::unique_ptr<Session>> openProfileSession(const std::string& path,
                                                    Recorded recorded = Recorded::AsProfileSays);

}  // namespace stillcut::app
