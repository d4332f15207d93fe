// What is fuzzed: one function per reader, given bytes that a stranger chose. A target must come back: with a result or
// with an error of one line. It aborts where a reader breaks a promise: a sample that is not finite, a block larger
// than its capacity, an error of several lines.
#pragma once

#include <span>
#include <string_view>

namespace stillcut::fuzz {

struct Target {
  std::string_view name;    // folder of its corpus, too
  std::string_view suffix;  // of the file it is given
  void (*run)(std::string_view bytes);
};

std::span<const Target> targets();
const Target* findTarget(std::string_view name);

}  // namespace stillcut::fuzz
