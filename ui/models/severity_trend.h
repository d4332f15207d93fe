// Whether chatter grows, stays or dies down, from the severities of the last half second of stream time.
#pragma once

#include <deque>

#include "core/model/verdict.h"

namespace stillcut::ui {

enum class Trend { Unknown, Growing, Steady, Fading };

class SeverityTrend {
 public:
  // Call once per new verdict. Samples that are not alarming or not valid start afresh.
  void add(const Verdict& verdict);
  Trend trend() const;

 private:
  struct Point {
    Instant time;
    double severity;
  };
  std::deque<Point> points_;
};

}  // namespace stillcut::ui
