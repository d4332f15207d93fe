// The rules of a fuzzy strategy as they are at this moment, what was learned included: for screens. Any thread.
#pragma once

#include <array>
#include <cstdint>

namespace stillcut {

inline constexpr int kRuleSets = 9;  // NX NB NM NS ZE PS PM PB PX

struct RuleTables {
  // [set of the coherence error][set of its change]: singletons 1 .. 9; 5 asks for nothing.
  using Table = std::array<std::array<float, kRuleSets>, kRuleSets>;
  Table speed{}, feed{};
  std::uint32_t lessons = 0;  // times that learning has changed them; 0: they are as set
  bool refused = false;       // what was set last cannot be used together; what was set before acts
};

}  // namespace stillcut
