#include <algorithm>
#include <cstdint>
#include <cstdio>

#include "core/formats/universal/uff58.h"

namespace stillcut::uff {
namespace {

template <class... Args>
void print(std::string& out, const char* format, Args... args) {
  char line[256];
  const int n = std::snprintf(line, sizeof line, format, args...);
  out.append(line, static_cast<std::size_t>(std::clamp(n, 0, 255)));
}

void printAxis(std::string& out, const Uff58Axis& axis) {
  print(out, "%10d%5d%5d%5d %-20.20s %-20.20s\n", static_cast<int>(axis.quantity), 0, 0, 0, axis.label.c_str(),
        axis.unit.c_str());
}

void printHeader(std::string& out, const Uff58Header& set) {
  for (const std::string& line : set.id) print(out, "%-80.80s\n", line.empty() ? "NONE" : line.c_str());
  print(out, "%5d%10d%5d%10d %-10.10s%10ld%4d %-10.10s%10ld%4d\n", static_cast<int>(set.function), 0, 0, 0,
        set.responseName.c_str(), set.responseNode, set.responseDirection, set.referenceName.c_str(), set.referenceNode,
        set.referenceDirection);
  const int type = set.complex ? (set.doublePrecision ? 6 : 5) : (set.doublePrecision ? 4 : 2);
  print(out, "%10d%10llu%10d%13.5E%13.5E%13.5E\n", type, static_cast<unsigned long long>(set.points), set.even ? 1 : 0,
        set.start, set.even ? set.increment : 0.0, set.zValue);
  for (const Uff58Axis* axis : {&set.abscissa, &set.ordinate, &set.denominator, &set.z}) printAxis(out, *axis);
}

}  // namespace

std::string formatUff58Head(const Uff58Header& set, Uff58Form form) {
  std::string out = "    -1\n";
  if (form == Uff58Form::Ascii) {
    out += "    58\n";
  } else {
    const std::uint64_t wide = set.doublePrecision ? 8 : 4;
    const std::uint64_t perPoint = (set.even ? 0 : 4) + wide * (set.complex ? 2u : 1u);
    print(out, "%6s%6d%6d%12d%12llu%6d%6d%12d%12d\n", "58b", form == Uff58Form::BigEndian ? 2 : 1, 2, 11,
          static_cast<unsigned long long>(set.points * perPoint), 0, 0, 0, 0);
  }
  printHeader(out, set);
  return out;
}

}  // namespace stillcut::uff
