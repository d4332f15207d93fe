// A scripted session for the screens' tests: a cut that is stable, begins to chatter at 4.5 s and grows, until the
// speed is moved (by Accept under Advise, by itself under Auto); then it dies down. Time passes only in advance().
#pragma once

#include <limits>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "tests/ui/support/fake_lobes.h"
#include "ui/shell/session_facade.h"

namespace stillcut::ui {

class FakeSession final : public SessionFacade {
 public:
  FakeSession();

  const SessionInfo& info() const override { return info_; }
  const Snapshot* pull() override;
  bool replayShown() const override { return replay_.has_value(); }
  const Snapshot* live() override { return started_ ? &snapshot_ : nullptr; }
  void send(const OperatorInput& input, std::uint32_t seen) override;
  RecorderView recorder() const override { return recorder_; }
  LinkStatus link() const override { return link_; }
  std::uint32_t generation() const override { return generation_; }
  void readSignal(const std::function<void(const SampleBlock&)>& sink) override;
  void showChannel(int channel) override { channel_ = channel; }
  LobeService* lobes() override { return replay_ ? replayLobes_ : lobesKnown_ ? &lobes_ : nullptr; }
  LobeEntryController* lobeEntry() override { return lobeEntry_; }
  void setLobeEntry(LobeEntryController* entry) { lobeEntry_ = entry; }
  double vibrationWithout(Instant) override { return without_; }
  std::optional<DepthMargin> depthMargin() const override { return margin_; }
  void setDepthMargin(std::optional<DepthMargin> margin) { margin_ = margin; }
  void setVibrationWithout(double rms) { without_ = rms; }
  bool mayRunAgain() const override { return mayRunAgain_; }
  Status runAgain() override {
    ++runsAgain_;
    return runAgainAnswer_;
  }
  void answerRunAgain(Status status) { runAgainAnswer_ = std::move(status); }
  void setMayRunAgain(bool may) { mayRunAgain_ = may; }
  int runsAgain() const { return runsAgain_; }
  bool replayStands() const override { return replay_ && stands_; }
  QString stateFolder() const override { return stateFolder_; }
  Tuning* tuning() override { return tuning_; }

  void setTuning(Tuning* tuning) { tuning_ = tuning; }
  ActiveController* active() override { return active_; }
  void setActive(ActiveController* controller) { active_ = controller; }
  SetupController* setup() override { return setup_; }
  void setSetup(SetupController* controller) { setup_ = controller; }
  TapController* tap() override { return tap_; }
  void setTap(TapController* controller) { tap_ = controller; }
  SessionController* sessions() override { return sessions_; }
  void setSessions(SessionController* controller) { sessions_ = controller; }

  FileController* files() override { return files_; }
  void setFiles(FileController* controller) { files_ = controller; }

  void keepStateIn(const QString& folder) { stateFolder_ = folder; }
  FakeLobes& fakeLobes() { return lobes_; }
  void forgetLobes() { lobesKnown_ = false; }
  // Of the replay that is shown; null: not known.
  void setReplayLobes(LobeService* lobes) { replayLobes_ = lobes; }
  // The replay is paused.
  void setStands(bool stands) { stands_ = stands; }
  int shownChannel() const { return channel_; }
  // Samples and spectra of the next `s` seconds never arrive.
  void lose(Seconds s) { lost_ = s; }
  // In the place of the story, as it is now; nothing: the story again.
  void showReplay(const std::optional<Snapshot>& replay) {
    replay_ = replay;
    ++generation_;
  }
  // As if something else had been opened, with another machine.
  void openOther(const std::string& machine) {
    info_.setup.machine = machine;
    ++generation_;
  }

  // Lets the story go on, in steps of one spectrum column (40 ms).
  void advance(Seconds s);
  // One display tick's worth: what a test changes by hand shows after this.
  void touch() { ++snapshot_.number; }

  Snapshot& snapshot() { return snapshot_; }
  SessionInfo& mutableInfo() { return info_; }
  RecorderView& mutableRecorder() { return recorder_; }
  LinkStatus& mutableLink() { return link_; }
  const std::vector<OperatorInput>& sent() const { return sent_; }
  const std::vector<std::uint32_t>& seen() const { return seen_; }  // with which generation on the screen

 private:
  void step();
  void stepChatter();
  void fillVerdict();
  void fillAdvice();
  void fillMachine();
  void finishIntervention();
  void makeColumn();
  void makeSignal();

  SessionInfo info_;
  Snapshot snapshot_;
  std::optional<Snapshot> replay_;
  RecorderView recorder_;
  LinkStatus link_;
  QString stateFolder_;
  FakeLobes lobes_;
  bool lobesKnown_ = true;
  LobeService* replayLobes_ = nullptr;
  LobeEntryController* lobeEntry_ = nullptr;
  std::optional<DepthMargin> margin_;
  double without_ = std::numeric_limits<double>::quiet_NaN();
  bool mayRunAgain_ = false;
  int runsAgain_ = 0;
  Status runAgainAnswer_ = Done{};
  bool stands_ = false;
  int channel_ = 0;
  Seconds lost_{};
  std::vector<SampleBlock> signal_;
  Tuning* tuning_ = nullptr;
  ActiveController* active_ = nullptr;
  SessionController* sessions_ = nullptr;
  SetupController* setup_ = nullptr;
  TapController* tap_ = nullptr;
  FileController* files_ = nullptr;
  std::uint32_t generation_ = 0;
  std::vector<OperatorInput> sent_;
  std::vector<std::uint32_t> seen_;
  std::mt19937 random_{7};
  bool started_ = false;
  bool moved_ = false;
  bool alarmed_ = false;
  double amplitude_ = 1e-3;  // of chatter, 1 is full
  double speed_ = 8800.0;    // actual, follows the target as a spindle does
  double onset_ = 0.0;       // s
  double peak_ = 0.0;
};

}  // namespace stillcut::ui
