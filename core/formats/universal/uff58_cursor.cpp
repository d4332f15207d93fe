#include "core/formats/universal/uff58_cursor.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/units/number_scan.h"

namespace stillcut::uff {
namespace {

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

void parseFunctionLine(std::string_view line, Uff58Header& set) {
  set.function = static_cast<Uff58Function>(fieldInteger(line, 0, 5));
  set.responseName = fieldText(line, 31, 10);
  set.responseNode = fieldInteger(line, 41, 10);
  set.responseDirection = static_cast<int>(fieldInteger(line, 51, 4));
  set.referenceName = fieldText(line, 56, 10);
  set.referenceNode = fieldInteger(line, 66, 10);
  set.referenceDirection = static_cast<int>(fieldInteger(line, 76, 4));
}

double decode(const char* at, std::size_t bytes, bool bigEndian) {
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
bool isImplausible(double v) {
  return !std::isfinite(v) || (v != 0.0 && (std::abs(v) > 1e30 || std::abs(v) < 1e-30));
}

}  // namespace

Uff58Cursor::Uff58Cursor(ByteWindow window, std::string where) : window_(std::move(window)), where_(std::move(where)) {}

Error Uff58Cursor::fail(Message what, Message why) const {
  return Error{where_ + ": dataset " + std::to_string(place_.dataset), std::move(what), std::move(why)};
}

Result<bool> Uff58Cursor::next() {
  while (!window_.atEnd()) {
    if (!isDelimiter(window_.line())) continue;
    if (window_.atEnd()) break;
    const std::string kind(trimmed(window_.line()));
    ++place_.dataset;
    const std::string type = kind.substr(0, kind.find_first_of(" \t"));
    if (type != "58" && type != "58b" && type != "58B") {
      if (const Status passed = skipToEnd(); !passed) return passed.error();
      continue;
    }
    place_.binary = type != "58";
    if (place_.binary) {
      if (const Status s = parseBinaryHeader(std::string_view(kind).substr(type.size())); !s) return s.error();
    }
    if (const Status s = parseHeader(); !s) return s.error();
    if (const Status s = checkSize(); !s) return s.error();
    place_.position = window_.position();
    begin();
    return true;
  }
  return false;
}

void Uff58Cursor::begin() {
  read_ = 0;
  implausible_ = 0;
  line_.clear();
  lineAt_ = 0;
}

void Uff58Cursor::go(const Place& place) {
  place_ = place;
  window_.seek(place.position);
  begin();
}

Status Uff58Cursor::skipToEnd() {
  while (!window_.atEnd()) {
    if (isDelimiter(window_.line())) return Done{};
  }
  return fail(message("has no end"), message("the file is cut off"));
}

Status Uff58Cursor::parseBinaryHeader(std::string_view fields) {
  std::vector<double> n;
  if (!takeNumbers(fields, 4, n))
    return fail(message("its 58b line is incomplete"), message("byte order, format, lines, bytes"));
  if (n[0] != 1.0 && n[0] != 2.0) return fail(message("its byte order is neither 1 (little) nor 2 (big endian)"));
  if (n[1] != 2.0) return fail(message("its numbers are not IEEE 754"), message("DEC and IBM formats are not read"));
  if (n[2] != 11.0) return fail(message("its header is not 11 lines long"));
  if (!(n[3] >= 0.0 && n[3] < 1e15)) return fail(message("its byte count is not a size"));
  place_.bigEndian = n[0] == 2.0;
  place_.bytes = static_cast<std::uint64_t>(n[3]);
  return Done{};
}

Status Uff58Cursor::parseHeader() {
  std::array<std::string, 11> lines;
  for (std::string& line : lines) {
    if (window_.atEnd()) return fail(message("its header ends early"), message("the file is cut off"));
    line = window_.line();
  }
  Uff58Header set;
  for (std::size_t i = 0; i < set.id.size(); ++i) {
    set.id[i] = std::string(trimmed(std::string_view(lines[i]).substr(0, 80)));
  }
  parseFunctionLine(lines[5], set);
  set.abscissa = parseAxis(lines[7]);
  set.ordinate = parseAxis(lines[8]);
  set.denominator = parseAxis(lines[9]);
  set.z = parseAxis(lines[10]);
  place_.header = std::move(set);
  return parseSizes(lines[6]);
}

Status Uff58Cursor::parseSizes(std::string_view line) {
  Uff58Header& set = place_.header;
  std::vector<double> n;
  if (!takeNumbers(line, 3, n))
    return fail(message("its size line (record 7) is unreadable"), foreign(printable(line)));
  if (n[0] != 2.0 && n[0] != 4.0 && n[0] != 5.0 && n[0] != 6.0) {
    return fail(message("its ordinate type is none of 2, 4, 5, 6"), foreign(printable(line)));
  }
  set.complex = n[0] >= 5.0;
  set.doublePrecision = n[0] == 4.0 || n[0] == 6.0;
  if (!(n[1] >= 1.0 && n[1] < 1e12) || n[1] != std::floor(n[1])) {
    return fail(message("its number of points is not a size"), foreign(printable(line)));
  }
  set.points = static_cast<std::uint64_t>(n[1]);
  set.even = n[2] != 0.0;
  if (takeNumbers(line, 6, n)) set.zValue = n[5];
  if (!set.even) return Done{};
  if (!takeNumbers(line, 5, n))
    return fail(message("its abscissa start and step are missing"), foreign(printable(line)));
  set.start = n[3];
  set.increment = n[4];
  if (!std::isfinite(set.start) || !std::isfinite(set.increment) || set.increment <= 0.0) {
    return fail(message("its abscissa step is not positive"), foreign(printable(line)));
  }
  return Done{};
}

std::size_t Uff58Cursor::numbersPerPoint() const {
  return (place_.header.even ? 1U : 2U) + (place_.header.complex ? 1U : 0U);
}

// An uneven abscissa is single precision by the standard; some writers use the ordinate's precision.
std::size_t Uff58Cursor::abscissaBytes() const {
  const Uff58Header& set = place_.header;
  if (set.even) return 0;
  const std::uint64_t wide = set.doublePrecision ? 8 : 4;
  const std::uint64_t values = set.complex ? 2 : 1;
  return place_.bytes == set.points * (wide + values * wide) ? wide : 4;
}

// Believe only what the bytes that are there can hold.
Status Uff58Cursor::checkSize() const {
  const Uff58Header& set = place_.header;
  const std::uint64_t wide = set.doublePrecision ? 8 : 4;
  const std::uint64_t binaryBytes = abscissaBytes() + (set.complex ? 2 : 1) * wide;
  const std::uint64_t leastBytes = place_.binary ? binaryBytes : 2 * numbersPerPoint();
  if (set.points > window_.left() / leastBytes + 1) {
    return fail(message("announces %1 points, more than the file holds", std::to_string(set.points)),
                message("the file is cut off or its header is wrong"));
  }
  if (!place_.binary) return Done{};
  const std::uint64_t total = set.points * binaryBytes;
  if (place_.bytes != total) {
    return fail(
        message("announces %1 bytes, but its points take %2", std::to_string(place_.bytes), std::to_string(total)),
        message("header inconsistent"));
  }
  if (total > window_.left())
    return fail(message("holds fewer bytes than it announces"), message("the file is cut off"));
  return Done{};
}

Result<Uff58Point> Uff58Cursor::point(const std::array<double, 3>& numbers) const {
  const Uff58Header& set = place_.header;
  for (std::size_t k = 0; k < numbersPerPoint(); ++k) {
    if (!std::isfinite(numbers[k])) return fail(message("point %1 is not a finite number", std::to_string(read_ + 1)));
  }
  const std::size_t first = set.even ? 0 : 1;
  Uff58Point p;
  p.x = set.even ? set.start + static_cast<double>(read_) * set.increment : numbers[0];
  p.y = {numbers[first], set.complex ? numbers[first + 1] : 0.0};
  return p;
}

Result<std::size_t> Uff58Cursor::read(std::span<Uff58Point> out) {
  std::size_t got = 0;
  while (got < out.size() && read_ < place_.header.points) {
    const Status s = place_.binary ? readBinary(out[got]) : readAscii(out[got]);
    if (!s) return s.error();
    ++read_;
    ++got;
  }
  return got;
}

Status Uff58Cursor::readAscii(Uff58Point& out) {
  std::array<double, 3> numbers{};
  for (std::size_t have = 0; have < numbersPerPoint();) {
    std::string_view rest = trimmed(std::string_view(line_).substr(lineAt_));
    if (rest.empty()) {
      if (window_.atEnd()) return endedEarly();
      line_ = window_.line();
      lineAt_ = 0;
      if (isDelimiter(line_)) return endedEarly();
      continue;
    }
    const auto number = takeNumber(rest);
    if (!number)
      return fail(message("'%1' is not a number", printable(rest)), message("at point %1", std::to_string(read_ + 1)));
    lineAt_ = static_cast<std::size_t>(rest.data() - line_.data());
    numbers[have++] = *number;
  }
  const Result<Uff58Point> p = point(numbers);
  if (!p) return p.error();
  out = *p;
  return Done{};
}

Status Uff58Cursor::readBinary(Uff58Point& out) {
  const Uff58Header& set = place_.header;
  const std::size_t wide = set.doublePrecision ? 8 : 4;
  const std::size_t values = set.complex ? 2 : 1;
  const std::size_t abscissa = abscissaBytes();
  const std::string_view bytes = window_.take(abscissa + values * wide);
  if (bytes.size() < abscissa + values * wide) return endedEarly();
  const char* at = bytes.data();
  std::array<double, 3> numbers{};
  std::size_t k = 0;
  if (abscissa > 0) numbers[k++] = decode(at, abscissa, place_.bigEndian);
  at += abscissa;
  for (std::size_t n = 0; n < values; ++n, at += wide) {
    numbers[k] = decode(at, wide, place_.bigEndian);
    if (isImplausible(numbers[k++])) ++implausible_;
  }
  if (implausible_ * 20 > set.points * values) {
    return fail(message("its numbers make no sense in the byte order its header gives"),
                message("little and big endian mixed up"));
  }
  const Result<Uff58Point> p = point(numbers);
  if (!p) return p.error();
  out = *p;
  return Done{};
}

Status Uff58Cursor::finish() {
  if (!trimmed(std::string_view(line_).substr(lineAt_)).empty()) {
    return fail(message("has more numbers than its %1 points", std::to_string(place_.header.points)));
  }
  // Binary data need not end with a line end.
  std::string tail;
  while (tail.empty() && !window_.atEnd()) tail = trimmed(window_.line());
  if (tail != "-1") {
    return fail(message("does not end after its %1 points", std::to_string(place_.header.points)),
                message("the size in its header is wrong, or the file is cut off"));
  }
  return Done{};
}

Error Uff58Cursor::endedEarly() const {
  return fail(message("ends after %1 of %2 points", std::to_string(read_), std::to_string(place_.header.points)),
              message("the file is cut off or its header is wrong"));
}

}  // namespace stillcut::uff
