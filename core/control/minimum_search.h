// MinimumSearch: finds the speed of least vibration by trying neighbours. At each speed it waits until the spindle has
// settled, averages the level over the dwell, then decides: go on in the same direction while the level falls, turn
// round once, and when both neighbours of the best speed are worse (or chattering) end at the vertex of the parabola
// through the three. At most kMostTrials speeds. A cut that grows deeper meanwhile makes every later trial louder: how
// the level drifts while the speed stands is taken out of the comparison. Beginning chatter grows too, but at one speed
// only: the smaller drift of two trials is the depth's. Least vibration may lie at the stability limit; where the
// perturbation's gain H (van Dijk 2010 eq. 26) leaves its scatter of a quiet cut, the side is closed before it
// chatters. Where a neighbour of the best speed has chattered, the search ends a step farther from it: the limit lies
// between, and moves with the depth. Overrides in whole per cents and slip leave the spindle beside the speed that was
// asked for: where it stands is then what is judged. Thread: worker, real-time.
#pragma once

#include "core/base/realtime.h"
#include "core/base/units.h"
#include "core/config/override_limits.h"

namespace stillcut::control {

class MinimumSearch {
 public:
  static constexpr int kMostTrials = 10;

  struct Options {
    double step = 0.01;     // of the base speed
    Seconds wait{0.2};      // after the spindle has settled, for the vibration to do so; at most
    Seconds dwell{0.4};     // averaged; at most
    double turns = 1e9;     // averaged; half as many to settle
    double worthIt = 0.01;  // levels closer than this fraction are the same
  };
  struct Input {
    double dt = 0.0;  // [s]
    double level = 0.0;
    Rpm present{};  // measured spindle speed
    config::SpeedRange reach;
    double perturbation = -1.0;  // H; negative: unknown
  };
  enum class State { Idle, Searching, Done };

  void configure(const Options& options) { options_ = options; }
  void forget() STILLCUT_RT;
  // Starts at `speed`; `base`, the programmed one, scales the step. First goes on away from it: that is where the cut
  // became quiet.
  void start(Rpm speed, Rpm base) STILLCUT_RT;
  // Quiet: one step; the speed to be at.
  Rpm advance(const Input& in) STILLCUT_RT;
  // Chatter at the speed being tried: that side is closed, the search goes on at the other or ends at the best. False
  // when it was the best speed itself that chattered: the search is over and knows nothing.
  bool chattered() STILLCUT_RT;

  State state() const STILLCUT_RT { return state_; }
  Rpm trying() const STILLCUT_RT { return trying_; }
  Rpm best() const STILLCUT_RT { return best_.speed; }
  double bestLevel() const STILLCUT_RT { return best_.level; }

 private:
  struct Point {
    Rpm speed{};
    double level = 0.0;
    double perturbation = 0.0;  // mean; 0: unknown
    bool known = false;
  };
  bool settled(const Input& in) STILLCUT_RT;
  double drift() STILLCUT_RT;
  bool nearChatter() const STILLCUT_RT;
  bool closeThisSide(Rpm chatter) STILLCUT_RT;
  void evaluateTrial(const Point& point) STILLCUT_RT;
  void next() STILLCUT_RT;
  Rpm vertex() const STILLCUT_RT;
  Rpm inside() const STILLCUT_RT;
  void tryAt(Rpm speed) STILLCUT_RT;

  Options options_;
  State state_ = State::Idle;
  Rpm base_{};
  config::SpeedRange reach_;
  Rpm trying_{};
  int way_ = -1;
  Point best_, below_, above_;
  Rpm chatter_{};                                   // the last speed that closed its side by chatter; 0: none
  bool closedBelow_ = false, closedAbove_ = false;  // worse, chattering or out of reach on that side
  int trials_ = 0;
  Rpm stood_{};            // where the spindle has stood
  double stoodFor_ = 0.0;  // [s]
  double waited_ = 0.0;
  double dwelt_ = 0.0;
  double sum_ = 0.0;
  double early_ = 0.0, earlyTime_ = 0.0;  // the first half of the dwell
  double perturbationSum_ = 0.0;
  double sinceJudged_ = 0.0;  // [s]
  double growth_ = 1e9;       // [1/s] of the level, at the trial before
};

}  // namespace stillcut::control
