// The PcmDuplexDriver on alsa-lib: capture and playback of one device, linked, with equal periods. Null in a build
// without alsa-lib. Thread: as PcmDuplexDriver says.
#pragma once

#include <memory>

#include "core/active/pcm_duplex.h"

namespace stillcut::app {

std::unique_ptr<active::PcmDuplexDriver> makeAlsaDuplexDriver();

}  // namespace stillcut::app
