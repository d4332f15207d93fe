// Random tools, engagements and force laws at a share of their exact stability limit, and what the truth of the
// simulated cut makes of them: for the test and for the table that hold one against the other. Thread: any.
#pragma once

#include <optional>
#include <string>

#include "core/milling/simulation/noise.h"
#include "core/milling/simulation/scenario.h"
#include "core/milling/stability/exact_lobes.h"
#include "core/model/verdict.h"

namespace stillcut::test {

enum class CutKind { Plain, Helix, UnevenPitch, PowerLaw, UnlikeHelix };
const char* cutKindName(CutKind kind);

// Low immersion half of the time; no depth yet.
milling::Scenario randomCut(milling::NoiseSource& random, CutKind kind);

// What the exact lobes say of a scenario at its speed.
struct KnownLimit {
  milling::StabilityLimit first;
  milling::SpeedLimits limits;
};
// Empty: nothing limits it within 12 mm.
Result<std::optional<KnownLimit>> knownLimit(const milling::Scenario& scenario);

// Growth of a small disturbance of the linear cut in e-folds a second, from the time domain.
double growthOf(const milling::Scenario& scenario, Metres depth);

enum class Agreement { Agrees, NoTimeToGrow, FalseChatter, UnnamedChatter, OtherFrequency };

struct Comparison {
  Agreement agreement = Agreement::Agrees;
  double folds = 0.0;  // e-folds that the disturbance has had time for
  ChatterKind kind = ChatterKind::Unknown;
  double hz = 0.0, peak = 0.0;
  bool unstable = false;
};

// Simulates the scenario at `factor` times the limit and compares verdict and frequency.
Comparison compareWithTruth(milling::Scenario scenario, const KnownLimit& known, double factor);
std::string comparisonText(const milling::Scenario& scenario, const KnownLimit& known, double factor,
                           const Comparison& found);

}  // namespace stillcut::test
