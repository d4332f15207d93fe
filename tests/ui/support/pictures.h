// Pictures made by hand for the tests of the view functions.
#pragma once

#include "ui/facade/session_info.h"

namespace stillcut::ui {

struct Scene {
  SessionInfo info;
  Snapshot snapshot;
  Picture picture() const {
    Picture p;
    p.info = &info;
    p.snapshot = &snapshot;
    return p;
  }
  Verdict& verdict() { return snapshot.verdicts[0]; }
};

// A live, valid, stable cut at 8 800 rpm on a machine that answers.
inline Scene stableScene() {
  Scene s;
  s.info.setup.teeth = 4;
  s.info.setup.toolDiameter = Metres(0.012);
  s.info.setup.rate = Hertz(25600);
  s.info.setup.channels = {{"x", SensorQuantity::Acceleration, 1.0, "x"}};
  s.info.detectors = {{"energy-ratio", "Energy ratio", {"er"}}};
  s.info.linkLabel = "LinuxCNC";
  s.snapshot.running = true;
  s.snapshot.number = 1;
  s.snapshot.time = instantFromNs(10'000'000'000);
  s.snapshot.detectorCount = 1;
  Verdict& v = s.verdict();
  v.valid = true;
  v.state = CutState::Stable;
  v.phase = CutPhase::Steady;
  v.time = s.snapshot.time;
  MachineState& m = s.snapshot.machine;
  m.valid = m.linkUp = m.programRunning = true;
  m.time = s.snapshot.time;
  m.programmedSpeed = m.actualSpeed = Rpm(8800);
  m.programmedFeed = m.actualFeed = fromMmPerMin(1408);
  return s;
}

// Regenerative chatter at 1713 Hz in it.
inline Scene chatterScene(CutState state = CutState::Chatter) {
  Scene s = stableScene();
  Verdict& v = s.verdict();
  v.state = state;
  v.kind = ChatterKind::Hopf;
  v.frequency = Hertz(1713);
  v.frequencySd = Hertz(2);
  v.severity = Ratio(0.62);
  v.sinceOnset = Seconds(0.038);
  v.feedSinceOnset = Metres(0.0012);
  return s;
}

}  // namespace stillcut::ui
