// A small cut of two equal modes across each other, for tests that ask about one thing and want it soon.
#pragma once

#include "core/milling/simulation/scenario.h"

namespace stillcut::milling {

inline Scenario smallCut(const char* name, Rpm speed, Seconds duration, double depth) {
  Scenario s;
  s.name = name;
  Mode x;
  x.frequency = Hertz(900.0);
  x.damping = 0.03;
  x.stiffness = 8e6;
  Mode y = x;
  y.direction = {0.0, 1.0};
  s.model.modes = {x, y};
  s.model.tool.teeth = 3;
  s.model.engagement = {0.5, MillingDirection::Down};
  s.programme.speed = speed;
  s.programme.feedPerTooth = Metres(1e-4);
  s.programme.duration = duration;
  s.programme.depth = constantSchedule(depth);
  return s;
}

}  // namespace stillcut::milling
