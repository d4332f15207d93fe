// Limits over many speeds, in parallel, and the chart made of them. The same numbers come out whatever the number of
// threads. Progress is reported from the working threads, one call at a time; a stop request ends the work within one
// piece (work_meter.h: some 20 ms at the most), and what is then returned is marked unfinished.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/milling/stability/exact_lobes.h"
#include "core/milling/stability/measured_receptance.h"
#include "core/milling/stability/semi_discretization.h"

namespace stillcut::milling {

enum class LobeMethod { Exact, SemiDiscretization, ZerothOrder };

struct SweepOptions {
  LobeMethod method = LobeMethod::Exact;
  LimitOptions limits;  // maxAxialDepth counts for every method
  SdmOptions sdm;
  std::optional<MeasuredReceptance> measured{};  // the zeroth order takes it instead of the modes
  int threads = 2;
  std::function<void(double)> progress;  // fraction done, 0..1
};

struct LobeSweep {
  // In the order asked for; entries not reached, and those too low for teeth that differ, have searchedTo 0.
  std::vector<SpeedLimits> speeds;
  Metres maxAxialDepth{};         // asked for; an entry with less in searchedTo says nothing about what lies deeper
  std::vector<Message> warnings;  // of the method and of what the model leaves out
  bool finished = false;          // false: stopped

  // Searched down to maxAxialDepth.
  bool complete(const SpeedLimits& limits) const { return limits.searchedTo >= (1.0 - 1e-9) * maxAxialDepth; }
};

// Refuses a bad model, no speeds, a bad speed or depth with one line.
Result<LobeSweep> sweepLobes(const CutModel& model, std::span<const Rpm> speeds, const SweepOptions& options,
                             const std::string& where, const std::stop_token& stop = {});

// from, from + step, ... with `to` included where a step meets it to a millionth of a step.
Result<std::vector<Rpm>> speedSteps(Rpm from, Rpm to, Rpm step, const std::string& where);

}  // namespace stillcut::milling
