// Stability lobes as the screens ask for them: the question, the diagram that comes back, and the service that computes
// it in the background. app/session implements the service; every call is made on the GUI thread and returns at once.
#pragma once

#include <QString>
#include <QStringList>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/time.h"
#include "core/base/units.h"
#include "core/model/verdict.h"

namespace stillcut::ui {

enum class LobeMethodChoice { ZerothOrder, SemiDiscretization, Exact };

struct LobeQuestion {
  LobeMethodChoice method = LobeMethodChoice::Exact;
  Rpm from{}, to{};
  int steps = 160;         // speeds looked at
  Metres maxAxialDepth{};  // deepest cut looked at
};

struct DepthSpan {
  Metres from{}, to{};
};

// The limit of one speed.
struct LobeLimit {
  Rpm speed{};
  Metres depth{};  // where `limited` is false: down to here nothing limits it
  bool limited = false;
  ChatterKind kind = ChatterKind::Unknown;
  Hertz frequency{};  // chatter frequency just above; 0: not known
  // Deeper stretches in which the cut is quiet again: islands. Only the exact method knows them.
  std::vector<DepthSpan> islands{};
};

struct LobeDiagram {
  std::uint32_t number = 0;  // counts answers
  LobeQuestion question;
  std::vector<LobeLimit> limits;  // by speed
  QStringList warnings;           // what the method or the linear cut leaves out
};

// The cut the diagram is of.
struct LobeFrame {
  QString name;             // of the model
  Rpm programmed{};         // 0: not known
  Rpm lowest{}, highest{};  // a range worth looking at; what the override reaches lies inside
  Rpm reachLow{}, reachHigh{};
  Metres depth{};          // deepest of the programme
  bool depthKnown = true;  // false: nobody has told it, and `depth` is only where "what if" begins
  Metres maxAxialDepth{};  // a depth worth looking down to
  Metres widthOfCut{};
  Metres feedPerTooth{};  // 0: not known
  int teeth = 0;
};

struct SpeedDepth {
  Rpm speed{};
  Metres depth{};
  bool operator==(const SpeedDepth&) const = default;
};

// A stretch of speeds that is stable at one depth.
struct Pocket {
  Rpm from{}, to{};
  Rpm best{};              // the middle of where it is deepest, as near to it as the override reaches
  Metres limit{};          // at `best`
  bool limited = true;     // false: the search ended there and found no limit
  double removal = 0.0;    // there, at the depth asked for [m^3/s]; 0: the feed is not known
  bool open = false;       // the diagram ends before it does
  bool reachable = false;  // some of it lies within what the override reaches
  Rpm quietest{};          // where the teeth alone shake the least; 0: not known, or no feed
  double vibration = 0.0;  // there, of the teeth alone: rms [m/s2]
  bool operator==(const Pocket&) const = default;
};

// One place of the diagram from near: what the command `advise` says there. Edges of pockets are found to a revolution
// per minute, depths to a percent.
struct LobeCloseUp {
  SpeedDepth at;
  std::optional<LobeLimit> limit;     // of its speed; none: the method cannot tell
  bool complete = false;              // every stretch of speeds has been looked through at this depth
  bool pocketsKnown = false;          // false: they are still looked for, or cannot be
  std::vector<Pocket> pockets;        // at its depth, by speed
  std::optional<SpeedDepth> deepest;  // the deepest stable cut, where no speed is stable at its depth
};

struct LobeProgress {
  enum class State { Idle, Running, Done, Cancelled, Failed };
  State state = State::Idle;
  double share = 0.0;  // done, 0..1
  QString problem;     // a sentence, when failed
};

struct LearnedLobes;

class LobeService {
 public:
  virtual ~LobeService() = default;

  virtual const LobeFrame& frame() const = 0;
  // Depth of cut then, where the programme tells it; else the frame's.
  virtual Metres axialDepthAt(Instant t) const = 0;
  // Ends what is being computed and begins this.
  virtual void ask(const LobeQuestion& question) = 0;
  virtual void cancel() = 0;
  virtual LobeProgress progress() const = 0;
  // The newest answer; null before the first. While the method still works it may become finer.
  virtual std::shared_ptr<const LobeDiagram> diagram() const = 0;
  // Begins to look closer at a place, by the exact method, in what the machine reaches first. The newest question
  // counts; the same one again does nothing.
  virtual void look(const SpeedDepth& /*at*/) {}
  // The newest answer, which may be of an older question: compare `at`. Null: none.
  virtual std::shared_ptr<const LobeCloseUp> closeUp() const { return nullptr; }
  // Begins to learn from the judged cuts of this tool on this machine, as they are kept now. Asked again while it
  // works: once more when it is done.
  virtual void learn() {}
  // The newest answer. Null: none yet, or nothing is learned of such a cut (a scenario, a replay, one entered by hand).
  virtual std::shared_ptr<const LearnedLobes> learned() const { return nullptr; }
};

}  // namespace stillcut::ui
