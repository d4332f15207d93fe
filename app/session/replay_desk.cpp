#include "app/session/replay_desk.h"

#include <QFileInfo>
#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/compose/recording_rig.h"
#include "app/compose/recording_score.h"
#include "app/compose/session_summary_builder.h"
#include "app/session/session_view.h"
#include "core/detect/registry.h"
#include "core/record/convert_recording.h"
#include "core/record/open_recording.h"
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

std::vector<std::string> allDetectors() {
  std::vector<std::string> all;
  for (const auto& row : detect::detectorTable()) all.emplace_back(row.id);
  return all;
}

QString labelOf(const std::string& id) {
  for (const auto& row : detect::detectorTable()) {
    if (row.id == id) return viewText(row.make()->describe().label);
  }
  return QString::fromStdString(id);
}

std::vector<ui::AlarmSpan> spansOf(const std::vector<Alarm>& alarms) {
  std::vector<ui::AlarmSpan> spans;
  for (const Alarm& alarm : alarms) spans.push_back({alarm.begin, alarm.end});
  return spans;
}

ui::ScoreLine lineOf(const std::string& detector, const AlarmScore& s) {
  return {labelOf(detector), s.spans, s.found, s.alarms, s.falseAlarms, s.falsePerHour(), s.delayQuantile(0.5)};
}

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
  const bool listed = lister_.collect();
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
  changed_ = true;
}

void ReplayDesk::open(const QString& path) {
  closeRun();  // two may not read files of this library while one looks whether it survives the other
  whole_.cancel();
  task_.start(ui::TaskState::What::Reading, path,
              [this, file = path.toStdString()](BackgroundTask::Progress&) -> Result<BackgroundTask::Apply> {
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
          return !progress.stop.load(std::memory_order_relaxed);
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

Status ReplayDesk::changeFile(const std::function<Status(const std::string&)>& change) {
  const ui::ReplayState before = replay();
  closeRun();
  const bool reading = whole_.state().running;
  whole_.cancel();
  const Status done = change(path_.toStdString());
  auto markers = record::readMarkers(path_.toStdString());
  if (markers) markers_ = std::move(markers).value();
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
    if (const Status may = mayShow(); !may) return may;
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
  (task_.state().running ? task_ : whole_).cancel();
}

void ReplayDesk::runDetectors(const QStringList& settings) {
  pause();
  std::vector<std::string> wanted;
  for (const QString& setting : settings) wanted.push_back(setting.toStdString());
  task_.start(
      ui::TaskState::What::Detectors, path_,
      [this, file = path_.toStdString(), wanted](BackgroundTask::Progress& progress) -> Result<BackgroundTask::Apply> {
        const auto truth = truthOf(file);
        const RecordedTruth known = truth && truth.value() ? *truth.value() : RecordedTruth{};
        ScoreRequest request;
        request.detectors = allDetectors();
        const double passes = wanted.empty() ? 1.0 : 2.0;
        double pass = 0.0;
        request.goOn = [&](double part) {
          progress.part.store((pass + part) / passes, std::memory_order_relaxed);
          return !progress.stop.load(std::memory_order_relaxed);
        };
        const auto before = scoreRecording(file, known, request);
        if (!before) return before.error();
        pass = 1.0;
        request.settings = wanted;
        const auto after = wanted.empty() ? before : scoreRecording(file, known, request);
        if (!after) return after.error();
        std::vector<ui::DetectorTrack> tracks;
        for (const std::string& id : request.detectors) {
          tracks.push_back({labelOf(id), spansOf(before->alarms.at(id)), spansOf(after->alarms.at(id)), !wanted.empty(),
                            before->byDetector.at(id).falseAlarms, after->byDetector.at(id).falseAlarms});
        }
        return BackgroundTask::Apply([this, tracks = std::move(tracks)] { tracks_ = tracks; });
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
                ScoreRequest request;
                request.detectors = allDetectors();
                std::map<std::string, AlarmScore> sums;
                double done = 0.0;
                request.goOn = [&](double part) {
                  progress.part.store((done + part) / static_cast<double>(files.size()), std::memory_order_relaxed);
                  return !progress.stop.load(std::memory_order_relaxed);
                };
                for (const std::string& file : files) {
                  const auto truth = truthOf(file);
                  if (!truth) return truth.error();
                  if (truth.value()) {
                    const auto scored = scoreRecording(file, *truth.value(), request);
                    if (!scored) return scored.error();
                    for (const auto& [id, one] : scored->byDetector) sums[id].add(one);
                  }
                  done += 1.0;
                }
                if (sums.empty()) return Error{"score", "nothing is marked here", "mark true and false alarms first"};
                std::vector<ui::ScoreLine> lines;
                for (const std::string& id : request.detectors) lines.push_back(lineOf(id, sums[id]));
                return BackgroundTask::Apply([this, lines = std::move(lines)] { scores_ = lines; });
              });
}

void ReplayDesk::exportSpan(Seconds from, Seconds to, const QString& file) {
  pause();
  task_.start(ui::TaskState::What::Exporting, file,
              [from, to, in = path_.toStdString(),
               out = file.toStdString()](BackgroundTask::Progress&) -> Result<BackgroundTask::Apply> {
                const Status done = record::convertRecording(in, out, {}, {from, to});
                if (!done) return done.error();
                return BackgroundTask::Apply{};
              });
}

}  // namespace stillcut::app
