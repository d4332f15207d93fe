// LobeWorker: stability lobes in the background, for the Lobes page. One question at a time; another one ends it. The
// diagram comes coarse first, and finer until its line is true to half a percent of the depth: what the machine reaches
// before the rest.
// Thread: GUI; the work runs on a thread of its own that yields to everything else.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/session/lobes/learned_worker.h"
#include "app/session/lobes/lobe_close_ups.h"
#include "core/config/profile.h"
#include "core/milling/cut_model.h"
#include "core/milling/simulation/scenario.h"
#include "core/milling/simulation/schedule.h"
#include "core/milling/stability/lobe_sweep.h"
#include "ui/facade/lobe_service.h"

namespace stillcut::app {

class LobeWorker final : public ui::LobeService {
 public:
  struct Cut {
    milling::CutModel model;
    ui::LobeFrame frame;
    milling::Schedule depth;  // over time since the cut began; empty: the frame's
  };
  explicit LobeWorker(Cut cut);
  // Of a scenario, at its widest.
  explicit LobeWorker(const milling::Scenario& scenario);
  // Of the model that a profile names, beside the profile, within its override limits. Null: it names none.
  static Result<std::unique_ptr<LobeWorker>> ofProfile(const config::Profile& profile, const std::string& path);
  // From now on learn() reads the cuts kept in this file. `cut`: as evidenceOf() said it.
  void learnFrom(const std::filesystem::path& store, const std::optional<learn::CutEvidence>& cut);

  // Stream time at which the programme began. In a replay every jump begins it anew, for what is seen `from` then on.
  void setStart(Instant start, Instant from = {});
  bool started() const { return !starts_.empty(); }
  std::optional<Instant> start() const { return started() ? std::optional(starts_.back().start) : std::nullopt; }

  const ui::LobeFrame& frame() const override { return cut_.frame; }
  Metres axialDepthAt(Instant t) const override;
  void ask(const ui::LobeQuestion& question) override;
  void cancel() override;
  ui::LobeProgress progress() const override;
  std::shared_ptr<const ui::LobeDiagram> diagram() const override;
  void look(const ui::SpeedDepth& at) override { closeUps_.look(at); }
  std::shared_ptr<const ui::LobeCloseUp> closeUp() const override { return closeUps_.newest(); }
  void learn() override {
    if (learned_) learned_->learn();
  }
  LearnedWorker* learnedWorker() { return learned_.get(); }  // null: nothing is learned of such a cut
  std::shared_ptr<const ui::LearnedLobes> learned() const override { return learned_ ? learned_->newest() : nullptr; }

 private:
  void compute(const ui::LobeQuestion& question, const std::stop_token& stop);
  void refine(const ui::LobeQuestion& question, milling::LobeSweep sweep, milling::SweepOptions options,
              const std::stop_token& stop);
  void tell(const ui::LobeQuestion& question, const milling::LobeSweep& sweep);
  void finish(ui::LobeProgress::State state, const QString& problem = {});

  Cut cut_;
  LobeCloseUps closeUps_;
  std::unique_ptr<LearnedWorker> learned_;  // null: nothing is learned of such a cut
  struct Start {
    Instant from, start;
  };
  std::vector<Start> starts_;  // by `from`
  mutable std::mutex mutex_;   // of what follows
  ui::LobeProgress progress_;
  std::shared_ptr<const ui::LobeDiagram> diagram_;
  std::uint32_t answers_ = 0;
  std::jthread thread_;  // last: ends before what it writes to
};

// What is worth looking at for these modes and this tool: from the third lobe of the slowest mode to beyond the first
// lobe of the fastest.
ui::LobeFrame usualFrame(const milling::CutModel& model);

}  // namespace stillcut::app
