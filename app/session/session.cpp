#include "app/session/session.h"

#include <utility>

#include "ui/shell/main_window.h"

namespace stillcut::app {
namespace {

constexpr int kRecordingsTried = 5;  // with other limits, on the page Tune

// Of what was on the screen.
bool isAnswer(OperatorAction action) {
  switch (action) {
    case OperatorAction::Accept:
    case OperatorAction::Refuse:
    case OperatorAction::TrueAlarm:
    case OperatorAction::FalseAlarm:
    case OperatorAction::ReportChatter:
    case OperatorAction::UndoMark:
      return true;
    default:
      return false;
  }
}

Result<std::unique_ptr<Session>> sessionOn(Result<std::unique_ptr<CutRun>> run) {
  if (!run) return run.error();
  return std::make_unique<Session>(std::move(run).value());
}

}  // namespace

Session::Session(std::unique_ptr<CutRun> run) : run_(std::move(run)) {
  replays_.mayShow = [this] { return mayLeaveMachine(message("replay")); };
  replays_.tuned = [this] { return tuning_.settings(); };
  replays_.began = [this](bool another) {
    if (another) {
      tuning_.openReplay(replays_.rig()->params());
    } else {
      tuning_.beginReplayAgain();
    }
  };
  tuning_.generation = [this] { return generation(); };
  tuning_.shownRig = [this]() -> const Rig& { return shown() ? *replays_.rig() : run_->rig(); };
  tuning_.replayShown = [this] { return shown(); };
  tuning_.profile = [this] { return run_->profilePath(); };
  tuning_.folder = [this] { return stateFolder_; };
  tuning_.recordings = [this] { return replays_.newest(kRecordingsTried); };
  tuning_.openCut(run_->rig().params());
  machine_.inForce = run_->profilePath();
  machine_.running = [this] { return run_->asProfile(); };
  machine_.measured = [this] { return LinkDelays{run_->asProfile().link, {}, run_->linkEffect()}; };
  machine_.linkTold = [this] { return run_->linkTold(); };
  machine_.recorded = [this] { return run_->recordingNow(); };
  machine_.clocks = [this] { return joinedClocks(run_->rig().device()); };
  tap_.profiles = [this] { return machine_.devices(); };
  tap_.profile = [this](const QString& name) { return machine_.withDevice(name); };
  tap_.profilePath = [this](const QString& name) { return machine_.profileFileOrNew(name); };
  tap_.library = [this] { return machine_.tools(); };
  tap_.keepLibrary = [this](const std::vector<ui::ToolEntry>& tools) { return machine_.saveTools(tools); };
  machine_.begin = [this](const std::string& path, const std::function<void()>& putBack) -> Status {
    Status may = mayLeaveMachine(message("start"));
    if (may) may = checkProfileRun(path);
    if (!may) putBack();
    return may ? switchTo(opening(path), putBack) : may;
  };
}

Status Session::recordAsAsked(const std::string& fileOrFolder) {
  asked_ = fileOrFolder;
  return run_->recordAt(asked_);
}

void Session::keepRecordingsIn(const QString& folder) {
  machine_.recordIn(folder);
  replays_.setFolder(run_->recordingFolder().isEmpty() ? folder : run_->recordingFolder());
}

void Session::endWith(const ui::MainWindow& window, std::function<void(const Error&)> tell) {
  QObject::connect(&window, &ui::MainWindow::closed, [this, tell = std::move(tell)] {
    if (const Status kept = stop(); !kept) tell(kept.error());
  });
}

void Session::demonstrateWith(const std::string& scenario) {
  machine_.beginDemonstration = [this, scenario] {
    return switchTo([&scenario] { return openDemonstrationRun(scenario, true); });
  };
}

void Session::start() {
  run_->start(flights_, log_);
  last_.begin(QString::fromStdString(run_->profilePath()));
}

Status Session::stop() {
  Status kept = run_->stop();
  last_.end();
  return kept;
}

ui::LinkStatus Session::link() const {
  ui::LinkStatus link = run_->link();
  link.notice = notice_;
  return link;
}

Session::Opening Session::opening(const std::string& profile) const {
  return [profile, otherwise = !asked_.empty()] {
    return openProfileRun(profile, otherwise ? Recorded::Otherwise : Recorded::AsProfileSays);
  };
}

Status Session::switchTo(const Opening& open, const std::function<void()>& failed) {
  if (Status may = mayLeaveMachine(message("start")); !may) return may;
  const std::string before = run_->profilePath();
  (void)stop().ok();  // what its recording lacks is in the log, and no reason not to watch the next cut
  auto next = open();
  if (next) {
    place(std::move(next).value());
    return Done{};
  }
  const Error& error = next.error();
  failed();
  log_.write(LogLevel::Error, "no run begins: " + error.line());
  if (auto again = before.empty() ? Result<std::unique_ptr<CutRun>>(error) : opening(before)(); again) {
    place(std::move(again).value());
    return Error{error.where, error.what, message("%1; the machine before runs again, authority is Off", error.why)};
  }
  return Error{error.where, error.what, message("%1; the cut before has been stopped", error.why)};
}

// From a copy: the run that holds it goes.
Status Session::runAgain() {
  if (!mayRunAgain()) return Error{message("run"), message("cannot be run again")};
  return switchTo(Opening(run_->again));
}

void Session::place(std::unique_ptr<CutRun> next) {
  if (!asked_.empty()) (void)next->recordAt(asked_).ok();  // the run's recorder says what is not recorded
  run_ = std::move(next);
  if (!run_->recordingFolder().isEmpty()) replays_.setFolder(run_->recordingFolder());
  machine_.inForce = run_->profilePath();
  tuning_.openCut(run_->rig().params());
  ++runs_;
  start();
}

const Snapshot* Session::pull() {
  const Snapshot* live = run_->read();
  constexpr int kSometimes = 30;  // ticks: a name on the disk is not needed sooner
  if (live != nullptr && ++ticks_ % kSometimes == 0) last_.recordTo(run_->recordingNow().path);
  sendTuned();
  return shown() ? replays_.replayed() : live;
}

void Session::readSignal(const std::function<void(const SampleBlock&)>& sink) {
  if (shown()) {
    replays_.signal()->read(sink);
  } else {
    run_->readSignal(sink);
  }
}

void Session::showChannel(int channel) {
  if (shown()) {
    replays_.showChannel(channel);
  } else {
    run_->rig().showChannel(channel);
  }
}

void Session::send(const OperatorInput& input, std::uint32_t seen) {
  notice_.clear();
  if (isAnswer(input.action) && (shown() || seen != generation())) return;
  if (input.action == OperatorAction::SetAuthority && input.authority != Authority::Off) {
    (void)replays_.showEverywhere(false).ok();  // whoever puts us in command sees the machine
  }
  run_->send(input);
}

void Session::sendTuned() {
  if (run_->live() != nullptr) {
    tuning_.sendCut([this](const OperatorInput& input, const config::ParamDecl* decl) {
      if (run_->active() != nullptr && decl != nullptr) run_->active()->tune(decl->key, input.value);
      if (decl != nullptr) run_->noteTuned(*decl, input.value);
      run_->rig().send(input);
    });
  }
  if (replays_.rig() == nullptr) return;
  tuning_.sendReplay([this](const OperatorInput& input, const config::ParamDecl* decl) {
    if (decl != nullptr) replays_.noteTuned(*decl, input.value);
    replays_.send(input);
  });
}

Status Session::mayLeaveMachine(Message doing) const {
  if (!run_->commandsMachine()) return Done{};
  return Error{std::move(doing), message("the machine is under our authority"), message("set it to Off first")};
}

Result<std::unique_ptr<Session>> openScenarioSession(const std::string& path, bool live) {
  return sessionOn(openScenarioRun(path, live));
}

Result<std::unique_ptr<Session>> openDemonstrationSession(const std::string& path, bool live) {
  return sessionOn(openDemonstrationRun(path, live));
}

Result<std::unique_ptr<Session>> openProfileSession(const std::string& path, Recorded recorded) {
  return sessionOn(openProfileRun(path, recorded));
}

}  // namespace stillcut::app
