#include "core/formats/text/rate_words.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>

#include "core/units/unit_names.h"

namespace stillcut::record {
namespace {

constexpr std::string_view kBlank = " \t";

struct Key {
  std::string_view words;  // small letters, blanks for all that parts words
  bool step;               // the time from one sample to the next, not the rate
  bool first = false;      // only where its cell begins: "rate" behind "feed" is another one
  bool unit = false;       // only with a unit of a rate or a time: alone the word says too little
};

constexpr auto kKeys = std::to_array<Key>({
    {"sample rate", false},
    {"sampling rate", false},
    {"samplerate", false},
    {"samplingrate", false},
    {"sample frequency", false},
    {"sampling frequency", false},
    {"sample freq", false},
    {"sampling freq", false},
    {"samples per second", false},
    {"scan rate", false, true},
    {"rate hz", false, true},
    {"rate", false, true},
    {"fs", false, true},
    {"sps", false, true},
    {"sampling", false, true, true},
    {"odr", false, true},  // output data rate, of a sensor on a chip
    {"fr\xC3\xA9quence d'\xC3\xA9"
     "chantillonnage",
     false},
    {"frequence d'echantillonnage", false},
    {"abtastrate", false},
    {"abtastfrequenz", false},
    {"\xE9\x87\x87\xE6\xA0\xB7\xE7\x8E\x87", false},              // sampling rate
    {"\xE9\x87\x87\xE6\xA0\xB7\xE9\xA2\x91\xE7\x8E\x87", false},  // sampling frequency
    {"sample interval", true},
    {"sampling interval", true},
    {"sample period", true},
    {"sampling period", true},
    {"time interval", true},
    {"time step", true},
    {"time increment", true},
    {"increment", true, true},
    {"x increment", true},
    {"xincrement", true},
    {"xincr", true},
    {"xinc", true},
    {"dx", true, true},
    {"interval", true, true},
    {"intervall", true, true},
    {"clock", true, true, true},
    {"tinc", true},
    {"delta x", true},
    {"delta t", true},
    {"deltat", true},
    {"dt", true, true},
    {"abtastintervall", true},
    {"abtastzeit", true},
    {"\xE9\x87\x87\xE6\xA0\xB7\xE9\x97\xB4\xE9\x9A\x94", true},  // sampling interval
});

bool isWordSign(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 0x80;
}

// The line in small letters, '_' and '-' between words as blanks; as long as the line.
std::string plainLine(std::string_view line) {
  std::string plain(line);
  for (char& c : plain) {
    c = c == '_' || c == '-' ? ' ' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return plain;
}

struct Found {
  std::size_t end = 0;
  bool step = false;
  bool unit = false;  // it must have one
};

bool beginsItsCell(std::string_view plain, std::size_t at) {
  const std::size_t before = plain.substr(0, at).find_last_not_of(" \"#%/");
  return before == std::string_view::npos || std::string_view(",;|\t").find(plain[before]) != std::string_view::npos;
}

// The longest key that begins at `at` as whole words.
std::optional<Found> keyAt(std::string_view plain, std::size_t at) {
  if (at > 0 && isWordSign(plain[at - 1])) return std::nullopt;
  std::optional<Found> best;
  for (const Key& key : kKeys) {
    if (plain.compare(at, key.words.size(), key.words) != 0) continue;
    const std::size_t end = at + key.words.size();
    if (end < plain.size() && isWordSign(plain[end])) continue;
    if (key.first && !beginsItsCell(plain, at)) continue;
    if (!best || end > best->end) best = Found{end, key.step, key.unit};
  }
  return best;
}

// "kHz", "S/s", "ms": what one of it is in Hz or in seconds.
std::optional<double> unitFactor(std::string_view unit, bool step) {
  if (unit.empty()) return 1.0;
  if (step) {
    std::optional<UnitMeaning> meaning = unitFromText(unit);
    if (!meaning && unit == "uS") meaning = unitFromText("us");  // of oscilloscopes
    return meaning && meaning->kind == UnitKind::Time ? std::optional<double>(meaning->toSi) : std::nullopt;
  }
  const std::string small = plainLine(unit);
  for (const std::string_view one : {"hz", "s/s", "sa/s", "sps", "1/s", "samples/s", "samples/sec", "samples/second"}) {
    if (small == one) return 1.0;
    if (small == "k" + std::string(one)) return 1e3;
    if (one == "s/s" && small == "s/min") return 1.0 / 60.0;
    if (unit.front() == 'M' && small == "m" + std::string(one)) return 1e6;
  }
  return std::nullopt;
}

bool skipOne(std::string_view& rest, std::string_view among) {
  if (rest.empty() || among.find(rest.front()) == std::string_view::npos) return false;
  rest.remove_prefix(1);
  return true;
}

void skipAll(std::string_view& rest, std::string_view among) {
  rest.remove_prefix(std::min(rest.find_first_not_of(among), rest.size()));
}

// "[Hz]" or "(s)" behind the key.
std::string_view takeBracket(std::string_view& rest) {
  skipAll(rest, kBlank);
  if (rest.empty() || (rest.front() != '[' && rest.front() != '(')) return {};
  const std::size_t close = rest.find(rest.front() == '[' ? ']' : ')');
  if (close == std::string_view::npos) return {};
  const std::string_view unit = rest.substr(1, close - 1);
  rest.remove_prefix(close + 1);
  return unit;
}

// The word behind a number. In a cell of its own it may be something else: then the number has no unit.
std::string_view takeUnit(std::string_view rest, bool step) {
  skipAll(rest, " ");  // a tab may part cells
  const bool apart = skipOne(rest, "\",;|\t");
  skipAll(rest, " \t\",;|[(");
  std::string_view unit = rest.substr(0, rest.find_first_of(" \t\",;|])}"));
  while (unit.ends_with('.')) unit.remove_suffix(1);
  return apart && !unitFactor(unit, step) ? std::string_view() : unit;
}

struct Value {
  std::optional<double> number;
  std::string unclear;  // as it stands, where it may be a fraction or have thousands set apart
};

// "10,000 Hz" in a table whose columns commas part: no decimal sign, and with its unit no two cells.
bool isThousands(std::string_view token, std::string_view rest, const CellFormat& cells) {
  const bool unit = !rest.empty() && rest.find_first_not_of(kBlank) != std::string_view::npos &&
                    std::string_view("\",;|\t").find(rest.front()) == std::string_view::npos &&
                    unitFactor(takeUnit(rest, false), false).has_value();
  return cells.delimiter == ',' && !cells.decimalComma && isGrouped(token, ',') && unit;
}

// The number `rest` begins with. "25,600" may be a number of two parts, two numbers, or thousands set apart.
Value takeValue(std::string_view& rest, const CellFormat& cells) {
  std::size_t end = 0;
  while (end < rest.size()) {
    const char c = rest[end];
    const bool exponent = (c == 'e' || c == 'E') && end > 0;
    const bool sign = (c == '-' || c == '+') && (end == 0 || rest[end - 1] == 'e' || rest[end - 1] == 'E');
    if (std::isdigit(static_cast<unsigned char>(c)) == 0 && c != '.' && c != ',' && !exponent && !sign) break;
    ++end;
  }
  std::string_view token = rest.substr(0, end);
  while (token.ends_with(',') || token.ends_with('.')) token.remove_suffix(1);
  rest.remove_prefix(token.size());
  if (isThousands(token, rest, cells)) {
    std::string plain(token);
    plain.erase(std::remove(plain.begin(), plain.end(), ','), plain.end());
    return {parseNumber(plain, false), ""};
  }
  const bool unclear = isGrouped(token, ',') || (cells.decimalComma && isGrouped(token, '.'));
  if (rest.starts_with('.')) rest.remove_prefix(1);
  if (unclear) return {std::nullopt, std::string(token)};
  if (token.find(',') == std::string_view::npos) return {parseNumber(token, false), ""};
  return {cells.decimalComma ? parseNumber(token, true) : std::nullopt, ""};
}

// What follows a key: a unit in brackets, a sign, one more word with a colon ("Analog:"), the number, its unit.
void takeRateBehind(std::string_view rest, const Found& key, const CellFormat& cells, StatedRates& rates) {
  if (rest.starts_with("\":")) rest.remove_prefix(1);  // "rate": 10000
  std::string_view unit = takeBracket(rest);
  skipAll(rest, kBlank);
  if (skipOne(rest, ":=,;|\t") || rest.starts_with('"')) {
    skipAll(rest, " \t\",;|");
    const std::size_t colon = rest.find(':');
    const std::size_t number = rest.find_first_of("0123456789");
    if (colon != std::string_view::npos && number == colon + 1) rest.remove_prefix(number);
  }
  const Value value = takeValue(rest, cells);
  if (unit.empty()) unit = takeUnit(rest, key.step);
  const std::optional<double> factor = unitFactor(unit, key.step);
  if (!factor || (key.unit && unit.empty())) return;
  if (!value.unclear.empty()) rates.unclear = value.unclear;
  if (!value.number || !(*value.number > 0.0) || !std::isfinite(*value.number)) return;
  rates.hertz.push_back(key.step ? 1.0 / (*value.number * *factor) : *value.number * *factor);
}

void takeRatesInLine(std::string_view line, const CellFormat& cells, StatedRates& rates) {
  const std::string plain = plainLine(line);
  for (std::size_t at = 0; at < plain.size(); ++at) {
    const std::optional<Found> key = keyAt(plain, at);
    if (!key) continue;
    takeRateBehind(line.substr(key->end), *key, cells, rates);
    at = key->end - 1;
  }
}

}  // namespace

StatedRates ratesInLine(std::string_view line, const CellFormat& cells) {
  StatedRates rates;
  takeRatesInLine(line, cells, rates);
  return rates;
}

StatedRates ratesInLines(std::span<const std::string> lines, const CellFormat& cells) {
  StatedRates rates;
  std::vector<std::string_view> names;
  std::vector<std::string_view> below;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::size_t before = rates.hertz.size();
    takeRatesInLine(lines[i], cells, rates);
    if (rates.hertz.size() > before || i + 1 == lines.size()) continue;
    splitCells(lines[i], cells.delimiter, names);
    splitCells(lines[i + 1], cells.delimiter, below);
    for (std::size_t k = 1; k < std::min(names.size(), below.size()); ++k) {
      const std::string plain = plainLine(names[k]);
      const std::optional<Found> key = plain.empty() ? std::nullopt : keyAt(plain, 0);
      if (key && key->end == plain.size()) takeRateBehind("=" + std::string(below[k]), *key, cells, rates);
    }
  }
  return rates;
}

}  // namespace stillcut::record
