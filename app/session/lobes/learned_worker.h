// LearnedWorker: what the judged cuts of a profile's tool on its machine say of the stability, in the background: for
// the Lobes page, and for Operate how far the cut that runs is from chatter. Read from the store of cuts (core/learn),
// the tool's modes as the start.
// Thread: GUI; the work runs on a thread of its own that yields to everything else, a second for 200 cuts.
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "core/learn/cut_evidence.h"
#include "core/learn/lobe_posterior.h"
#include "core/learn/steady_stretch.h"
#include "core/milling/cut_model.h"
#include "ui/facade/learned_lobes.h"

namespace stillcut::app {

class LearnedWorker {
 public:
  struct Work {
    std::optional<learn::CutEvidence> cut;  // what the profile's cuts have in common; none: it does not say
    milling::CutModel model;
    ui::LobeFrame frame;
    std::filesystem::path store;
  };
  explicit LearnedWorker(Work work) : work_(std::move(work)) {}

  void learn();
  // A stretch of the stable cut that runs, of which the margin is told; `anew`: cuts may have been kept since the last
  // one. The newest counts.
  void listen(learn::SteadyStretch stretch, bool anew);
  struct Margin {
    std::uint32_t number = 0;               // counts stretches listened to
    std::optional<ui::DepthMargin> margin;  // none: it cannot be told
  };
  Margin margin() const;
  // Until what was asked for is answered.
  void wait() {
    if (thread_.joinable()) thread_.join();
  }
  std::shared_ptr<const ui::LearnedLobes> newest() const;

 private:
  void begin();
  void run(const std::stop_token& stop);

  const Work work_;
  std::optional<learn::LobePosterior> posterior_;  // the thread's own
  mutable std::mutex mutex_;                       // of what follows
  bool busy_ = false, again_ = false, anew_ = false;
  std::shared_ptr<const ui::LearnedLobes> newest_;
  std::optional<learn::SteadyStretch> heard_;
  Margin margin_;
  std::jthread thread_;  // last: ends before what it writes to
};

}  // namespace stillcut::app
