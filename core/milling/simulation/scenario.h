// Scenario: one simulated cut on one simulated machine, complete: physics, programme, sensors, drives, what is expected
// of control. Files: resources/scenarios/*.toml (scenario_toml.cpp), cases (case_json.cpp). Values: any thread.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/milling/cut_model.h"
#include "core/milling/simulation/override_path.h"
#include "core/milling/simulation/schedule.h"
#include "core/milling/simulation/sensors.h"
#include "core/milling/simulation/spindle_drive.h"
#include "core/milling/simulation/work_holder.h"
#include "core/model/cut_setup.h"

namespace stillcut::milling {

// What control within the override range can make of it, proved by the exact lobes.
enum class Expectation { Stable, NoStableSpeed, Hold };
std::string_view name(Expectation e);

// Where the tool comes into or leaves the material: a time [s] or a place on the path [m].
struct Passage {
  Along along = Along::Time;
  double at = 0.0;
  bool operator==(const Passage&) const = default;
};

struct Programme {
  Rpm speed{};            // S word
  Metres feedPerTooth{};  // the F word is feedPerTooth * teeth * speed
  Seconds duration{};
  Schedule depth;                 // [m]; empty: air
  Schedule immersion;             // a/D; empty: the engagement's
  Schedule speedOverTime;         // S word over time [rev/min]; empty: `speed`
  Schedule feedPerToothOverTime;  // [m]; empty: `feedPerTooth`
  std::optional<Passage> entry;   // the tool's edge meets the material; it is fully in after one radius of path
  std::optional<Passage> exit;    // the tool has left; it begins to leave one radius before
  Seconds feedLag{0.03};          // first-order lag of the feed drives (ours)
  double randomForce = 0.0;       // white, on the tool tip in x and in y [N/sqrt(Hz)] (floor, coolant, bearings)
  double unevenness = 0.0;        // white random part of the cutting force, relative [1/sqrt(Hz)] (ours: grain, chips)
};

struct Scenario {
  std::string name;         // one word
  std::string description;  // one line
  std::string machine, tool;
  CutModel model;
  Programme programme;
  DriveSettings drive;
  OverrideSettings overrides;
  Hertz rate{25600.0};
  int blockFrames = 256;
  std::vector<SensorSettings> sensors;
  std::optional<WorkHolderSettings> workHolder;  // under the workpiece; its flexure comes on top of the model's modes
  std::uint64_t seed = 1;
  Expectation expect = Expectation::Hold;
  bool grantsAuto = false;                 // on its own simulated machine only
  std::string strategy = "stable-pocket";  // default one
  int stepsPerRevolution = 0;              // 0: chosen from modes, speed and rate
  int helixSlices = 8;
  std::map<std::string, std::string> reference;  // what the file it came from says beyond the cut; text

  // F word at a speed, time [s] and path [m].
  MetresPerSecond programmedFeed(Rpm at, double seconds = 0.0, double path = 0.0) const;
  CutSetup cutSetup() const;
  // Steps per revolution actually used: at least 2048, 40 per period of the highest mode, 4 per sample; a multiple of
  // 32 times the teeth, so that a regular pitch falls on whole steps and whole looks at the truth.
  int chosenSteps() const;
};

// From and to TOML (scenario_toml.cpp, scenario_text.cpp); loading checks. Saving loses nothing.
Result<Scenario> loadScenario(const std::string& path);
std::string scenarioText(const Scenario& scenario);
Status saveScenario(const Scenario& scenario, const std::string& path);

// One clear line for what cannot be simulated.
Status check(const Scenario& scenario, const std::string& where);

}  // namespace stillcut::milling
