// What a recording keeps, declared once. Plain values: any thread.
#pragma once

#include <cstdint>

#include "core/base/units.h"
#include "core/config/param.h"
#include "core/config/param_set.h"

namespace stillcut::record {

enum class RecordMode { Continuous, AroundEvents, Features };  // in the order of the choices

config::ParamTable recordParams();

struct RecordPlan {
  RecordMode mode = RecordMode::Continuous;
  Seconds before{}, after{};      // of an event, AroundEvents
  Seconds interval{}, history{};  // Features: one step kept in so long; how far back
  Seconds keepFor{};              // older files may go
  std::uint64_t keepBytes = 0;    // so much may all files have
};
RecordPlan recordPlan(const config::ParamSet& params);

}  // namespace stillcut::record
