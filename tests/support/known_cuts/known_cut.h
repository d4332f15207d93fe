// KnownCut: a signal with the truth about its chatter, and the rule that a detector is held to on it.
// Thread: one; not the sample path.
#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/milling/simulation/scenario.h"
#include "core/model/machine_state.h"
#include "core/model/verdict.h"
#include "tests/support/recording_runner.h"

namespace stillcut::bench {

// When the first alarm has to come. Times against the truth's: chatter over forced vibration, amplitudes.
enum class AlarmRule {
  Silent,   // never
  Sharp,    // from 50 ms before 1 % to 10 ms after 20 %
  Ramp,     // from 1 % to one revolution after 20 %
  Slow,     // from 1 % to 40 ms after 20 %
  Present,  // chatter from the entry on: within 0.3 s of 20 %
  Weak,     // by a sensor that hears forced vibration more than the tip's acceleration does: from 50 ms before 1 % to
            // 150 ms after 20 %
  Growth,   // of a made signal: between its start and `latest`
};

inline constexpr double kNever = std::numeric_limits<double>::quiet_NaN();

struct KnownCut {
  std::string family, name;
  detect::testing::Recording recording;
  std::vector<std::vector<float>> clean;  // the same before noise; empty: not known
  SensorQuantity quantity = SensorQuantity::Acceleration;
  int teeth = 0;
  double rpm = 0.0;  // what a told speed without error says
  AlarmRule rule = AlarmRule::Silent;
  bool stable = true;                  // of a cut that has to be silent: it was, as far as that is looked at
  double at1 = kNever, at20 = kNever;  // s
  // s, s: where the linearised cut was unstable before that, and became stable again. An alarm there is neither early
  // nor is its line the later chatter's.
  std::vector<std::pair<double, double>> unstableBefore;
  double latest = kNever;                                         // s, Growth
  std::vector<double> toldErrors{-0.03, -0.02, 0.0, 0.02, 0.03};  // of the told speed, as ratios
  double chatterHz = 0.0;
  ChatterKind kind = ChatterKind::Unknown;
  double lastAbove = kNever;          // s, recovery: the ratio's last time above 20 %
  double silentFrom = kNever;         // s: out of the material for good
  std::vector<MachineState> machine;  // read-back, one per `machineStep`; empty: there is none
  double machineStep = 0.0;           // s
  std::vector<double> spindleRpm;     // the true speed, one per `machineStep`; empty: it stands
  int blockFrames = 64;               // that a detector is given at once
};

// Reads one of the reference cuts in ../shared/cases (`name`.json, `name`_acc.wav).
KnownCut sharedCut(const std::string& name, AlarmRule rule);
bool haveSharedCut(const std::string& name);

// What a cut is simulated for.
struct SimulationOrder {
  std::string family, name;
  milling::Scenario scenario;
  AlarmRule rule = AlarmRule::Sharp;
  double quietFrom = 0.0, quietTo = 0.0;  // s: a stretch of stable cut, to which the sensor's noise is scaled
  double noise = 0.02;                    // rms of it over the rms of that stretch
  double block = 0.0;                     // s, of the blocks that a detector is given; 0: 64 frames
  int heard = 0;                          // of the scenario's sensors, the first that a detector is given; the others
                                          // (acceleration of the tip) tell the truth. 0: all do both
  bool machineTells = false;
  bool recovers = false;
  bool repeats = false;   // a stable cut at constant speed: in the end it must do the same in each turn
  bool doubling = false;  // period doubling at constant speed with whole samples from tooth to tooth
};

KnownCut simulate(const SimulationOrder& order);

}  // namespace stillcut::bench
