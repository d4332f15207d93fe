#include "core/session/record_params.h"

#include <array>
#include <cmath>

namespace stillcut::record {
namespace {

using config::choiceParam;
using config::locked;
using config::ParamDecl;
using config::realParam;

constexpr std::array<std::string_view, 3> kModes{"continuous", "around-events", "features"};
constexpr ParamDecl kMode =
    locked(choiceParam("record.mode", "Recording", 0, kModes,
                       "What is kept: everything, what surrounds events, or verdicts and indicators alone"));
constexpr ParamDecl kBefore = locked(realParam("record.before", "Kept before an event", "s", 30.0, 0.0, 300.0,
                                               "Around events: how much is kept from before each"));
constexpr ParamDecl kAfter = locked(realParam("record.after", "Kept after an event", "s", 30.0, 1.0, 3600.0,
                                              "Around events: how long recording goes on after the last"));
constexpr ParamDecl kInterval = locked(realParam("record.interval", "Step of the history", "s", 1.0, 0.01, 60.0,
                                                 "Features: one step is kept in so long, and every one with an event"));
constexpr ParamDecl kHistory = locked(
    realParam("record.history", "Length of the history", "h", 24.0, 1.0, 8760.0, "Features: what is older goes"));
constexpr ParamDecl kKeepDays = realParam("record.keep-days", "Keep recordings for", "d", 90.0, 1.0, 36500.0,
                                          "Older recordings without a marker are deleted when a new one begins");
constexpr ParamDecl kKeepSize = realParam("record.keep-size", "Keep recordings up to", "GB", 100.0, 0.001, 1e6,
                                          "The oldest recordings without a marker are deleted beyond it");
constexpr std::array<const ParamDecl*, 7> kAll{&kMode,    &kBefore,   &kAfter,   &kInterval,
                                               &kHistory, &kKeepDays, &kKeepSize};

}  // namespace

config::ParamTable recordParams() {
  return kAll;
}

RecordPlan recordPlan(const config::ParamSet& params) {
  constexpr double kHour = 3600.0;
  RecordPlan plan;
  plan.mode = static_cast<RecordMode>(params.choice(kMode));
  plan.before = Seconds(params.real(kBefore));
  plan.after = Seconds(params.real(kAfter));
  plan.interval = Seconds(params.real(kInterval));
  plan.history = Seconds(params.real(kHistory) * kHour);
  plan.keepFor = Seconds(params.real(kKeepDays) * 24.0 * kHour);
  plan.keepBytes = static_cast<std::uint64_t>(std::llround(params.real(kKeepSize) * 1e9));
  return plan;
}

}  // namespace stillcut::record
