// Session: what the desktop shows, behind the facade the screens know: a run of the machine, a replay that may take its
// place on the pages, what is set up and tuned. It routes; each of them does its own work. Thread: GUI.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "app/log/program_log.h"
#include "app/session/cut_run.h"
#include "app/session/file/file_controller.h"
#include "app/session/last_run.h"
#include "app/session/lobes/entered_cut.h"
#include "app/session/machine_setup.h"
#include "app/session/replay/replay_controller.h"
#include "app/session/session_tuning.h"
#include "app/session/tap/tap_bench.h"
#include "ui/shell/session_facade.h"

namespace stillcut::ui {
class MainWindow;
}

namespace stillcut::app {

class Session final : public ui::SessionFacade {
 public:
  explicit Session(std::unique_ptr<CutRun> run);

  CutRun& run() { return *run_; }
  // Before start(): everything goes to the session file, or into the folder. What was asked for when the program was
  // started goes before what a profile says, also of those put in force later: into the same folder, or into FILE-2.h5
  // and so on.
  Status recordAsAsked(const std::string& fileOrFolder);
  // Before the window is made: where the screens keep what outlives a restart.
  void keepStateIn(const QString& folder) {
    stateFolder_ = folder;
    machine_.keepIn(folder);
    tap_.keepIn(folder);
    last_ = LastRun(folder);
  }
  // Something that whoever sits down at the screen should know, until a touch of his shows that he is there.
  void tell(const QString& notice) { notice_ = notice; }
  // What the Set up page may show of a first start.
  void demonstrateWith(const std::string& scenario);
  // Before start(): where flight recordings go.
  void keepFlightsIn(const std::filesystem::path& folder) { flights_ = folder; }
  // The same for what goes into the program's log.
  void logTo(ProgramLog log) { log_ = std::move(log); }
  // Lists recordings, and puts them there when a profile does not say otherwise.
  void keepRecordingsIn(const QString& folder);
  // Threads on.
  void start();
  // The end of the window is the end of the run, as stop() says; `tell` has what went wrong.
  void endWith(const ui::MainWindow& window, std::function<void(const Error&)> tell);
  Status stop();
  // Instead of start(): one block at once. False: the source has ended.
  bool advance() { return run_->rig().advance(); }

  const ui::SessionInfo& info() const override { return shown() ? replays_.info() : run_->info(); }
  std::uint32_t generation() const override { return runs_ + replays_.generation(); }
  const Snapshot* pull() override;
  bool replayShown() const override { return shown(); }
  bool replayStands() const override { return shown() && !replays_.replay().playing; }
  const ui::SessionInfo& liveInfo() const override { return run_->info(); }
  const Snapshot* live() override { return run_->live(); }
  void readSignal(const std::function<void(const SampleBlock&)>& sink) override;
  void showChannel(int channel) override;
  // Always to the cut. Whoever gives us authority over the machine has it back on every page.
  void send(const OperatorInput& input, std::uint32_t seen) override;
  ui::RecorderView recorder() const override { return run_->recorder(); }
  ui::LinkStatus link() const override;
  ui::LobeService* lobes() override { return shown() ? replays_.lobes() : run_->lobes(); }
  double vibrationWithout(Instant t) override { return run_->vibrationWithout(t); }
  std::optional<ui::DepthMargin> depthMargin() const override { return run_->margin(); }
  bool mayRunAgain() const override { return run_->again && run_->rig().finished(); }
  Status runAgain() override;
  ui::LobeEntryController* lobeEntry() override { return &entered_; }
  QString stateFolder() const override { return stateFolder_; }
  ui::Tuning* tuning() override { return &tuning_; }
  ui::SessionController* sessions() override { return &replays_; }
  ui::FileController* files() override { return &files_; }
  ui::ActiveController* active() override { return run_->active(); }
  ui::SetupController* setup() override { return &machine_; }
  ui::TapController* tap() override { return &tap_; }

 private:
  bool shown() const { return replays_.shownEverywhere() && replays_.rig() != nullptr; }
  // An error where a machine that we command would go out of sight, or lose its run.
  Status mayLeaveMachine(Message doing) const;
  void sendTuned();
  // Another run takes the place of this one, whose machine gets its programmed values back first. Where it cannot be
  // opened the one before begins anew, as far as it has a profile, with authority Off.
  using Opening = std::function<Result<std::unique_ptr<CutRun>>()>;
  // `failed`: before the machine before runs again.
  Status switchTo(
      const Opening& open, const std::function<void()>& failed = [] {});
  Opening opening(const std::string& profile) const;
  void place(std::unique_ptr<CutRun> next);

  ProgramLog log_;  // outlives the run
  std::unique_ptr<CutRun> run_;
  ReplayController replays_;
  DeskFileController files_;
  MachineSetup machine_;
  TapBench tap_;
  EnteredCutLobes entered_;
  SessionTuning tuning_;
  std::uint32_t runs_ = 0;  // placed before this one
  std::filesystem::path flights_;
  QString stateFolder_, notice_;
  LastRun last_{QString()};
  int ticks_ = 0;
  std::string asked_;  // where everything is recorded; empty: as each run says
};

// A session on what openScenarioRun(), openDemonstrationRun() and openProfileRun() open.
Result<std::unique_ptr<Session>> openScenarioSession(const std::string& path, bool live);
Result<std::unique_ptr<Session>> openDemonstrationSession(const std::string& path, bool live);
Result<std::unique_ptr<Session>> openProfileSession(const std::string& path,
                                                    Recorded recorded = Recorded::AsProfileSays);

}  // namespace stillcut::app
