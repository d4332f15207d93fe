// The limits of one speed as the screens draw them. Thread: any; pure.
#pragma once

#include "core/milling/stability/exact_lobes.h"
#include "ui/facade/lobe_service.h"

namespace stillcut::app {

ui::LobeLimit lobeLimit(const milling::SpeedLimits& limits);

}  // namespace stillcut::app
