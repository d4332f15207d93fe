// resources/materials.toml as it was when this was built. Thread: any.
#pragma once

#include <string_view>

namespace stillcut::milling {

extern const std::string_view kMaterialsText;

}  // namespace stillcut::milling
