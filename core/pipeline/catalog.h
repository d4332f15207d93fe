// Every parameter there is, collected from the parts that declare them.
// Thread: set-up.
#pragma once

#include "core/config/param_set.h"

namespace stillcut::pipeline {

config::ParamCatalog fullCatalog();

}  // namespace stillcut::pipeline
