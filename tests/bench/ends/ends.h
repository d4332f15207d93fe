// What may become of a program, its keeper, its wire and its machine while the overrides are at 83 %: the rows of the
// table. Thread: one.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/time.h"
#include "tests/bench/ends/machine.h"
#include "tests/bench/ends/program.h"

namespace stillcut::ends {

inline constexpr Stand kHome{100, 100}, kHand{40, 0};

struct End {
  std::string name, said;
  // Brings it about. The moment from which on the way home counts; nothing: this link has no such end.
  std::function<std::optional<Instant>(const Program&, Machine&)> act;
  Stand then = kHome;    // where it has to stand afterwards
  bool mayStay = false;  // nobody is left who could bring it there
};

const std::vector<End>& ends();

}  // namespace stillcut::ends
