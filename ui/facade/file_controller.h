// FileController: one recording as a whole, and what is said about it: its samples and spectra, what was recorded with
// it, and the answer of the detectors for the teeth and the speed that somebody has told. A second recording may lie
// beside it, with teeth, speed and an answer of its own. Whatever runs at the machine is not touched by it. app/session
// implements it; what takes time runs on threads of its own and is taken over by poll(). GUI thread; every function
// returns at once.
#pragma once

#include <QString>
#include <QStringList>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/model/recording_answer.h"
#include "core/model/recording_spectra.h"
#include "core/model/session_summary.h"
#include "core/model/verdict.h"
#include "core/model/wave_pyramid.h"
#include "ui/facade/session_controller.h"

namespace stillcut::ui {

struct FileQuestion {
  int teeth = 0;  // 0: not told
  Rpm speed{};    // 0: not told
  bool operator==(const FileQuestion&) const = default;
};

// What somebody tells of a recording that does not say when its samples were taken.
struct FileTiming {
  Hertz rate{};                 // 0: not told
  double secondsPerTime = 0.0;  // of its times in numbers; 0: not told
  bool operator==(const FileTiming&) const = default;
};
// Which of these a recording lacks that was refused for it.
enum class FileLack { None, Rate, TimeUnit };

// Times count from the first sample of the recording.
struct FileState {
  Seconds begin{}, end{};
  CutState state = CutState::AirCutting;
  bool judged = false;  // else the state says nothing
};
// What a detector looks at, in even steps from the first sample on.
struct FileCurve {
  QString name;                                             // of the indicator, as in --series; empty: not known
  Seconds step{};                                           // that each value covers
  std::vector<float> highest;                               // in it; not a number: not judged
  double limit = std::numeric_limits<double>::quiet_NaN();  // of full chatter; not a number: there is none
};
struct FileTrack {
  QString detector;  // its label
  std::vector<FileState> states;
  FileCurve curve = {};
};

struct FileChannel {
  QString name, unit;  // SI
  WavePyramid wave;    // SI
};

struct FileContents {
  QString path, kind;
  Hertz rate{};
  Seconds length{};
  qint64 wallMs = 0;  // of the first sample, ms since 1970; 0: the file does not say
  QString tool, job;  // where the file says them
  FileQuestion told;  // by the file itself
  QStringList notes;  // what was damaged or missing in it, columns that are no channel
  std::vector<FileChannel> channels;
  std::optional<FileTrack> recorded;  // what the run that recorded it has said
};

// A number found in the signal, with what else it may be.
struct FileFinding {
  double value = 0.0;  // 0: not found
  double doubt = 0.0;  // one standard deviation; 0: a whole number, or not known
  std::vector<double> rivals;
};

struct FileAnswer {
  FileQuestion question;
  Finding finding = Finding::NotJudged;
  QString headline, advice;       // sentences; advice may be empty
  QStringList details;            // how long was judged, up to which frequency it hears, channels
  int teeth = 0;                  // that it was judged with; 0: not known
  Hertz chatter{}, spindle{};     // 0: none, not known
  std::vector<FileTrack> tracks;  // of each detector; the first is the one the answer is of
  Hertz judgedTo{};               // chatter above this is not found; 0: not known
};

// Of the speed that fits the signal best, and of the teeth at the speed that was told.
struct FileFindings {
  FileFinding speed_rpm, teeth;
};

class FileController {
 public:
  enum Place { Main, Beside };
  virtual ~FileController() = default;

  // Takes over what has been finished. True: something below has changed. Every display tick.
  virtual bool poll() = 0;

  virtual void open(Place place, const QString& path) = 0;
  // The one opened last there is read again with it, until another is opened.
  virtual void tellTiming(Place place, const FileTiming& timing) = 0;
  virtual FileLack lacking(Place place) const = 0;  // while it is refused
  virtual void close(Place place) = 0;
  virtual QString path(Place place) const = 0;  // that was opened last, whether it could be read or not
  // Null: nothing is open, or it is still being read.
  virtual std::shared_ptr<const FileContents> contents(Place place) const = 0;
  virtual TaskState reading(Place place) const = 0;

  // What was asked before of the same one is given up.
  virtual void ask(Place place, const FileQuestion& question) = 0;
  virtual FileQuestion asked(Place place) const = 0;
  // Null: none yet; of another question until it comes. Of the one beside by the first detector alone.
  virtual std::shared_ptr<const FileAnswer> answer(Place place) const = 0;
  virtual TaskState answering(Place place) const = 0;
  virtual bool comparing() const = 0;  // the other detectors are still at work on the main one
  virtual FileFindings findings() const = 0;

  // Everything a report of the main one needs, its answer among it: asked for, and there once; null until then.
  virtual void askSummary() = 0;
  virtual std::shared_ptr<const SessionSummary> summary() const = 0;
  virtual TaskState summarizing() const = 0;

  virtual void askSpectra(Place place, const SpectraRequest& request) = 0;
  virtual std::shared_ptr<const Spectra> spectra(Place place) const = 0;  // the newest that is ready

  // Sound of a channel of the main one. An error says why nothing is heard.
  virtual Status play(int channel, Seconds from, Seconds to) = 0;
  virtual void stopSound() = 0;
  virtual std::optional<Seconds> playing() const = 0;  // where it is; empty: nothing is played
  virtual QString soundProblem() const = 0;            // why the last one ended before its end
};

}  // namespace stillcut::ui
