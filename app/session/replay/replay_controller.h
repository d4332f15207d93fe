// ReplayController: the recordings of a folder, one of them opened, replayed by hand, marked, held against detectors
// and exported. Nothing of it can reach a machine: a replay's rig has none. Thread: GUI; work that takes time runs
// apart.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/compose/replay_run.h"
#include "app/session/background_task.h"
#include "app/session/lobe_worker.h"
#include "app/session/replay/file_changes.h"
#include "app/session/replay/opened_recording.h"
#include "app/session/replay/session_lister.h"
#include "app/session/session_view.h"
#include "ui/facade/session_controller.h"
#include "ui/facade/session_info.h"

namespace stillcut::app {

class ReplayController final : public ui::SessionController {
 public:
  ReplayController() = default;
  ~ReplayController() override;

  // Of the opened recording, for the place of the cut on every page.
  const ui::SessionInfo& info() const { return info_; }
  const Rig* rig() const { return run_ ? &run_->rig() : nullptr; }
  pipeline::SignalTap* signal() { return run_ ? &run_->signal() : nullptr; }
  // Of the cut that the opened recording is of. Null: it does not say with which modes.
  LobeWorker* lobes() const { return lobes_.get(); }
  void send(const OperatorInput& input);
  void noteTuned(const config::ParamDecl& decl, double value) { takeLimit(info_.limits, decl, value); }
  void showChannel(int channel) {
    if (run_) run_->showChannel(channel);
  }
  // The session says whether its cut may leave the screen, and what was tuned.
  std::function<Status()> mayShow;
  std::function<QStringList()> tuned;
  // The rig of another recording, or of the same one begun anew.
  std::function<void(bool another)> began;
  // Of the folder's recordings, newest first.
  std::vector<std::string> newest(int most) const;
  // Counts what was opened and shown.
  std::uint32_t generation() const { return generation_; }

  bool poll() override;
  QString folder() const override { return lister_.folder(); }
  void setFolder(const QString& folder) override;
  const std::vector<ui::SessionEntry>& entries() const override { return lister_.entries(); }
  void lookInside(const QStringList& paths) override { lister_.lookInside(paths); }
  const std::vector<ui::SessionEntry>& scenarios() const override { return scenarios_; }
  void open(const QString& path) override;
  QString openedPath() const override { return path_; }
  std::shared_ptr<const SessionSummary> summary() const override { return summary_; }
  bool summaryWhole() const override { return summaryWhole_; }

  ui::ReplayState replay() const override;
  const Snapshot* replayed() override;
  void play() override;
  void pause() override;
  void step(int blocks) override;
  void setPace(double times) override;
  void goTo(Seconds time) override;
  void loop(Seconds from, Seconds to) override;
  void endLoop() override;
  Status showEverywhere(bool on) override;
  bool shownEverywhere() const override { return everywhere_; }

  const std::vector<Marker>& markers() const override { return markers_; }
  Seconds markerTime(const Marker& marker) const override { return secondsBetween(begin_, marker.begin); }
  Status mark(Seconds from, Seconds to, const QString& label, const QString& note) override;
  Status changeMark(std::uint64_t number, const QString& label, const QString& note) override;
  Status removeMark(std::uint64_t number) override;

  QStringList tunedSettings() const override { return tuned ? tuned() : QStringList(); }
  void runDetectors(const QStringList& settings) override;
  const std::vector<ui::DetectorTrack>& tracks() const override { return tracks_; }
  void score(bool wholeFolder) override;
  const std::vector<ui::ScoreLine>& scores() const override { return scores_; }
  const QStringList& notScored() const override { return notScored_; }
  void exportSpan(Seconds from, Seconds to, const QString& file) override;
  ui::TaskState task() const override;
  void cancel() override;

 private:
  // What becomes of the replay while it is being opened anew.
  struct ResumeState {
    Seconds position{};
    bool playing = false;
  };
  void readWhole();
  void takeOpened(const std::shared_ptr<OpenedRecording>& opened);
  void lead(const std::shared_ptr<OpenedRecording>& opened);
  void closeRun();
  void reopenIfFinished();
  // The file is the replay's while it is open: what waits to be changed gets it alone, then the replay goes on as
  // `wish_` has it. On a thread of its own: the disk may be slow.
  void reopen(ui::TaskState::What what, const ResumeState& wish);
  void takeReopened(const std::shared_ptr<OpenedRecording>& opened, const Status& changed);
  Status changeFile(FileChanges::Change change);
  void takeMarkers(std::vector<Marker> markers);

  QString path_;
  std::shared_ptr<const SessionSummary> summary_;
  bool summaryWhole_ = false;
  Instant begin_{};  // of the first sample, on the recording's clock
  std::vector<Marker> markers_;
  std::vector<ui::DetectorTrack> tracks_;
  std::vector<ui::ScoreLine> scores_;
  QStringList notScored_;
  SteadyClock clock_;  // of the replay's pace
  std::shared_ptr<FileChanges> changes_ = std::make_shared<FileChanges>();
  QString notChanged_;                      // why the last change of the file came to nothing
  std::optional<ResumeState> resumeState_;  // while it is being opened anew
  std::unique_ptr<ReplayRun> run_;
  std::unique_ptr<LobeWorker> lobes_;
  ui::SessionInfo info_;
  qint64 wallMsAtStart_ = 0;  // clock on the wall at the first sample, ms since 1970
  ui::ReplayState hand_;      // pace, loop
  bool everywhere_ = false;
  bool changed_ = true;
  std::uint32_t generation_ = 0;
  SessionLister lister_;
  std::vector<ui::SessionEntry> scenarios_;
  BackgroundTask scenarioTask_;
  BackgroundTask task_;
  BackgroundTask whole_;  // reads the whole of what is open, changes it, opens it anew
};

}  // namespace stillcut::app
