// Whole universal files for tests of what reads them: every form of dataset 58, evenly spaced or not, real or complex,
// single or double. The program itself writes evenly spaced real samples only, as they come
// (core/formats/universal/uff_sink.cpp).
#pragma once

#include <bit>
#include <cstdint>
#include <cstdio>
#include <string>

#include "core/formats/universal/uff58.h"

namespace stillcut::test {

// Numbers per line as the standard gives them: 6E13.5 single, 4E20.12 double, whole points per uneven line.
inline std::string uffNumbers(const uff::Uff58Dataset& set) {
  const std::size_t perPoint = (set.even ? 1U : 2U) + (set.complex ? 1U : 0U);
  const std::size_t perLine = set.doublePrecision ? (!set.even && perPoint == 3 ? 3 : 4) : 6;
  std::string out;
  std::size_t onLine = 0;
  const auto put = [&](double v, bool wide) {
    char cell[32];
    std::snprintf(cell, sizeof cell, wide ? "%20.12E" : "%13.5E", v);
    out += cell;
    if (++onLine % perLine == 0) out += '\n';
  };
  for (std::size_t i = 0; i < set.y.size(); ++i) {
    if (!set.even) put(set.x[i], false);
    put(set.y[i].real(), set.doublePrecision);
    if (set.complex) put(set.y[i].imag(), set.doublePrecision);
  }
  if (onLine % perLine != 0) out += '\n';
  return out;
}

inline std::string uffBytes(const uff::Uff58Dataset& set, bool bigEndian) {
  std::string out;
  const auto put = [&](double v, std::size_t bytes) {
    const std::uint64_t bits =
        bytes == 4 ? std::bit_cast<std::uint32_t>(static_cast<float>(v)) : std::bit_cast<std::uint64_t>(v);
    for (std::size_t i = 0; i < bytes; ++i) {
      const std::size_t shift = 8 * (bigEndian ? bytes - 1 - i : i);
      out += static_cast<char>((bits >> shift) & 0xffU);
    }
  };
  for (std::size_t i = 0; i < set.y.size(); ++i) {
    if (!set.even) put(set.x[i], 4);
    put(set.y[i].real(), set.doublePrecision ? 8 : 4);
    if (set.complex) put(set.y[i].imag(), set.doublePrecision ? 8 : 4);
  }
  return out;
}

// One dataset as a universal file's text, from its first -1 to its last. x must be as long as y; points, start and
// increment are taken from x.
inline std::string uffDataset(const uff::Uff58Dataset& set, uff::Uff58Form form) {
  uff::Uff58Header header = set;
  header.points = set.y.size();
  header.start = set.x.empty() ? 0.0 : set.x.front();
  const bool steps = set.x.size() > 1;
  header.increment = steps ? (set.x.back() - set.x.front()) / static_cast<double>(set.x.size() - 1) : 1.0;
  const std::string head = uff::formatUff58Head(header, form);
  if (form == uff::Uff58Form::Ascii) return head + uffNumbers(set) + "    -1\n";
  return head + uffBytes(set, form == uff::Uff58Form::BigEndian) + "\n    -1\n";
}

}  // namespace stillcut::test
