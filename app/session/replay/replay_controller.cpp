#include "app/session/replay/replay_controller.h"

#include <QDateTime>
#include <QFileInfo>
#include <algorithm>
#include <utility>

#include "app/session/file/file_judgement.h"
#include "app/session/replay/detector_runs.h"
#include "app/session/replay/scenario_list.h"
#include "app/session/replay/stoppable_reader.h"
#include "app/session/session_view.h"
#include "core/evaluate/session_summary_builder.h"
#include "core/session/convert_recording.h"
#include "core/session/file/session_markers.h"
#include "ui/base/say.h"

namespace stillcut::app {
namespace {

constexpr double kSamePlace_s = 0.1;  // the newest picture and the place in the file are not of one moment

// Its own time of day; where it does not tell any, clocks count from its beginning: 00:00:00.
qint64 wallMsOf(const SessionSummary& summary) {
  if (summary.started_ns > 0) return summary.started_ns / 1'000'000;
  return QDateTime(QDate::currentDate(), QTime(0, 0)).toMSecsSinceEpoch();
}

}  // namespace

// What was marked is written, whatever else is left.
ReplayController::~ReplayController() {
  closeRun();
  for (BackgroundTask* task : {&task_, &whole_}) task->cancel();
  (void)changes_->make().ok();
}

std::vector<std::string> ReplayController::newest(int most) const {
  std::vector<const ui::SessionEntry*> byTime;
  for (const ui::SessionEntry& entry : entries()) byTime.push_back(&entry);
  std::ranges::stable_sort(byTime, std::greater{}, &ui::SessionEntry::wallMs);
  std::vector<std::string> paths;
  for (const ui::SessionEntry* entry : byTime) {
    if (static_cast<int>(paths.size()) < most) paths.push_back(entry->path.toStdString());
  }
  return paths;
}

void ReplayController::closeRun() {
  if (!run_) return;
  run_->stop();
  run_.reset();
  if (everywhere_) ++generation_;
}

bool ReplayController::poll() {
  const bool simulated = scenarioTask_.collect();
  const bool listed = lister_.collect() || simulated;
  const bool done = task_.collect();
  const bool read = whole_.collect();
  // What was open stays where another could not be opened.
  if (done && !run_ && !resumeState_ && summary_) reopen(ui::TaskState::What::None, {});
  return std::exchange(changed_, false) || listed || done || read;
}

void ReplayController::setFolder(const QString& folder) {
  lister_.list(folder);
  scenarioTask_.start(ui::TaskState::What::None, folder,
                      [this, folder](BackgroundTask::Progress& progress) -> Result<BackgroundTask::Apply> {
                        auto found = scenariosFor(folder, [&progress] { return !progress.stopped(); });
                        return BackgroundTask::Apply([this, found = std::move(found)] { scenarios_ = found; });
                      });
  changed_ = true;
}

void ReplayController::open(const QString& path) {
  closeRun();  // two may not read files of this library while one looks whether it survives the other
  whole_.leave();
  resumeState_.reset();
  notChanged_.clear();
  task_.start(ui::TaskState::What::Reading, path,
              [this, file = path.toStdString()](BackgroundTask::Progress& progress) -> Result<BackgroundTask::Apply> {
                if (Status changed = changes_->make(); !changed) return changed.error();
                auto opened = openRecording(file, clock_, progress);
                if (!opened) return opened.error();
                return BackgroundTask::Apply([this, made = *opened] { takeOpened(made); });
              });
}

// Beside everything else: what is open can be used meanwhile.
void ReplayController::readWhole() {
  whole_.start(
      ui::TaskState::What::Reading, path_,
      [this, file = path_.toStdString()](BackgroundTask::Progress& progress) -> Result<BackgroundTask::Apply> {
        auto read = evaluate::summarizeRecording(file, {}, {}, [&progress](double part) {
          progress.part.store(part, std::memory_order_relaxed);
          return !progress.stopped();
        });
        if (!read) return read.error();
        if (!read->session) {
          const auto judged = judgeFile(file, {}, progress);
          if (!judged && progress.stopped()) return judged.error();
          if (judged) read->answer = sentencesOf(*judged);
        }
        return BackgroundTask::Apply([this, summary = std::make_shared<const SessionSummary>(std::move(read).value())] {
          summary_ = summary;
          summaryWhole_ = true;
        });
      });
}

void ReplayController::takeOpened(const std::shared_ptr<OpenedRecording>& opened) {
  closeRun();
  path_ = QString::fromStdString(opened->path);
  summary_ = opened->summary;
  summaryWhole_ = false;
  begin_ = opened->begin;
  markers_ = opened->markers;
  tracks_.clear();
  scores_.clear();
  notScored_.clear();
  hand_ = {};
  lobes_ = std::move(opened->lobes);
  info_ = sessionInfo(*opened->rig);
  const std::string& known = info_.setup.machine;
  const QString machine = known.empty() ? QFileInfo(path_).fileName() : viewText(known);
  wallMsAtStart_ = wallMsOf(*summary_);
  info_.wallMsAtStreamZero = wallMsAtStart_ - toNs(begin_) / 1'000'000;
  info_.setup.machine = QCoreApplication::translate("Session", "Replay: %1").arg(machine).toStdString();
  lead(opened);
  if (began) began(true);
  readWhole();
}

// From a place, paused or not: its first block is seen in any case.
void ReplayController::lead(const std::shared_ptr<OpenedRecording>& opened) {
  const ResumeState wish = resumeState_.value_or(ResumeState());
  resumeState_.reset();
  daq::ReplayControl& control = *opened->control;
  control.setPace(hand_.pace);
  if (hand_.looping) control.loopBetween(hand_.loopFrom, hand_.loopTo);
  if (wish.position.value > 0.0) {
    control.goTo(wish.position);
    control.tellPosition(wish.position);
  }
  if (wish.playing) {
    control.resume();
  } else {
    control.step();
  }
  run_ = std::make_unique<ReplayRun>(std::move(opened->rig), opened->control);
  run_->start();
  if (everywhere_) ++generation_;
}

void ReplayController::send(const OperatorInput& input) {
  if (run_ && input.action == OperatorAction::SetParameter) run_->send(input);
}

// Where the recording is now tells how deep its programme cuts now.
const Snapshot* ReplayController::replayed() {
  const Snapshot* seen = run_ ? run_->read() : nullptr;
  if (seen == nullptr) return seen;
  const Instant start = seen->time - toDuration(run_->control().position());
  info_.wallMsAtStreamZero = wallMsAtStart_ - toNs(start) / 1'000'000;
  takeOwnLimits(info_.limits, run_->rig());
  if (!lobes_) return seen;
  const auto before = lobes_->start();
  if (!before || std::abs(secondsBetween(*before, start).value) > kSamePlace_s) lobes_->setStart(start, seen->time);
  return seen;
}

ui::ReplayState ReplayController::replay() const {
  ui::ReplayState state = hand_;
  if (!summary_ || (!run_ && !resumeState_)) return state;
  state.open = true;
  state.length = summary_->length;
  if (resumeState_) {
    state.playing = resumeState_->playing;
    state.position = resumeState_->position;
    return state;
  }
  daq::ReplayControl& control = run_->control();
  state.finished = run_->finished();
  state.playing = !control.paused() && !state.finished;
  state.position = control.position();
  return state;
}

// At its end the source is closed; whoever plays or jumps then begins anew.
void ReplayController::reopenIfFinished() {
  if (run_ && run_->finished()) reopen(ui::TaskState::What::None, {});
}

void ReplayController::reopen(ui::TaskState::What what, const ResumeState& wish) {
  closeRun();
  resumeState_ = wish;
  whole_.start(
      what, path_,
      [this, file = path_.toStdString(),
       session = summary_->session](BackgroundTask::Progress&) -> Result<BackgroundTask::Apply> {
        const Status changed = changes_->make();
        auto opened = openAgain(file, session, clock_);
        if (!opened) return opened.error();
        return BackgroundTask::Apply([this, made = *opened, changed] { takeReopened(made, changed); });
      },
      [this](const Error&) { resumeState_.reset(); });
}

void ReplayController::takeReopened(const std::shared_ptr<OpenedRecording>& opened, const Status& changed) {
  notChanged_ = changed ? QString() : ui::sayError(changed.error());
  if (summary_->session) {
    takeMarkers(opened->markers);
    lister_.setMarkers(path_, static_cast<int>(markers_.size()));
  }
  lead(opened);
  if (began) began(false);
  if (!summaryWhole_) readWhole();
}

// Whoever holds a summary keeps it as it is; the next report is of another.
void ReplayController::takeMarkers(std::vector<Marker> markers) {
  markers_ = std::move(markers);
  auto marked = std::make_shared<SessionSummary>(*summary_);
  marked->markers = markers_;
  for (Marker& marker : marked->markers) {
    marker.begin = Instant(marker.begin - begin_);
    marker.end = Instant(marker.end - begin_);
  }
  summary_ = std::move(marked);
}

Status ReplayController::changeFile(FileChanges::Change change) {
  if (!run_ && !resumeState_) {
    return Error{message("marker"), message("nothing is open")};
  }
  changes_->add(std::move(change));
  const ui::ReplayState now = replay();
  reopen(ui::TaskState::What::Marking, {now.position, now.playing});
  return Done{};
}

void ReplayController::play() {
  reopenIfFinished();
  if (resumeState_) resumeState_->playing = true;
  if (run_) run_->control().resume();
}

void ReplayController::pause() {
  if (resumeState_) resumeState_->playing = false;
  if (run_) run_->control().pause();
}

void ReplayController::step(int blocks) {
  reopenIfFinished();
  pause();
  const CutSetup& setup = info_.setup;
  const Seconds block(setup.rate.value > 0.0 ? setup.blockFrames / setup.rate.value : 0.0);
  if (resumeState_)
    resumeState_->position = std::max(resumeState_->position + block * static_cast<double>(blocks), Seconds());
  if (!run_) return;
  daq::ReplayControl& control = run_->control();
  if (blocks < 0) {
    control.goTo(std::max(control.position() + block * (blocks - 1.0), Seconds()));
    blocks = 1;
  }
  control.step(blocks);
}

void ReplayController::setPace(double times) {
  hand_.pace = times;
  if (run_) run_->control().setPace(times);
}

void ReplayController::goTo(Seconds time) {
  reopenIfFinished();
  if (resumeState_) resumeState_->position = time;
  if (!run_) return;
  run_->control().goTo(time);
  if (run_->control().paused()) run_->control().step();
}

void ReplayController::loop(Seconds from, Seconds to) {
  if (!run_ && !resumeState_) return;
  hand_.looping = true;
  hand_.loopFrom = from;
  hand_.loopTo = to;
  if (run_) run_->control().loopBetween(from, to);
  goTo(from);
}

void ReplayController::endLoop() {
  hand_.looping = false;
  if (run_) run_->control().endLoop();
}

Status ReplayController::showEverywhere(bool on) {
  if (on && !run_ && !resumeState_) return Error{message("replay"), message("nothing is open")};
  if (on && mayShow) {
    if (Status may = mayShow(); !may) return may;
  }
  if (everywhere_ == on) return Done{};
  ++generation_;
  everywhere_ = on;
  changed_ = true;
  return Done{};
}

Status ReplayController::mark(Seconds from, Seconds to, const QString& label, const QString& note) {
  Marker marker;
  marker.begin = begin_ + toDuration(from);
  marker.end = begin_ + toDuration(to);
  marker.label = label.toStdString();
  marker.author = qEnvironmentVariable("USER").toStdString();
  marker.note = note.toStdString();
  return changeFile([file = path_.toStdString(), marker]() -> Status {
    const auto added = record::addMarker(file, marker);
    return added ? Status(Done{}) : Status(added.error());
  });
}

Status ReplayController::changeMark(std::uint64_t number, const QString& label, const QString& note) {
  const auto found =
      std::find_if(markers_.begin(), markers_.end(), [number](const Marker& m) { return m.number == number; });
  if (found == markers_.end()) return Error{message("marker"), message("is no longer there")};
  Marker marker = *found;
  marker.label = label.toStdString();
  marker.note = note.toStdString();
  return changeFile([file = path_.toStdString(), marker] { return record::changeMarker(file, marker); });
}

Status ReplayController::removeMark(std::uint64_t number) {
  return changeFile([file = path_.toStdString(), number] { return record::removeMarker(file, number); });
}

// What somebody asked for goes before what is read beside it.
ui::TaskState ReplayController::task() const {
  const ui::TaskState asked = task_.state(), read = whole_.state();
  ui::TaskState beside = read;
  if (!read.running && read.problem.isEmpty()) beside.problem = notChanged_;
  const bool tells = beside.running || !beside.problem.isEmpty();
  return asked.running || !asked.problem.isEmpty() || !tells ? asked : beside;
}

// What changes or opens the file is over in a moment, and is not left.
void ReplayController::cancel() {
  if (task_.state().running) {
    task_.leave();
  } else if (!resumeState_) {
    whole_.leave();
  }
}

void ReplayController::runDetectors(const QStringList& settings) {
  pause();
  std::vector<std::string> wanted;
  for (const QString& setting : settings) wanted.push_back(setting.toStdString());
  task_.start(
      ui::TaskState::What::Detectors, path_,
      [this, file = path_.toStdString(), wanted](BackgroundTask::Progress& progress) -> Result<BackgroundTask::Apply> {
        auto tracks = trackDetectors(file, wanted, progress);
        if (!tracks) return tracks.error();
        return BackgroundTask::Apply([this, tracks = std::move(tracks).value()] { tracks_ = tracks; });
      });
}

void ReplayController::score(bool wholeFolder) {
  pause();
  std::vector<std::string> files{path_.toStdString()};
  if (wholeFolder) {
    files.clear();
    for (const ui::SessionEntry& entry : entries()) files.push_back(entry.path.toStdString());
  }
  task_.start(ui::TaskState::What::Scoring, wholeFolder ? folder() : path_,
              [this, files](BackgroundTask::Progress& progress) -> Result<BackgroundTask::Apply> {
                auto scores = scoreFiles(files, progress);
                if (!scores) return scores.error();
                return BackgroundTask::Apply([this, scores = std::move(scores).value()] {
                  scores_ = scores.lines;
                  notScored_ = scores.notScored;
                });
              });
}

void ReplayController::exportSpan(Seconds from, Seconds to, const QString& file) {
  pause();
  task_.start(ui::TaskState::What::Exporting, file,
              [from, to, in = path_.toStdString(),
               out = file.toStdString()](BackgroundTask::Progress& progress) -> Result<BackgroundTask::Apply> {
                const Status done = record::convertRecording(in, out, {}, {from, to}, openStoppable(progress));
                if (!done) return done.error();
                return BackgroundTask::Apply{};
              });
}

}  // namespace stillcut::app
