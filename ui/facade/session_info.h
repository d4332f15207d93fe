// What a session tells the screens once, and the little that is not in the snapshot. Plain values, GUI thread.
#pragma once

#include <QString>
#include <QStringList>
#include <limits>
#include <optional>
#include <vector>

#include "core/model/active_state.h"
#include "core/model/cut_setup.h"
#include "core/model/snapshot.h"
#include "ui/base/units.h"
#include "ui/facade/learned_lobes.h"

namespace stillcut::ui {

// In the order of Snapshot::verdicts.
struct DetectorLabel {
  QString id;              // "energy-ratio"
  QString label;           // "Energy ratio"
  QStringList indicators;  // in the order of Verdict::indicators
};

// Limits drawn as marks on bars. Not a number: there is no such limit, no mark is drawn.
struct LimitMarks {
  double energyRatio = std::numeric_limits<double>::quiet_NaN();
  double coherence = std::numeric_limits<double>::quiet_NaN();
  double vibration = std::numeric_limits<double>::quiet_NaN();  // SI unit of the first channel
};

struct SessionInfo {
  CutSetup setup;
  QString linkLabel;  // "LinuxCNC", "simulated machine"
  bool simulatedMachine = false;
  bool machineWatchdog = false;  // the machine restores 100 % by itself when this program dies
  bool kept = false;             // a process of its own restores the operator's values when this program dies
  Metres feedPerTooth{};         // 0: unknown
  std::vector<DetectorLabel> detectors;
  LimitMarks limits;
  qint64 wallMsAtStreamZero = 0;  // wall clock (ms since 1970) at stream time 0

  qint64 wallMs(Instant t) const { return wallMsAtStreamZero + toNs(t) / 1'000'000; }
};

class RunHistory;
class SignalHistory;

struct RecorderView {
  enum class State { Off, Recording, Failed };
  State state = State::Off;
  Seconds length{};
  QString problem;       // a sentence, when failed
  bool waiting = false;  // recording begins with the next event: no file is open
};

struct LinkStatus {
  QString problem;          // a sentence, when there is one; link state and age come with the machine state
  QString ended;            // a sentence: why no more samples will come; empty while they may
  QString notice;           // a sentence from before this run: how the last one ended; empty: nothing
  bool notYetBack = false;  // overrides were released, and the machine has not shown it yet
};

// What a plot tells of itself.
enum class PlotState { Moves, Paused, Stale, Ended };

// Everything one display tick shows.
struct Picture {
  const SessionInfo* info = nullptr;
  const Snapshot* snapshot = nullptr;  // null: nothing came yet
  Seconds age{};                       // of the newest decision's last sample, on the screen's own clock (freshness.h)
  bool stale = false;
  bool paused = false;  // a replay that stands still because somebody wants it so: not stale
  qint64 nowMs = 0;     // the screen's own clock, for touches
  RecorderView recorder;
  LinkStatus link;
  UnitSystem units = UnitSystem::Metric;
  const RunHistory* history = nullptr;  // of this run; null only where nobody keeps one
  const SignalHistory* signal = nullptr;
  const ActiveSnapshot* table = nullptr;  // of the active work-holder; null: there is none, or nothing came yet
  // Vibration that the same cut would have at this moment without Stillcut, rms of the first channel [SI]; not a
  // number: nobody knows, as in any real cut.
  double vibrationWithout = std::numeric_limits<double>::quiet_NaN();
  bool mayRunAgain = false;             // over, and the same can be run once more
  QString notRunAgain;                  // a sentence: why the last touch of AGAIN came to nothing; empty: it did not
  bool replay = false;                  // the pages show a replay: there is nothing to answer or to judge in it
  std::optional<DepthMargin> margin{};  // of the stable cut that runs; none: nobody can tell

  // Nothing more will come, and it is known why: not stale.
  bool over() const { return !link.ended.isEmpty(); }
  PlotState plotState() const {
    return over() ? PlotState::Ended : stale ? PlotState::Stale : paused ? PlotState::Paused : PlotState::Moves;
  }
  // Samples still come: the decisions on them lag.
  bool lags() const {
    constexpr Seconds kLag{0.5};
    return stale && snapshot != nullptr && snapshot->health.blockAge > kLag;
  }
  const Verdict& verdict() const { return snapshot->verdicts[static_cast<std::size_t>(snapshot->inCharge)]; }
};

}  // namespace stillcut::ui
