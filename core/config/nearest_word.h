// "Did you mean": the nearest of some words by edit distance.
// Thread: set-up.
#pragma once

#include <span>
#include <string_view>

#include "core/base/message.h"

namespace stillcut::config {

// Empty when none is near enough to be a slip of the finger.
std::string_view nearestWord(std::string_view word, std::span<const std::string_view> words);

// "did you mean 'x'?" or empty.
Message didYouMean(std::string_view word, std::span<const std::string_view> words);

}  // namespace stillcut::config
