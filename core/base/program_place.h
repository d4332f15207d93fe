// Where a program that comes with this one is: beside it, where a package puts it, or where the build has made it.
// Thread: any.
#pragma once

#include <string>
#include <string_view>

namespace stillcut {

// `built`: its path in the build's own folder; may be empty. Empty: it is not there.
std::string programPlace(std::string_view name, std::string_view built);

}  // namespace stillcut
