// Up to which frequency a detector finds chatter in a recording, from its sampling rate, its sensors and what the
// detector has set itself. What the sensor or a codec has taken away before is not known here.
// Thread: one; not the sample path.
#pragma once

#include <span>

#include "core/detect/detector.h"
#include "core/model/cut_setup.h"

namespace stillcut::evaluate {

// `spindle`: as the detector used it; 0: unknown.
Hertz hearingLimit(const detect::Detector& detector, const CutSetup& setup, Hertz spindle);

}  // namespace stillcut::evaluate
