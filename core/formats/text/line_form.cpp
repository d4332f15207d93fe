#include "core/formats/text/line_form.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "core/formats/text/text_cells.h"
#include "core/formats/time_stamps.h"
#include "core/units/unit_names.h"

namespace stillcut::record {
namespace {

constexpr std::string_view kArrow = " -> ";

// The words of a line in their order, and what is left without them; nothing: the line has not this form.
struct Parted {
  std::vector<std::string> words;
  std::string rest;
};

std::optional<Parted> partArrow(std::string_view line) {
  const std::size_t at = line.find(kArrow);
  if (at == std::string_view::npos || !parseTimeStamp(trimmed(line.substr(0, at)))) return std::nullopt;
  const std::string_view rest = line.substr(at + kArrow.size());
  char delimiter = ' ';
  for (const char sign : {',', '\t', ';'}) {
    if (rest.find(sign) != std::string_view::npos) delimiter = sign;
  }
  return Parted{{}, std::string(trimmed(line.substr(0, at))) + delimiter + std::string(rest)};
}

// A label begins with a letter; ':' or '=' parts it from its number.
std::optional<Parted> partLabels(std::string_view line) {
  constexpr std::string_view kBetween = " ,;\t";
  Parted parted;
  for (std::size_t at = line.find_first_not_of(kBetween); at != std::string_view::npos;) {
    const std::size_t sign = line.find_first_of(":=", at);
    if (sign == std::string_view::npos || std::isalpha(static_cast<unsigned char>(line[at])) == 0) return std::nullopt;
    const std::size_t begin = line.find_first_not_of(' ', sign + 1);
    if (begin == std::string_view::npos) return std::nullopt;
    const std::size_t end = line.find_first_of(kBetween, begin);
    const std::string_view number = line.substr(begin, end - begin);
    if (!parseNumber(number, false)) return std::nullopt;
    parted.words.emplace_back(trimmed(line.substr(at, sign - at)));
    parted.rest += (parted.rest.empty() ? "" : " ") + std::string(number);
    at = line.find_first_not_of(kBetween, end);
  }
  return parted.words.empty() ? std::nullopt : std::optional(std::move(parted));
}

std::optional<Parted> partUnits(std::string_view line, char delimiter) {
  std::vector<std::string_view> cells;
  splitCells(line, delimiter, cells);
  Parted parted;
  bool any = false;
  for (const std::string_view cell : cells) {
    std::size_t end = cell.find_first_not_of("+-.0123456789eE");
    if (end == std::string_view::npos) end = cell.size();
    const std::string_view unit = trimmed(cell.substr(end));
    if (!parseNumber(trimmed(cell.substr(0, end)), false) || (!unit.empty() && !unitFromText(unit)))
      return std::nullopt;
    any = any || !unit.empty();
    parted.words.emplace_back(unit);
    if (!parted.rest.empty()) parted.rest += delimiter;
    parted.rest += trimmed(cell.substr(0, end));
  }
  return any ? std::optional(std::move(parted)) : std::nullopt;
}

std::optional<Parted> part(std::string_view line, const LineForm& form) {
  switch (form.kind) {
    case LineForm::Kind::Arrow:
      return partArrow(line);
    case LineForm::Kind::Labels:
      return partLabels(line);
    case LineForm::Kind::Units:
      return partUnits(line, form.delimiter);
    case LineForm::Kind::Plain:
      break;
  }
  return std::nullopt;
}

}  // namespace

void LineForm::apply(std::string_view& line, std::string& store) const {
  if (kind == Kind::Plain) return;
  std::optional<Parted> parted = part(line, *this);
  if (!parted || parted->words != words) return;
  store = std::move(parted->rest);
  line = store;
}

std::optional<LineForm> findLineForm(std::span<const std::string> lines) {
  using Kind = LineForm::Kind;
  for (LineForm form : {LineForm{Kind::Arrow, {}, ' '}, LineForm{Kind::Labels, {}, ' '}, LineForm{Kind::Units, {}, ';'},
                        LineForm{Kind::Units, {}, '\t'}, LineForm{Kind::Units, {}, ','}}) {
    std::size_t rows = 0;
    for (const std::string& line : lines) {
      std::optional<Parted> parted = part(line, form);
      if (!parted || (rows > 0 && parted->words != form.words)) continue;
      if (++rows == 1) form.words = std::move(parted->words);
    }
    constexpr std::size_t kFew = 3;
    if (rows >= kFew && 2 * rows > lines.size()) return form;
  }
  return std::nullopt;
}

}  // namespace stillcut::record
