// A number as our files, messages and panels write it: the fewest digits that read back as the same double, without an
// exponent where a person would write none.
// Thread: set-up.
#pragma once

#include <string>

namespace stillcut::config {

std::string numberText(double value);

}  // namespace stillcut::config
