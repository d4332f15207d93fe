// SessionController: what the Sessions page needs: the recordings there are, one of them opened and replayed by hand,
// what people have marked in it, every detector on it side by side, its score, and exports. app/session implements it;
// what takes time runs on a thread of its own and is taken over by poll(). GUI thread; every function returns at once.
#pragma once

#include <QString>
#include <QStringList>
#include <memory>
#include <vector>

#include "core/base/result.h"
#include "core/model/marker.h"
#include "core/model/session_summary.h"
#include "core/model/snapshot.h"

namespace stillcut::ui {

struct SessionEntry {
  QString path, job, tool;
  qint64 wallMs = 0;  // when it was last written, ms since 1970
  qint64 bytes = 0;
  // What is inside is looked at when somebody asks (lookInside); No: an imported recording, one still being written, or
  // one that cannot be looked into.
  enum class Inside { NotYet, Known, No };
  Inside inside = Inside::No;
  Seconds length{};
  int markers = 0;
  int alarms = 0;
  Seconds alarmed{};     // in onset or chatter
  qint64 startedMs = 0;  // when it began, ms since 1970; 0: not known
  bool session = false;  // one of ours; where it cannot be looked into it was not closed
  bool operator==(const SessionEntry&) const = default;

  qint64 beganMs() const { return startedMs > 0 ? startedMs : wallMs; }
};

// Times count from the first sample of the recording.
struct AlarmSpan {
  Seconds begin{}, end{};
  bool operator==(const AlarmSpan&) const = default;
};
struct DetectorTrack {
  QString detector;                     // its label
  std::vector<AlarmSpan> before;        // with the recording's own parameters
  std::vector<AlarmSpan> after;         // with the settings asked for
  bool compared = false;                // `after` was asked for
  int falseBefore = 0, falseAfter = 0;  // alarms that reach into what is marked quiet
};
struct ScoreLine {
  QString detector;
  int spans = 0, found = 0, alarms = 0, falseAlarms = 0;
  double falsePerHour = 0.0, delay_s = 0.0;  // not a number: nothing marked quiet, nothing found
};

struct ReplayState {
  bool open = false, playing = false, looping = false, finished = false;
  double pace = 1.0;  // times real time; 0: as fast as possible
  Seconds position{}, length{}, loopFrom{}, loopTo{};
};

// The one thing that is being worked on.
struct TaskState {
  enum class What { None, Reading, Marking, Detectors, Scoring, Exporting };
  What what = What::None;  // the last one when nothing runs
  bool running = false;
  double part = 0.0;  // 0 .. 1
  QString file;       // that is being read or written
  QString problem;    // of the last one; empty: it went well
};

class SessionController {
 public:
  virtual ~SessionController() = default;

  // Takes over what has been finished. True: something below has changed. Every display tick.
  virtual bool poll() = 0;

  virtual QString folder() const = 0;
  virtual void setFolder(const QString& folder) = 0;  // lists it anew
  virtual const std::vector<SessionEntry>& entries() const = 0;
  // These rows are on the screen: what is inside their files is looked at, and what was asked for before and not yet
  // looked at is left. No other file is opened for the list.
  virtual void lookInside(const QStringList& paths) = 0;
  // Simulated cuts that can be opened as a recording can: the program's own, and those of the folder.
  virtual const std::vector<SessionEntry>& scenarios() const = 0;

  // Opens it paused at its beginning, with what can be told at once; the whole of it is read meanwhile.
  virtual void open(const QString& path) = 0;
  virtual QString openedPath() const = 0;
  virtual std::shared_ptr<const SessionSummary> summary() const = 0;  // null: nothing is open
  virtual bool summaryWhole() const { return true; }  // false: alarms, spectrogram and sensors are not known yet

  virtual ReplayState replay() const = 0;
  virtual const Snapshot* replayed() = 0;  // its newest picture; null: none
  virtual void play() = 0;
  virtual void pause() = 0;
  virtual void step(int blocks) = 0;
  virtual void setPace(double times) = 0;
  virtual void goTo(Seconds time) = 0;
  virtual void loop(Seconds from, Seconds to) = 0;
  virtual void endLoop() = 0;
  // The replay in the place of the cut, on every page. An error says why it may not be.
  virtual Status showEverywhere(bool on) = 0;
  virtual bool shownEverywhere() const = 0;

  virtual const std::vector<Marker>& markers() const = 0;
  virtual Seconds markerTime(const Marker& marker) const = 0;  // from the first sample
  // What cannot be is said at once; what can is done beside the screen, and task() tells how it went.
  virtual Status mark(Seconds from, Seconds to, const QString& label, const QString& note) = 0;
  virtual Status changeMark(std::uint64_t number, const QString& label, const QString& note) = 0;
  virtual Status removeMark(std::uint64_t number) = 0;

  // KEY=VALUE of what was changed on the Tune page.
  virtual QStringList tunedSettings() const = 0;
  virtual void runDetectors(const QStringList& settings) = 0;
  virtual const std::vector<DetectorTrack>& tracks() const = 0;
  // Of the opened session, or of the whole folder.
  virtual void score(bool wholeFolder) = 0;
  virtual const std::vector<ScoreLine>& scores() const = 0;
  virtual const QStringList& notScored() const = 0;  // files of the folder that could not be, with the reason
  virtual void exportSpan(Seconds from, Seconds to, const QString& file) = 0;
  virtual TaskState task() const = 0;
  virtual void cancel() = 0;
};

}  // namespace stillcut::ui
