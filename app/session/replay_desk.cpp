#include "app/session/replay_desk.h"

#include <QFileInfo>
#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/compose/recording_rig.h"
#include "app/compose/session_summary_builder.h"
#include "app/session/detector_runs.h"
#include "app/session/scenario_list.h"
#include "app/session/session_view.h"
#include "app/session/stoppable_reader.h"
#include "core/detect/registry.h"
#include "core/record/convert_recording.h"
#include "core/record/session_markers.h"
#include "core/record/session_overview.h"

namespace stillcut::app {

// Made on the task's thread, taken over on the GUI's.
struct ReplayDesk::Opened {
  std::string path;
  std::shared_ptr<const SessionSummary> summary;
  Instant begin{};
  std::vector<Marker> markers;
  std::shared_ptr<daq::ReplayControl> control = std::make_shared<daq::ReplayControl>();
  std::unique_ptr<Rig> rig;
};

namespace {

Result<std::unique_ptr<Rig>> replayRig(const std::string& path, const ReplayHand& hand, bool session) {
  auto built = session ? buildReplayRig(path, hand) : [&] {
    RecordingOptions options;
    options.methods.detectors = {std::string(detect::kDefaultDetector)};
    options.hand = hand;
    return buildRecordingRig(path, options);
  }();
  if (!built) return built.error();
  return std::move(built->rig);
}

// Of the first sample, on the recording's own clock; imported files begin at 0.
Result<Instant> beginOf(const std::string& path, bool session) {
  if (!session) return Instant{};
  const auto overview = record::SessionOverview::open(path);
  if (!overview) return overview.error();
  return (*overview)->begin();
}

}  // namespace

ReplayDesk::~ReplayDesk() {
  closeRun();
}

void ReplayDesk::closeRun() {
  if (run_) run_->stop();
  run_.reset();
}

bool ReplayDesk::poll() {
  const bool simulated = scenarioTask_.collect();
  const bool listed = lister_.collect() || simulated;
  const bool done = task_.collect();
  const bool read = whole_.collect();
  if (done && !run_ && summary_) {  // what was open stays where another could not be opened
    reopen();
    if (!summaryWhole_) readWhole();
  }
  return std::exchange(changed_, false) || listed || done || read;
}

void ReplayDesk::setFolder(const QString& folder) {
  lister_.list(folder);
  scenarioTask_.start(ui::TaskState::What::None, folder,
                      [this, folder](BackgroundTask::Progress& progress) -> Result<BackgroundTask::Apply> {
                        auto found = scenariosFor(folder, [&progress] { return !progress.stopped(); });
                        return BackgroundTask::Apply([this, found = std::move(found)] { scenarios_ = found; });
                      });
  changed_ = true;
}

void ReplayDesk::open(const QString& path) {
  closeRun();  // two may not read files of this library while one looks whether it survives the other
  whole_.leave();
  task_.start(ui::TaskState::What::Reading, path,
              [this, file = path.toStdString()](BackgroundTask::Progress& progress) -> Result<BackgroundTask::Apply> {
                const auto opened = std::make_shared<Opened>();
                opened->path = file;
                auto summary = glimpseOf(file);
                if (!summary) return summary.error();
                opened->summary = std::make_shared<const SessionSummary>(std::move(summary).value());
                if (opened->summary->session) {
                  auto markers = record::readMarkers(file);
                  if (!markers) return markers.error();
                  opened->markers = std::move(markers).value();
                }
                auto begin = beginOf(file, opened->summary->session);
                if (!begin) return begin.error();
                if (progress.stopped()) return Error{file, "stopped", ""};
                opened->begin = *begin;
                opened->control->pause();
                auto rig = replayRig(file, {opened->control, &clock_}, opened->summary->session);
                if (!rig) return rig.error();
                opened->rig = std::move(rig).value();
                return BackgroundTask::Apply([this, opened] { takeOpened(opened); });
              });
}

// Beside everything else: what is open can be used meanwhile.
void ReplayDesk::readWhole() {
  whole_.start(
      ui::TaskState::What::Reading, path_,
      [this, file = path_.toStdString()](BackgroundTask::Progress& progress) -> Result<BackgroundTask::Apply> {
        auto read = summarizeRecording(file, {}, {}, [&progress](double part) {
          progress.part.store(part, std::memory_order_relaxed);
          return !progress.stopped();
        });
        if (!read) return read.error();
        return BackgroundTask::Apply([this, summary = std::make_shared<const SessionSummary>(std::move(read).value())] {
          summary_ = summary;
          summaryWhole_ = true;
        });
      });
}

void ReplayDesk::takeOpened(const std::shared_ptr<Opened>& opened) {
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
  opened->control->setPace(hand_.pace);
  opened->control->step();  // the first block: there is something to see
  info_ = sessionInfo(*opened->rig);
  info_.setup.machine = "Replay: " + info_.setup.machine;
  info_.sourceLabel = QStringLiteral("replay of %1").arg(QFileInfo(path_).fileName());
  run_ = std::make_unique<ReplayRun>(std::move(opened->rig), opened->control);
  run_->start();
  readWhole();
  if (everywhere_) ++generation_;
}

void ReplayDesk::send(const OperatorInput& input) {
  if (run_ && input.action == OperatorAction::SetParameter) run_->send(input);
}

ui::ReplayState ReplayDesk::replay() const {
  ui::ReplayState state = hand_;
  if (!run_ || !summary_) return state;
  daq::ReplayControl& control = run_->control();
  state.open = true;
  state.finished = run_->finished();
  state.playing = !control.paused() && !state.finished;
  state.position = control.position();
  state.length = summary_->length;
  return state;
}

// At its end the source is closed; whoever plays or jumps then begins anew.
void ReplayDesk::reopenIfFinished() {
  if (run_ && run_->finished()) reopen();
}

// Paused at the beginning.
bool ReplayDesk::reopen() {
  closeRun();
  const auto control = std::make_shared<daq::ReplayControl>();
  control->setPace(hand_.pace);
  control->pause();
  auto rig = replayRig(path_.toStdString(), {control, &clock_}, summary_->session);
  if (!rig) return false;
  if (hand_.looping) control->loopBetween(hand_.loopFrom, hand_.loopTo);
  run_ = std::make_unique<ReplayRun>(std::move(rig).value(), control);
  run_->start();
  if (everywhere_) ++generation_;
  return true;
}

// Whoever holds a summary keeps it as it is; the next report is of another.
void ReplayDesk::takeMarkers(std::vector<Marker> markers) {
  markers_ = std::move(markers);
  auto marked = std::make_shared<SessionSummary>(*summary_);
  marked->markers = markers_;
  for (Marker& marker : marked->markers) {
    marker.begin = Instant(marker.begin - begin_);
    marker.end = Instant(marker.end - begin_);
  }
  summary_ = std::move(marked);
}

Status ReplayDesk::changeFile(const std::function<Status(const std::string&)>& change) {
  const ui::ReplayState before = replay();
  closeRun();
  const bool reading = whole_.state().running;
  whole_.cancel();
  Status done = change(path_.toStdString());
  auto markers = record::readMarkers(path_.toStdString());
  if (markers) takeMarkers(std::move(markers).value());
  lister_.setMarkers(path_, static_cast<int>(markers_.size()));
  changed_ = true;
  if (reopen() && before.open) {
    goTo(before.position);
    if (before.playing) play();
  }
  if (reading) readWhole();
  return done;
}

void ReplayDesk::play() {
  reopenIfFinished();
  if (run_) run_->control().resume();
}

void ReplayDesk::pause() {
  if (run_) run_->control().pause();
}

void ReplayDesk::step(int blocks) {
  if (!run_) return;
  reopenIfFinished();
  daq::ReplayControl& control = run_->control();
  control.pause();
  if (blocks < 0) {
    const CutSetup& setup = run_->rig().setup();
    const double block = setup.blockFrames / setup.rate.value;
    control.goTo(Seconds(std::max(control.position().value + (blocks - 1.0) * block, 0.0)));
    blocks = 1;
  }
  control.step(blocks);
}

void ReplayDesk::setPace(double times) {
  hand_.pace = times;
  if (run_) run_->control().setPace(times);
}

void ReplayDesk::goTo(Seconds time) {
  if (!run_) return;
  reopenIfFinished();
  run_->control().goTo(time);
  if (run_->control().paused()) run_->control().step();
}

void ReplayDesk::loop(Seconds from, Seconds to) {
  if (!run_) return;
  reopenIfFinished();
  hand_.looping = true;
  hand_.loopFrom = from;
  hand_.loopTo = to;
  run_->control().loopBetween(from, to);
  goTo(from);
}

void ReplayDesk::endLoop() {
  hand_.looping = false;
  if (run_) run_->control().endLoop();
}

Status ReplayDesk::showEverywhere(bool on) {
  if (on && !run_) return Error{"replay", "nothing is open", ""};
  if (on && mayShow) {
    if (Status may = mayShow(); !may) return may;
  }
  if (everywhere_ != on) ++generation_;
  everywhere_ = on;
  return Done{};
}

Status ReplayDesk::mark(Seconds from, Seconds to, const QString& label, const QString& note) {
  Marker marker;
  marker.begin = begin_ + toDuration(from);
  marker.end = begin_ + toDuration(to);
  marker.label = label.toStdString();
  marker.author = qEnvironmentVariable("USER").toStdString();
  marker.note = note.toStdString();
  return changeFile([&marker](const std::string& file) -> Status {
    const auto added = record::addMarker(file, marker);
    return added ? Status(Done{}) : Status(added.error());
  });
}

Status ReplayDesk::changeMark(std::uint64_t number, const QString& label, const QString& note) {
  const auto found =
      std::find_if(markers_.begin(), markers_.end(), [number](const Marker& m) { return m.number == number; });
  if (found == markers_.end()) return Error{"marker", "is no longer there", ""};
  Marker marker = *found;
  marker.label = label.toStdString();
  marker.note = note.toStdString();
  return changeFile([&marker](const std::string& file) { return record::changeMarker(file, marker); });
}

Status ReplayDesk::removeMark(std::uint64_t number) {
  return changeFile([number](const std::string& file) { return record::removeMarker(file, number); });
}

// What somebody asked for goes before what is read beside it.
ui::TaskState ReplayDesk::task() const {
  const ui::TaskState asked = task_.state(), read = whole_.state();
  const bool tellsRead = read.running || !read.problem.isEmpty();
  return asked.running || !asked.problem.isEmpty() || !tellsRead ? asked : read;
}

void ReplayDesk::cancel() {
  (task_.state().running ? task_ : whole_).leave();
}

void ReplayDesk::runDetectors(const QStringList& settings) {
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

void ReplayDesk::score(bool wholeFolder) {
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

void ReplayDesk::exportSpan(Seconds from, Seconds to, const QString& file) {
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
