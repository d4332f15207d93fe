// G-code of a guided trial for LinuxCNC and GRBL: one straight cut at a speed; a sweep of the speed at constant depth
// (Brecher 2018: some 3 % a second, so that chatter has time to grow); an inclined cut whose depth rises along the
// path. The tool moves along X over the stock from X0 to X(length) at Y0; Z0 is the top of the stock, in the work
// offset and with the tool length that are in force. Nothing is changed but spindle and axes: G49 or another work
// offset before the first move would send the tool into the stock. It comes down beside the stock, its whole radius
// away from it. Pure; any thread.
#pragma once

#include <cstdint>
#include <string>

#include "core/base/result.h"
#include "core/base/units.h"

namespace stillcut::learn {

enum class TrialKind : std::uint8_t { Cut, SpeedSweep, Incline };
enum class Controller : std::uint8_t { LinuxCnc, Grbl };

struct TrialProgram {
  TrialKind kind = TrialKind::Cut;
  Controller controller = Controller::LinuxCnc;
  int teeth = 2;
  Metres diameter{};  // of the tool
  Metres feedPerTooth{};
  Rpm speed{};                   // of the cut; where a sweep begins
  Rpm lastSpeed{};               // where a sweep ends; sweeps alone
  Metres depth{};                // of the cut; where an incline begins
  Metres lastDepth{};            // where an incline ends; inclines alone
  Metres length{};               // of material along X
  Metres clearance{0.005};       // between tool and material: above, before and behind
  double sweepPerSecond = 0.03;  // change of speed [1/s]
  Seconds runUp{3.0};            // for the spindle to reach its speed
};

// Length of material that a trial needs; 0 where any does.
Metres lengthNeeded(const TrialProgram& trial);

// Error: a number that is none, or material that is too short for the sweep.
Result<std::string> trialGCode(const TrialProgram& trial);

}  // namespace stillcut::learn
