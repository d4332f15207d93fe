// EvidenceLog: every judged cut of a run goes into the store of cuts (core/learn). What the run cuts (tool, depth,
// immersion) is the profile's; without depth and model there nothing can be learned. An error leaves the run alone.
// Thread: look() and finish() on the one that reads the run's snapshots; the disk is touched on a thread of its own.
// problem() on any.
#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/config/profile.h"
#include "core/learn/cut_collector.h"
#include "core/model/snapshot.h"
#include "core/rt/realtime_thread.h"
#include "core/rt/wakeup.h"

namespace stillcut::app {

// Where cuts are kept when nobody says otherwise: $XDG_DATA_HOME/stillcut/cuts.sqlite, else below ~/.local/share.
std::filesystem::path defaultCutStore();

// What every cut of a profile's run has in common. Empty: it does not say what is cut. Error: its model cannot be read.
Result<std::optional<learn::CutEvidence>> evidenceOf(const config::Profile& profile, const std::string& profilePath);

class EvidenceLog {
 public:
  // The folder of `store` is made when the first cut comes.
  EvidenceLog(learn::CutEvidence common, std::filesystem::path store);
  ~EvidenceLog() { finish(); }
  EvidenceLog(const EvidenceLog&) = delete;
  EvidenceLog& operator=(const EvidenceLog&) = delete;

  void look(const Snapshot& snapshot);
  // Ends the last cut and writes what waits.
  void finish();
  // Empty, or why the newest cuts could not be kept.
  Message problem() const;

 private:
  void keep(const std::optional<learn::CollectedCut>& cut);
  void run(const std::stop_token& stop);
  void writeWaiting();

  learn::CutEvidence common_;
  std::filesystem::path store_;
  learn::CutCollector collector_;
  mutable std::mutex lock_;
  std::vector<learn::CutEvidence> waiting_;
  Message problem_;
  rt::Wakeup wakeup_;
  std::optional<rt::RealtimeThread> thread_;  // last: joined before what it uses goes
};

}  // namespace stillcut::app
