#include "core/milling/identify/uff58.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>

#include "core/milling/identify/number_scan.h"

namespace stillcut::identify {
namespace {

struct Layout {
  std::size_t points = 0;
  double start = 0.0;
  double increment = 0.0;
};

struct BinaryHeader {
  bool bigEndian = false;
  std::size_t bytes = 0;
};

bool isDelimiter(std::string_view line) {
  return trimmed(line) == "-1";
}

// Fixed column field, blank or absent reads as 0: many writers leave trailing fields out.
long fieldInteger(std::string_view line, std::size_t column, std::size_t width) {
  if (column >= line.size()) return 0;
  const auto value = wholeNumber(line.substr(column, width));
  return value && std::abs(*value) < 2e9 ? static_cast<long>(*value) : 0;
}

std::string fieldText(std::string_view line, std::size_t column, std::size_t width) {
  if (column >= line.size()) return {};
  return std::string(trimmed(line.substr(column, width)));
}

// Numbers of a line, however they are spaced.
bool takeNumbers(std::string_view line, std::size_t wanted, std::vector<double>& out) {
  out.clear();
  while (out.size() < wanted) {
    line = trimmed(line);
    const auto value = takeNumber(line);
    if (!value) return false;
    out.push_back(*value);
  }
  return true;
}

Uff58Axis parseAxis(std::string_view line) {
  Uff58Axis axis;
  axis.quantity = static_cast<Uff58Quantity>(fieldInteger(line, 0, 10));
  axis.label = fieldText(line, 26, 20);
  axis.unit = fieldText(line, 47, 20);
  return axis;
}

class Parser {
 public:
  Parser(std::string_view bytes, const std::string& where) : rest_(bytes), where_(where) {}

  Result<std::vector<Uff58Dataset>> run() {
    std::vector<Uff58Dataset> found;
    while (!rest_.empty()) {
      if (!isDelimiter(takeLine(rest_))) continue;
      if (rest_.empty()) break;
      const std::string_view kind = takeLine(rest_);
      ++dataset_;
      Status status = parseDataset(kind, found);
      if (!status) return status.error();
    }
    if (found.empty()) return Error{where_, "holds no dataset 58", "not a universal file of measured functions"};
    return found;
  }

 private:
  Error fail(std::string what, std::string why = "") const {
    return Error{where_ + ": dataset " + std::to_string(dataset_), std::move(what), std::move(why)};
  }

  Status parseDataset(std::string_view kind, std::vector<Uff58Dataset>& found) {
    const std::string_view name = trimmed(kind);
    const std::string_view type = name.substr(0, name.find_first_of(" \t"));
    if (type != "58" && type != "58b" && type != "58B") return skipToEnd();
    std::optional<BinaryHeader> binary;
    if (type != "58") {
      auto header = parseBinaryHeader(name.substr(type.size()));
      if (!header) return header.error();
      binary = *header;
    }
    Uff58Dataset set;
    Layout layout;
    Status header = parseHeader(set, layout);
    if (!header) return header;
    Status data = binary ? readBinary(set, layout, *binary) : readAscii(set, layout);
    if (!data) return data;
    // Binary data need not end with a line end.
    std::string_view tail = trimmed(takeLine(rest_));
    while (tail.empty() && !rest_.empty()) tail = trimmed(takeLine(rest_));
    if (tail != "-1") {
      return fail("does not end after its " + std::to_string(layout.points) + " points",
                  "the size in its header is wrong, or the file is cut off");
    }
    found.push_back(std::move(set));
    return Done{};
  }

  Status skipToEnd() {
    while (!rest_.empty()) {
      if (isDelimiter(takeLine(rest_))) return Done{};
    }
    return fail("has no end", "the file is cut off");
  }

  Result<BinaryHeader> parseBinaryHeader(std::string_view fields) const {
    std::vector<double> n;
    if (!takeNumbers(fields, 4, n)) return fail("its 58b line is incomplete", "byte order, format, lines, bytes");
    if (n[0] != 1.0 && n[0] != 2.0) return fail("its byte order is neither 1 (little) nor 2 (big endian)");
    if (n[1] != 2.0) return fail("its numbers are not IEEE 754", "DEC and IBM formats are not read");
    if (n[2] != 11.0) return fail("its header is not 11 lines long");
    if (!(n[3] >= 0.0 && n[3] < 1e15)) return fail("its byte count is not a size");
    return BinaryHeader{n[0] == 2.0, static_cast<std::size_t>(n[3])};
  }

  Status parseHeader(Uff58Dataset& set, Layout& layout) {
    std::array<std::string_view, 11> lines;
    for (std::string_view& line : lines) {
      if (rest_.empty()) return fail("its header ends early", "the file is cut off");
      line = takeLine(rest_);
    }
    for (std::size_t i = 0; i < set.id.size(); ++i) set.id[i] = std::string(trimmed(lines[i].substr(0, 80)));
    parseFunctionLine(lines[5], set);
    set.abscissa = parseAxis(lines[7]);
    set.ordinate = parseAxis(lines[8]);
    set.denominator = parseAxis(lines[9]);
    set.z = parseAxis(lines[10]);
    return parseLayoutLine(lines[6], set, layout);
  }

  static void parseFunctionLine(std::string_view line, Uff58Dataset& set) {
    set.function = static_cast<Uff58Function>(fieldInteger(line, 0, 5));
    set.responseName = fieldText(line, 31, 10);
    set.responseNode = fieldInteger(line, 41, 10);
    set.responseDirection = static_cast<int>(fieldInteger(line, 51, 4));
    set.referenceName = fieldText(line, 56, 10);
    set.referenceNode = fieldInteger(line, 66, 10);
    set.referenceDirection = static_cast<int>(fieldInteger(line, 76, 4));
  }

  Status parseLayoutLine(std::string_view line, Uff58Dataset& set, Layout& layout) const {
    std::vector<double> n;
    if (!takeNumbers(line, 3, n)) return fail("its size line (record 7) is unreadable", printable(line));
    if (n[0] != 2.0 && n[0] != 4.0 && n[0] != 5.0 && n[0] != 6.0) {
      return fail("its ordinate type is none of 2, 4, 5, 6", printable(line));
    }
    set.complex = n[0] >= 5.0;
    set.doublePrecision = n[0] == 4.0 || n[0] == 6.0;
    if (!(n[1] >= 1.0 && n[1] < 1e12) || n[1] != std::floor(n[1])) {
      return fail("its number of points is not a size", printable(line));
    }
    layout.points = static_cast<std::size_t>(n[1]);
    set.even = n[2] != 0.0;
    if (takeNumbers(line, 6, n)) set.zValue = n[5];
    if (!set.even) return Done{};
    if (!takeNumbers(line, 5, n)) return fail("its abscissa start and step are missing", printable(line));
    layout.start = n[3];
    layout.increment = n[4];
    if (!std::isfinite(layout.start) || !std::isfinite(layout.increment) || layout.increment <= 0.0) {
      return fail("its abscissa step is not positive", printable(line));
    }
    return Done{};
  }

  static std::size_t numbersPerPoint(const Uff58Dataset& set) { return (set.even ? 1u : 2u) + (set.complex ? 1u : 0u); }

  // One point from the numbers stored for it.
  Status append(Uff58Dataset& set, const Layout& layout, const std::array<double, 3>& v) const {
    const std::size_t i = set.y.size();
    for (std::size_t k = 0; k < numbersPerPoint(set); ++k) {
      if (!std::isfinite(v[k])) return fail("point " + std::to_string(i + 1) + " is not a finite number");
    }
    const std::size_t first = set.even ? 0 : 1;
    set.x.push_back(set.even ? layout.start + static_cast<double>(i) * layout.increment : v[0]);
    set.y.emplace_back(v[first], set.complex ? v[first + 1] : 0.0);
    return Done{};
  }

  // Reserve only what the bytes that are there can hold.
  Status reserve(Uff58Dataset& set, const Layout& layout, std::size_t leastBytesPerPoint) const {
    if (layout.points > rest_.size() / leastBytesPerPoint + 1) {
      return fail("announces " + std::to_string(layout.points) + " points, more than the file holds",
                  "the file is cut off or its header is wrong");
    }
    set.x.reserve(layout.points);
    set.y.reserve(layout.points);
    return Done{};
  }

  Status readAscii(Uff58Dataset& set, const Layout& layout) {
    const std::size_t perPoint = numbersPerPoint(set);
    Status room = reserve(set, layout, 2 * perPoint);
    if (!room) return room;
    std::array<double, 3> v{};
    std::size_t have = 0;
    while (set.y.size() < layout.points) {
      if (rest_.empty()) return endedEarly(set, layout);
      const std::string_view whole = takeLine(rest_);
      if (isDelimiter(whole)) return endedEarly(set, layout);
      std::string_view line = trimmed(whole);
      while (!line.empty() && set.y.size() < layout.points) {
        const auto number = takeNumber(line);
        if (!number) return fail("'" + printable(line) + "' is not a number", atPoint(set));
        v[have++] = *number;
        line = trimmed(line);
        if (have < perPoint) continue;
        have = 0;
        Status added = append(set, layout, v);
        if (!added) return added;
      }
      if (!line.empty()) return fail("has more numbers than its " + std::to_string(layout.points) + " points");
    }
    return Done{};
  }

  Status readBinary(Uff58Dataset& set, const Layout& layout, const BinaryHeader& header) {
    const std::size_t wide = set.doublePrecision ? 8 : 4;
    const std::size_t values = set.complex ? 2 : 1;
    // An uneven abscissa is single precision by the standard; some writers use the ordinate's precision.
    std::size_t abscissa = set.even ? 0 : 4;
    if (!set.even && header.bytes == layout.points * (wide + values * wide)) abscissa = wide;
    const std::size_t perPoint = abscissa + values * wide;
    Status room = reserve(set, layout, perPoint);
    if (!room) return room;
    const std::size_t total = layout.points * perPoint;
    if (header.bytes != total) {
      return fail("announces " + std::to_string(header.bytes) + " bytes, but its points take " + std::to_string(total),
                  "header inconsistent");
    }
    if (total > rest_.size()) return fail("holds fewer bytes than it announces", "the file is cut off");
    const char* at = rest_.data();
    std::size_t implausible = 0;
    for (std::size_t i = 0; i < layout.points; ++i) {
      std::array<double, 3> v{};
      std::size_t k = 0;
      if (abscissa > 0) v[k++] = decode(at, abscissa, header.bigEndian);
      at += abscissa;
      for (std::size_t n = 0; n < values; ++n, at += wide) {
        v[k] = decode(at, wide, header.bigEndian);
        if (isImplausible(v[k++])) ++implausible;
      }
      if (implausible * 20 > layout.points * values) return wrongOrder();
      Status added = append(set, layout, v);
      if (!added) return added;
    }
    rest_.remove_prefix(total);
    return Done{};
  }

  static double decode(const char* at, std::size_t bytes, bool bigEndian) {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < bytes; ++i) {
      const std::size_t from = bigEndian ? i : bytes - 1 - i;
      bits = (bits << 8) | static_cast<unsigned char>(at[from]);
    }
    return bytes == 4 ? static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)))
                      : std::bit_cast<double>(bits);
  }

  // No measured quantity in any unit is of this size: more than one in twenty means swapped bytes, which make about a
  // fifth of single and nine tenths of double numbers look so.
  static bool isImplausible(double v) {
    return !std::isfinite(v) || (v != 0.0 && (std::abs(v) > 1e30 || std::abs(v) < 1e-30));
  }

  Error wrongOrder() const {
    return fail("its numbers make no sense in the byte order its header gives", "little and big endian mixed up");
  }
  Error endedEarly(const Uff58Dataset& set, const Layout& layout) const {
    return fail("ends after " + std::to_string(set.y.size()) + " of " + std::to_string(layout.points) + " points",
                "the file is cut off or its header is wrong");
  }
  static std::string atPoint(const Uff58Dataset& set) { return "at point " + std::to_string(set.y.size() + 1); }

  std::string_view rest_;
  const std::string& where_;
  int dataset_ = 0;
};

}  // namespace

Result<std::vector<Uff58Dataset>> parseUff58(std::string_view bytes, const std::string& where) {
  return Parser(bytes, where).run();
}

bool looksLikeUff(std::string_view bytes) {
  return isDelimiter(takeLine(bytes));
}

}  // namespace stillcut::identify
