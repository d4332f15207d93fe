#include "core/formats/text/text_layout.h"

#include <algorithm>
#include <cmath>

#include "core/formats/text/data_rows.h"
#include "core/formats/text/labview_segment.h"
#include "core/formats/text/rate_words.h"
#include "core/formats/text/text_header.h"
#include "core/formats/text/text_times.h"
#include "core/formats/time_stamps.h"
#include "core/units/unit_names.h"

namespace stillcut::record {
namespace {

using Cells = std::vector<std::string_view>;

constexpr std::size_t kBesideRows = 32;  // lines below the first row in which a header may stand beside the numbers
constexpr double kSameRate = 1e-6;       // of each other: one rate, printed twice

// As many labels as there are signals are theirs in order; else each stands over its column, behind that of the times.
void takeUnitLabels(const Cells& cells, TextLayout& layout) {
  std::vector<std::size_t> signals, labels;
  for (std::size_t k = 0; k < layout.columns.size(); ++k) {
    const TextColumn& column = layout.columns[k];
    if (!column.empty && column.name != "X_Value" && column.name != "Comment") signals.push_back(k);
  }
  for (std::size_t k = 1; k < cells.size(); ++k) {
    if (!cells[k].empty()) labels.push_back(k);
  }
  const bool inOrder = labels.size() == signals.size();
  const std::size_t shift = !layout.columns.empty() && layout.columns[0].name == "X_Value" ? 1 : 0;
  for (std::size_t n = 0; n < labels.size(); ++n) {
    const std::size_t column = inOrder ? signals[n] : labels[n] - 1 + shift;
    if (column < layout.columns.size()) layout.columns[column].unit = std::string(cells[labels[n]]);
  }
}

// One step of all channels.
Status takeSteps(const Cells& cells, TextLayout& layout, const std::string& where) {
  double first = 0.0;
  for (std::size_t k = 1; k < cells.size(); ++k) {
    if (cells[k].empty()) continue;
    const std::optional<double> step = parseNumber(cells[k], layout.cells.decimalComma);
    if (!step || !(*step > 0.0) || !std::isfinite(*step)) {
      return Error{where, message("Delta_X holds '%1'", cells[k]), message("a time step above zero was expected")};
    }
    if (first > 0.0 && std::abs(*step - first) > kSameRate * first) {
      return Error{where, message("its channels have several rates"),
                   message("export those of each rate as a file of their own")};
    }
    first = *step;
  }
  if (first > 0.0) layout.rateFromHeader = Hertz(1.0 / first);
  return Done{};
}

// Key, then one value per channel, up to the numbers.
Status readLabViewHeader(std::span<const std::string> lines, std::size_t firstData, TextLayout& layout,
                         const std::string& where) {
  layout.kind = "LabVIEW measurement text";
  layout.timeUnitAssumed = false;  // X_Value is in seconds
  Cells cells;
  LabViewSegment segment(layout.cells);
  for (std::size_t i = 0; i < firstData; ++i) {
    segment.take(lines[i]);
    splitCells(lines[i], layout.cells.delimiter, cells);
    if (cells.size() < 2) continue;
    const std::string lineWhere = where + ":" + std::to_string(i + 1);
    if (cells[0] == "Y_Unit_Label") takeUnitLabels(cells, layout);
    if (cells[0] == "Delta_X") {
      if (const Status s = takeSteps(cells, layout, lineWhere); !s) return s.error();
    }
  }
  layout.segmentStart = segment.start();
  return Done{};
}

void findEmptyColumns(std::span<const std::string> lines, const DataRows& data, TextLayout& layout) {
  for (TextColumn& column : layout.columns) column.empty = true;
  forEachRow(lines, data, [&layout](const Cells& cells) {
    for (std::size_t k = 0; k < std::min(cells.size(), layout.columns.size()); ++k) {
      if (!cells[k].empty()) layout.columns[k].empty = false;
    }
  });
  layout.minCells = layout.maxCells = static_cast<int>(layout.columns.size());
  while (layout.minCells > 1 && layout.columns[static_cast<std::size_t>(layout.minCells - 1)].empty) --layout.minCells;
}

// Several numbers that differ tell nothing.
void readRate(std::span<const std::string> header, TextLayout& layout) {
  const StatedRates stated = ratesInLines(header, layout.cells);
  const std::vector<double>& rates = stated.hertz;
  layout.unclearRate = stated.unclear;
  const auto [least, most] = std::minmax_element(rates.begin(), rates.end());
  if (!rates.empty() && *most - *least <= kSameRate * *most) layout.rateFromHeader = Hertz(rates.front());
}

}  // namespace

namespace {

// The line in the middle, where rows would be, and its first cell that is no number.
Error noRows(std::span<const std::string> lines, const std::string& where) {
  const std::size_t middle = lines.size() / 2;
  const auto from = lines.begin() + static_cast<std::ptrdiff_t>(middle);
  const auto filled = std::find_if(from, lines.end(), [](const std::string& line) { return !trimmed(line).empty(); });
  const std::string none;
  const std::string& line = filled == lines.end() ? none : *filled;
  std::string cell;
  for (const char delimiter : {'\t', ';', ',', ' '}) {
    Cells cells;
    splitCells(line, delimiter, cells);
    if (cells.size() < 2 && delimiter != ' ') continue;
    const auto word = std::find_if(cells.begin(), cells.end(), [](std::string_view c) {
      return !c.empty() && !parseNumber(c, false) && !parseNumber(c, true) && !parseTimeStamp(c);
    });
    if (word != cells.end()) cell = shownText(*word);
    break;
  }
  const Message cause = message("no rows of numbers found in its first %1 lines", std::to_string(lines.size()));
  if (cell.empty()) return Error{where, cause, message("is this a recording?")};
  return Error{where, cause,
               message("in line %1, '%2', '%3' is no number; is this a recording?",
                       std::to_string(filled - lines.begin() + 1), shownText(line), cell)};
}

// Names or units that the rows themselves hold.
void takeWordsOfForm(TextLayout& layout) {
  for (std::size_t k = 0; k < std::min(layout.columns.size(), layout.form.words.size()); ++k) {
    TextColumn& column = layout.columns[k];
    std::string& told = layout.form.kind == LineForm::Kind::Labels ? column.name : column.unit;
    if (told.empty()) told = layout.form.words[k];
  }
}

// Without what LabVIEW writes above a further segment, whose keys stand in the columns of the numbers.
std::span<const std::string> firstSegment(std::span<const std::string> lines, const DataRows& data) {
  const std::string key = std::string("Channels") + data.format.delimiter;
  const auto further = std::find_if(lines.begin() + static_cast<std::ptrdiff_t>(data.clean), lines.end(),
                                    [&key](const std::string& line) { return line.starts_with(key); });
  return lines.first(static_cast<std::size_t>(further - lines.begin()));
}

Result<TextLayout> layoutOf(std::span<const std::string> all, const DataRows& data, const LineForm& form,
                            const std::string& where) {
  const std::span<const std::string> lines = firstSegment(all, data);
  TextLayout layout;
  layout.form = form;
  layout.cells = data.format;
  layout.firstDataLine = static_cast<std::int64_t>(data.first) + 1;
  layout.columns.resize(data.cells);
  findEmptyColumns(lines, data, layout);
  if (const Status s = checkUnclearNumbers(lines, data, where); !s) return s.error();
  if (const Status s = readTextHeader(lines, data.first, layout, where); !s) return s.error();
  takeWordsOfForm(layout);
  findTimeColumn(lines, data, layout);
  // Header beside the first rows counts as header too.
  readRate(lines.first(std::min(data.first + kBesideRows, lines.size())), layout);
  if (trimmed(lines[0]).starts_with("DynoWare")) layout.kind = "DynoWare text";
  if (trimmed(lines[0]).starts_with("LabVIEW Measurement")) {
    if (const Status s = readLabViewHeader(lines, data.first, layout, where); !s) return s.error();
  }
  return layout;
}

}  // namespace

Result<TextLayout> detectTextLayout(std::span<const std::string> lines, bool complete, const std::string& where) {
  if (lines.empty()) return Error{where, message("the file is empty")};
  const DataRows data = findDataRows(lines, complete);
  if (data.found) return layoutOf(lines, data, {}, where);
  if (const std::optional<LineForm> form = findLineForm(lines)) {
    std::vector<std::string> formed;
    for (std::string_view line : lines) {
      std::string store;
      form->apply(line, store);
      formed.emplace_back(line);
    }
    const DataRows rows = findDataRows(formed, complete);
    if (rows.found) return layoutOf(formed, rows, *form, where);
  }
  if (const std::string cell = unclearPoint(lines); !cell.empty()) {
    return Error{where, message("it is not clear whether '%1' has a decimal point or thousands set apart", cell),
                 message("export with decimal points and without signs between thousands")};
  }
  return noRows(lines, where);
}

}  // namespace stillcut::record
