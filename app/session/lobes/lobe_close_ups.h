// LobeCloseUps: places of a stability diagram from near, in the background, one at a time; a newer question ends the
// one before. What it says is what the command `advise` says of the same cut and range of speeds: both ask
// adviseSpeeds(). Speeds that the machine reaches come first.
// Thread: GUI; the work runs on a thread of its own that yields to everything else.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "core/milling/cut_model.h"
#include "ui/facade/lobe_service.h"

namespace stillcut::app {

class LobeCloseUps {
 public:
  // `model` has passed check() and has a force exponent of 1.
  LobeCloseUps(milling::CutModel model, ui::LobeFrame frame) : model_(std::move(model)), frame_(std::move(frame)) {}
  ~LobeCloseUps();
  LobeCloseUps(const LobeCloseUps&) = delete;
  LobeCloseUps& operator=(const LobeCloseUps&) = delete;

  void look(const ui::SpeedDepth& at);
  std::shared_ptr<const ui::LobeCloseUp> newest() const;

 private:
  void work(const std::stop_token& end);
  void answer(const ui::SpeedDepth& at, const std::stop_token& stop);
  void tell(const ui::LobeCloseUp& closeUp);

  const milling::CutModel model_;
  const ui::LobeFrame frame_;
  mutable std::mutex mutex_;  // of what follows
  std::condition_variable_any asked_;
  std::optional<ui::SpeedDepth> wanted_, last_;
  std::stop_source current_;
  std::shared_ptr<const ui::LobeCloseUp> newest_;
  std::jthread thread_;  // from the first question on; ends before what it writes to
};

}  // namespace stillcut::app
