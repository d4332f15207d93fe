// The table of detectors: a detector is a header, a source, a test and one line here.
// Thread: set-up only.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "core/base/result.h"
#include "core/config/param.h"
#include "core/detect/detector.h"

namespace stillcut::detect {

struct DetectorRow {
  std::string_view id;
  std::unique_ptr<Detector> (*make)();
  config::ParamTable (*params)();
};

std::span<const DetectorRow> detectorTable();
inline constexpr std::string_view kDefaultDetector = "energy-ratio";

// Error: names the unknown id and the nearest known one.
Result<std::unique_ptr<Detector>> makeDetector(std::string_view id);

}  // namespace stillcut::detect
