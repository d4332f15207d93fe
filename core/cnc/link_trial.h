// LinkTrial: tries a machine link step by step and says in plain words what came of each step. It only reads: a command
// can come from the gate alone. Whether an order acts is for others to try, and what a machine can do is said with it.
// The command line and a set-up page show the same sentences, the page translated. Thread: one that may wait: open()
// takes seconds at most, every other step bounded time.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/cnc/cnc_link.h"

namespace stillcut::cnc {

struct LinkTrialStep {
  std::string what;  // "Connect"
  std::vector<Message> said;
  bool good = false;
};

class LinkTrial {
 public:
  // Both outlive the trial.
  LinkTrial(CncLink& link, const Clock& clock) : link_(link), clock_(clock) {}

  // Takes the next step; false: there is none, because all are done or one has failed.
  bool next();
  // The same steps by what the run that holds the machine knows of it; nothing is said to the machine. `age`: of
  // `state`; `effect`: as for proved().
  static std::vector<LinkTrialStep> ofRun(const LinkInfo& info, const MachineState& state, Seconds age, Seconds effect);
  // The next one is the last: what the machine can do.
  bool atLast() const { return steps_.size() + 1 == kSteps && steps_.back().good; }
  // An order was seen to act and to be taken back, now or in an earlier run, after so long; 0: none was.
  void proved(Seconds effect) { effect_ = effect; }
  const std::vector<LinkTrialStep>& steps() const { return steps_; }
  bool passed() const;
  // How long a look at the machine takes, and how old what it shows is; medians, 0 before they were measured.
  Seconds look() const { return look_; }
  Seconds age() const { return age_; }

  static constexpr int kLooks = 60;
  static constexpr std::size_t kSteps = 4;
  static constexpr std::array<const char*, kSteps> kNames{"Connect", "Read the machine", "Measure the delay",
                                                          "What it can do"};
  // Every form and every word of what the steps say, but for errors; for whoever translates them.
  static std::span<const char* const> words();

 private:
  LinkTrialStep connect();
  LinkTrialStep read();
  LinkTrialStep measure();

  CncLink& link_;
  const Clock& clock_;
  std::vector<LinkTrialStep> steps_;
  Seconds look_{}, age_{}, effect_{};
};

}  // namespace stillcut::cnc
