// How old the picture is: time on the screen's own clock since the snapshot's number last changed, and besides how far
// behind its samples the decision was. The stream's clock cannot tell the first, because it stands still exactly when
// the stream does; new snapshots cannot tell the second, because a worker that lags goes on making them.
#pragma once

#include <QtGlobal>

#include "core/model/snapshot.h"

namespace stillcut::ui {

// A live snapshot comes with every block (10 to 50 ms); half a second without one is no longer live.
inline constexpr qint64 kStaleAfterMs = 500;

class Freshness {
 public:
  // Call at every display tick with what was pulled (may be null). `lagCounts`: not in a replay, which is of the past.
  void see(const Snapshot* snapshot, qint64 nowMs, bool lagCounts = true) {
    const quint64 number = snapshot ? snapshot->number : 0;
    if (first_ || number != number_) {
      changedMs_ = nowMs;
      number_ = number;
      first_ = false;
    }
    const bool lags = lagCounts && snapshot != nullptr && snapshot->running;
    ageMs_ = nowMs - changedMs_ + (lags ? static_cast<qint64>(1e3 * snapshot->health.blockAge.value) : 0);
  }
  Seconds age() const { return Seconds(static_cast<double>(ageMs_) * 1e-3); }
  bool stale() const { return ageMs_ > kStaleAfterMs; }

 private:
  bool first_ = true;
  quint64 number_ = 0;
  qint64 changedMs_ = 0;
  qint64 ageMs_ = 0;
};

}  // namespace stillcut::ui
