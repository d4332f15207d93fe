// Stability lobes as the screens ask for them: the question, the diagram that comes back, and the service that computes
// it in the background. app/session implements the service; every call is made on the GUI thread and returns at once.
#pragma once

#include <QString>
#include <QStringList>
#include <cstdint>
#include <memory>
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

struct LobeProgress {
  enum class State { Idle, Running, Done, Cancelled, Failed };
  State state = State::Idle;
  double share = 0.0;  // done, 0..1
  QString problem;     // a sentence, when failed
};

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
  // The newest complete answer; null before the first.
  virtual std::shared_ptr<const LobeDiagram> diagram() const = 0;
};

}  // namespace stillcut::ui
