// The quantity of a sensor as our files spell it. Thread: set-up.
#pragma once

#include "core/config/toml_reader.h"
#include "core/model/channel.h"

namespace stillcut::config {

// Key `quantity`; any other word is refused with the choices.
SensorQuantity readQuantity(const TomlTable& table);

}  // namespace stillcut::config
