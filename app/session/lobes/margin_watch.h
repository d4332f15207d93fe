// MarginWatch: how much deeper the stable cut that runs could go, for the page Operate. Stretches of the signal go to
// the LearnedWorker; what it answers stands as long as that cut goes on unchanged. Thread: GUI.
#pragma once

#include <optional>

#include "app/session/lobes/learned_worker.h"
#include "core/learn/steady_stretch.h"
#include "core/model/cut_setup.h"
#include "core/model/snapshot.h"

namespace stillcut::app {

class MarginWatch {
 public:
  // `worker` outlives it.
  MarginWatch(LearnedWorker& worker, const CutSetup& setup, const learn::StretchParams& params = {});

  // Every block that comes, and after it the newest snapshot.
  void hear(const SampleBlock& block) { collector_.add(block); }
  void look(const Snapshot& snapshot);
  // None: it cannot be told of this cut, or not yet.
  std::optional<ui::DepthMargin> margin() const { return told_; }

 private:
  void takeAnswer();

  LearnedWorker& worker_;
  learn::StretchCollector collector_;
  bool anew_ = true;                    // nothing of this cut has been listened to
  std::optional<std::uint32_t> asked_;  // number of the answer that is waited for
  bool ofBefore_ = false;               // which is of a cut that has ended
  int silent_ = 0;                      // answers in a row that told nothing
  std::optional<ui::DepthMargin> told_;
};

}  // namespace stillcut::app
