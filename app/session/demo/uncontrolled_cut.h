// The same simulated cut without Stillcut, run ahead in the background: what the vibration would be at every moment, to
// be shown beside what it is. Thread: GUI; the cut is simulated apart, behind everything else.
#pragma once

#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

#include "core/milling/simulation/scenario.h"

namespace stillcut::app {

class UncontrolledCut {
 public:
  explicit UncontrolledCut(milling::Scenario scenario);

  // Rms of the first channel [SI] at `t` since the cut began; not a number: not simulated (yet).
  double vibrationAt(Seconds t) const;

 private:
  void run(const milling::Scenario& scenario, const std::stop_token& stop);

  mutable std::mutex mutex_;
  std::vector<float> rms_;  // one a step
  std::jthread thread_;     // last: ends before what it writes to
};

}  // namespace stillcut::app
