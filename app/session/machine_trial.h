// A profile tried out step by step, without a cut: its settings, its device, samples, its link, the machine's answer.
// Thread: any one; takes up to a few seconds. What it opened is closed again; nothing is commanded.
#pragma once

#include <atomic>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "core/base/units.h"
#include "core/cnc/cnc_link.h"
#include "core/cnc/link_trial.h"
#include "core/config/profile.h"
#include "ui/facade/setup_controller.h"

namespace stillcut::app {

struct ProfileTrial {
  std::vector<ui::TrialStep> steps;
  Seconds look{};  // how long one at the machine takes; 0: its link has not passed
};

// What the run that holds a machine tells of it. A second program, or a second connection of this one, would be one too
// many for some machines: a trial of this link asks the run.
struct RunsLink {
  cnc::LinkInfo info;  // but for its label, which goes with the run
  std::string label;
  MachineState state;
  Seconds age{};     // of the state
  Seconds effect{};  // from an order to its effect; 0: none was seen

  std::vector<cnc::LinkTrialStep> steps() const;
};

// `run`: holds this very link; null: none does.
ProfileTrial tryProfile(const config::Profile& profile, const std::string& path, const RunsLink* run = nullptr);

// Steps on their way from the thread that takes them to the one that shows them.
class LinkStepBox {
 public:
  void put(ui::LinkTest::Step step) {
    const std::lock_guard lock(mutex_);
    steps_.push_back(std::move(step));
  }
  // What has come since the last call.
  std::vector<ui::LinkTest::Step> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(steps_, {});
  }

 private:
  std::mutex mutex_;
  std::vector<ui::LinkTest::Step> steps_;
};

// The link alone, as the run tells. At once.
std::vector<ui::LinkTest::Step> linkAsRunTells(const RunsLink& run);

// The profile's link alone, held by nobody. How long a look at the machine takes; 0: it has not passed, or `toEnd` was
// set before.
Seconds tryLinkOf(const config::Profile& profile, const std::string& path, LinkStepBox& steps,
                  const std::atomic<bool>& toEnd);

}  // namespace stillcut::app
