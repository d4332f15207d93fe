#include "ui/models/history/run_history.h"

#include <algorithm>
#include <cmath>

#include "core/model/judged_cut.h"

namespace stillcut::ui {
namespace {

constexpr std::size_t kMostPoints = 4000;
constexpr Seconds kPointEvery{0.5};
constexpr double kAtSpeed = 0.01;
constexpr double kSpeedStep = 0.002;  // a fifth of a percent is less than a spindle wanders by itself

template <class Item>
void dropBefore(std::deque<Item>& items, Instant oldest) {
  while (!items.empty() && items.front().time < oldest) items.pop_front();
}

}  // namespace

void RunHistory::see(const Snapshot& snapshot) {
  if (snapshot.number == number_) return;
  if (snapshot.time < end_) clear();  // a new run, or a replay set back
  number_ = snapshot.number;
  end_ = snapshot.time;
  top_ = snapshot.spectrumTop;
  reader_.read(snapshot, [this](const SpectrumColumn& column) {
    if (!columns_.empty() && columns_.back().channel != column.channel) columns_.clear();
    columns_.push_back(column);
  });
  const bool afterGap = snapshot.health.gaps > gaps_;
  gaps_ = snapshot.health.gaps;
  tracks_.resize(static_cast<std::size_t>(std::max(snapshot.detectorCount, 0)));
  for (std::size_t d = 0; d < tracks_.size(); ++d) {
    const Verdict& v = snapshot.verdicts[d];
    tracks_[d].push_back({snapshot.time, v.state, hasState(v), static_cast<float>(v.severity.value),
                          static_cast<float>(v.indicators[0]), static_cast<float>(v.frequency.value), afterGap});
  }
  addPoint(snapshot);
  log_.see(snapshot);
  forget();
}

void RunHistory::addPoint(const Snapshot& snapshot) {
  const Verdict& verdict = snapshot.verdicts[static_cast<std::size_t>(snapshot.inCharge)];
  const MachineState& machine = snapshot.machine;
  if (!judges(verdict) || !(machine.actualSpeed.value > 0.0)) return;
  // A spindle that changes its speed proves nothing stable. Chatter is chatter at any speed.
  const double off = std::abs(machine.actualSpeed / machine.targetSpeed() - 1.0);
  const bool atSpeed = !(machine.targetSpeed().value > 0.0) || off < kAtSpeed;
  if (!verdict.alarming() && !atSpeed) return;
  const WorkingPoint now{snapshot.time, machine.actualSpeed, verdict.state, true};
  const bool same = !points_.empty() && points_.back().state == now.state &&
                    std::abs(points_.back().speed / now.speed - 1.0) < kSpeedStep &&
                    secondsBetween(points_.back().time, now.time) < kPointEvery;
  if (!same) points_.push_back(now);
  if (points_.size() > kMostPoints) points_.pop_front();
}

void RunHistory::forget() {
  const Instant oldest = end_ - toDuration(kKept);
  dropBefore(columns_, oldest);
  for (auto& track : tracks_) dropBefore(track, oldest);
}

void RunHistory::clear() {
  *this = RunHistory();
}

Instant RunHistory::begin() const {
  Instant first = end_;
  if (!columns_.empty()) first = std::min(first, columns_.front().time);
  for (const auto& track : tracks_) {
    if (!track.empty()) first = std::min(first, track.front().time);
  }
  return first;
}

const SpectrumColumn* RunHistory::columnAt(Instant t) const {
  if (columns_.empty()) return nullptr;
  const auto after = std::lower_bound(columns_.begin(), columns_.end(), t,
                                      [](const SpectrumColumn& c, Instant time) { return c.time < time; });
  if (after == columns_.begin()) return &columns_.front();
  if (after == columns_.end()) return &columns_.back();
  const auto before = after - 1;
  return t - before->time <= after->time - t ? &*before : &*after;
}

}  // namespace stillcut::ui
