#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdio>

#include "core/record/uff/uff58.h"

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

// Numbers per line as the standard gives them: 6E13.5 single, 4E20.12 double, whole points per uneven line.
void printAscii(std::string& out, const Uff58Dataset& set) {
  const std::size_t perPoint = (set.even ? 1u : 2u) + (set.complex ? 1u : 0u);
  const std::size_t perLine = set.doublePrecision ? (set.even ? 4 : perPoint == 3 ? 3 : 4) : 6;
  const char* format = set.doublePrecision ? "%20.12E" : "%13.5E";
  std::size_t onLine = 0;
  const auto put = [&](double v, const char* f) {
    print(out, f, v);
    if (++onLine == perLine) {
      out += '\n';
      onLine = 0;
    }
  };
  for (std::size_t i = 0; i < set.y.size(); ++i) {
    if (!set.even) put(set.x[i], "%13.5E");
    put(set.y[i].real(), format);
    if (set.complex) put(set.y[i].imag(), format);
  }
  if (onLine > 0) out += '\n';
}

void putBytes(std::string& out, double v, std::size_t bytes, bool bigEndian) {
  const std::uint64_t bits =
      bytes == 4 ? std::bit_cast<std::uint32_t>(static_cast<float>(v)) : std::bit_cast<std::uint64_t>(v);
  for (std::size_t i = 0; i < bytes; ++i) {
    const std::size_t shift = 8 * (bigEndian ? bytes - 1 - i : i);
    out += static_cast<char>((bits >> shift) & 0xffu);
  }
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

std::string formatUff58(const Uff58Dataset& set, Uff58Form form) {
  Uff58Header header = set;
  header.points = set.y.size();
  header.start = set.x.empty() ? 0.0 : set.x.front();
  const bool steps = set.x.size() > 1;
  header.increment = steps ? (set.x.back() - set.x.front()) / static_cast<double>(set.x.size() - 1) : 1.0;
  std::string out = formatUff58Head(header, form);
  if (form == Uff58Form::Ascii) {
    printAscii(out, set);
    return out + "    -1\n";
  }
  const bool big = form == Uff58Form::BigEndian;
  const std::size_t wide = set.doublePrecision ? 8 : 4;
  for (std::size_t i = 0; i < set.y.size(); ++i) {
    if (!set.even) putBytes(out, set.x[i], 4, big);
    putBytes(out, set.y[i].real(), wide, big);
    if (set.complex) putBytes(out, set.y[i].imag(), wide, big);
  }
  return out + "\n    -1\n";
}

}  // namespace stillcut::uff
