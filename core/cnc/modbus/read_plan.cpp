#include "core/cnc/modbus/read_plan.h"

#include <algorithm>

namespace stillcut::cnc {
namespace {

bool isOfWords(RegisterTable table) {
  return table == RegisterTable::Input || table == RegisterTable::Holding;
}

// One may be inside of the other, or they touch.
bool joins(const ReadSpan& a, const ReadSpan& b) {
  return a.count > 0 && b.count > 0 && a.table == b.table && isOfWords(a.table) && a.first <= b.first + b.count &&
         b.first <= a.first + a.count;
}

ReadSpan both(const ReadSpan& a, const ReadSpan& b) {
  const int first = std::min(a.first, b.first);
  return {a.table, first, std::max(a.first + a.count, b.first + b.count) - first, a.members | b.members};
}

}  // namespace

ReadPlan::ReadPlan(const RegisterMap& map) {
  for (std::size_t s = 0; s < kMachineSignals; ++s) {
    if (!map.read[s]) continue;
    alone_[s] = {map.read[s]->table, map.read[s]->address, map.read[s]->words, 1U << s};
  }
  together_ = alone_;
  for (bool grew = true; grew;) {
    grew = false;
    for (ReadSpan& a : together_) {
      for (const ReadSpan& b : together_) {
        if (a.members == b.members || !joins(a, b)) continue;
        const ReadSpan joined = both(a, b);
        if (joined.count > static_cast<int>(kMostWords) || joined.members == a.members) continue;
        a = joined;
        grew = true;
      }
    }
  }
}

int ReadPlan::questions() const noexcept {
  int questions = 0;
  std::uint32_t asked = 0;
  for (std::size_t s = 0; s < kMachineSignals; ++s) {
    if (of(s).count == 0 || (asked >> s & 1U) != 0) continue;
    asked |= of(s).members;
    ++questions;
  }
  return questions;
}

}  // namespace stillcut::cnc
