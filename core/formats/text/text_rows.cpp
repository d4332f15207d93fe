#include "core/formats/text/text_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/formats/text/labview_segment.h"
#include "core/formats/text/rate_words.h"
#include "core/units/unit_names.h"

namespace stillcut::record {
namespace {

constexpr double kLargest = std::numeric_limits<float>::max();

Message evenly() {
  return message("give --rate HZ to read the rows as evenly spaced");
}

}  // namespace

TextRows::TextRows(std::string path, const TextLayout& layout, std::vector<int> columns, bool timed)
    : path_(std::move(path)),
      layout_(layout),
      columns_(std::move(columns)),
      timed_(timed),
      end_(std::numeric_limits<std::int64_t>::max()) {}

Status TextRows::rewind() {
  lines_ = std::make_unique<LineReader>(path_);
  if (const Status s = lines_->open(); !s) return s.error();
  std::string_view line;
  for (std::int64_t i = 1; i < layout_.firstDataLine; ++i) {
    const Result<bool> more = lines_->next(line);
    if (!more) return more.error();
  }
  times_.emplace(layout_);
  row_ = {std::vector<float>(columns_.size(), 0.0F), 0.0, 0};
  counts_ = {};
  counts_.badCells.assign(columns_.size(), 0);
  counts_.filledTo.assign(columns_.size(), 0);
  badSince_ = goodTo_ = odd_ = oddLine_ = lostBefore_ = betweenSegments_ = 0;
  firstOdd_.reset();
  oddCount_ = oddNumbers_ = segment_ = false;
  oddRates_.clear();
  return Done{};
}

// The next line with something in it; comments between the rows are passed over where times tell what is missing, and
// so is the header that LabVIEW writes above each further segment.
Result<bool> TextRows::nextLine(std::string_view& line) {
  while (true) {
    const Result<bool> more = lines_->next(line);
    if (!more || !*more) return more;
    if (isSkippedLine(line) || (timed_ && line.starts_with('#'))) continue;
    if (line.starts_with("***End_of_Header***")) return anotherSegment();
    layout_.form.apply(line, formed_);
    const bool header = line.starts_with("Channels") && line.size() > 8 && line[8] == layout_.cells.delimiter;
    if (!header) return true;
    if (const Status s = passSegmentHeader(line); !s) return s.error();
  }
}

Error TextRows::anotherSegment() const {
  return {lines_->where(), message("a second segment of the measurement begins"),
          message("save each segment as a file of its own")};
}

// Up to the names of its columns, which are those of the first segment where it has as many channels.
Status TextRows::passSegmentHeader(std::string_view& line) {
  splitCells(line, layout_.cells.delimiter, cells_);
  const auto filled =
      std::count_if(layout_.columns.begin(), layout_.columns.end(), [](const TextColumn& c) { return !c.empty; });
  const auto channels = filled - (layout_.timeColumn >= 0 ? 1 : 0);
  if (cells_.size() < 2 || cells_[1] != std::to_string(channels)) return anotherSegment();
  segment_ = true;
  LabViewSegment segment(layout_.cells);
  constexpr int kLongestHeader = 100;  // lines
  for (int i = 0; i < kLongestHeader; ++i) {
    const bool end = line.starts_with("***End_of_Header***");
    segment.take(line);
    const Result<bool> more = lines_->next(line);
    if (!more) return more.error();
    if (!*more || end) return timed_ ? Status(Done{}) : countBetween(segment.start());
  }
  return anotherSegment();
}

// Without times of the rows their headers tell what is missing between two segments; without those nobody can.
Status TextRows::countBetween(std::optional<double> start) {
  constexpr double kEarly = 0.05;  // [s] by which a clock may begin a segment too soon
  constexpr double kMost = 1e12;
  if (!start || !layout_.segmentStart || !layout_.rateFromHeader) return anotherSegment();
  const double rate = layout_.rateFromHeader->value;
  const double lost = (*start - *layout_.segmentStart) * rate - static_cast<double>(counts_.all() + betweenSegments_);
  if (!(lost >= -kEarly * rate) || lost > kMost) return anotherSegment();
  lostBefore_ = std::max<std::int64_t>(std::llround(lost), 0);
  betweenSegments_ += lostBefore_;
  return Done{};
}

Result<bool> TextRows::next() {
  std::string_view line;
  while (counts_.all() < end_) {
    const Result<bool> more = nextLine(line);
    if (!more) return more.error();
    if (!*more) {
      if (const Status s = settleEnd(); !s) return s.error();
      return false;
    }
    splitCells(line, layout_.cells.delimiter, cells_);
    const double before = row_.time;
    const Kind kind = parse(line);
    if (kind == Kind::Odd) {
      setOddAside(line);
      continue;
    }
    if (const Status s = takeOddLines(); !s) return s.error();
    if (kind == Kind::Bad) {
      ++counts_.bad;
      ++badSince_;
      row_.time = before;
      continue;
    }
    row_.lost = badSince_ + lostBefore_;
    lostBefore_ = 0;
    if (timed_ && step_ > 0.0 && counts_.rows > 0) {
      const Result<std::int64_t> lost = missingBetween(before, row_.time);
      if (!lost) return lost.error();
      row_.lost = *lost;
    }
    if (counts_.rows == 0) row_.lost = 0;  // nothing is missing before the first
    badSince_ = 0;
    segment_ = false;
    ++counts_.rows;
    goodTo_ = counts_.all();
    return true;
  }
  return false;
}

const TextRowCounts& TextRows::counts() {
  for (std::int64_t& filled : counts_.filledTo) filled = std::max(filled, goodTo_);
  return counts_;
}

// Every channel's cell as a number; false: one is none.
bool TextRows::takeNumbers() {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const auto value = parseNumber(cells_[static_cast<std::size_t>(columns_[i])], layout_.cells.decimalComma);
    if (!value || !(std::abs(*value) <= kLargest)) return false;
    row_.values[i] = static_cast<float>(*value);
  }
  return true;
}

bool TextRows::holdsNumber() const {
  return std::any_of(cells_.begin(), cells_.end(), [this](std::string_view cell) {
    return parseNumber(cell, layout_.cells.decimalComma).has_value();
  });
}

void TextRows::countBadCells() {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const std::string_view cell = cells_[static_cast<std::size_t>(columns_[i])];
    if (!cell.empty()) counts_.filledTo[i] = counts_.all() + 1;
    const auto value = parseNumber(cell, layout_.cells.decimalComma);
    if (value && std::abs(*value) <= kLargest) continue;
    ++counts_.badCells[i];
    remember(columns_[i], cell);
  }
}

void TextRows::remember(int column, std::string_view cell) {
  if (counts_.firstBad) return;
  const std::string& name = layout_.columns[static_cast<std::size_t>(column)].name;
  counts_.firstBad = Error{lines_->where(),
                           message("column %1 holds %2", name.empty() ? std::to_string(column) : "'" + name + "'",
                                   "'" + shownText(cell) + "'"),
                           message("a finite number was expected")};
}

// A line of words, or of another number of columns, is odd: below the last row it is a footer.
TextRows::Kind TextRows::parse(std::string_view line) {
  const auto count = static_cast<int>(cells_.size());
  if (count < layout_.minCells || count > layout_.maxCells) return Kind::Odd;
  const bool good = takeNumbers();
  if (!good) {
    // "Sampling rate,10000" and what stands below it.
    if (!holdsNumber() || odd_ > 0 || !ratesInLine(line, layout_.cells).hertz.empty()) return Kind::Odd;
    countBadCells();
  }
  if (!timed_) return good ? Kind::Good : Kind::Bad;
  const std::string_view cell = cells_[static_cast<std::size_t>(layout_.timeColumn)];
  if (layout_.dateColumn >= 0 && counts_.rows == 0)
    times_->beginOn(cells_[static_cast<std::size_t>(layout_.dateColumn)]);
  const std::optional<double> time = times_->seconds(cell);
  if (!time) {
    remember(layout_.timeColumn, cell);
    if (good) goodTo_ = counts_.all() + 1;  // no column ends here
    return Kind::Bad;
  }
  row_.time = *time;
  return good ? Kind::Good : Kind::Bad;
}

void TextRows::setOddAside(std::string_view line) {
  const auto count = static_cast<int>(cells_.size());
  const bool wrongCount = count < layout_.minCells || count > layout_.maxCells;
  if (!firstOdd_) {
    const Message cause = wrongCount ? message("has %1 columns where %2 were expected", std::to_string(count),
                                               std::to_string(layout_.minCells))
                                     : message("'%1' is no row of numbers", shownText(line));
    firstOdd_ = Error{lines_->where(), cause, message("a damaged or truncated file")};
    counts_.footer = Error{lines_->where(), message("'%1'", shownText(line))};
  }
  oddCount_ = oddCount_ || wrongCount;
  oddNumbers_ = oddNumbers_ || std::all_of(cells_.begin(), cells_.end(), [this](std::string_view cell) {
                  return cell.empty() || parseNumber(cell, layout_.cells.decimalComma).has_value();
                });
  const std::vector<double> rates = ratesInLine(line, layout_.cells).hertz;
  oddRates_.insert(oddRates_.end(), rates.begin(), rates.end());
  oddLine_ = lines_->number();
  ++odd_;
}

// A row follows: what was odd is no footer. With times it is missing rows, however many there were; without them a
// line of another width may stand for any number of rows.
Status TextRows::takeOddLines() {
  if (odd_ == 0) return Done{};
  if (oddCount_ && !timed_) return *firstOdd_;
  if (!counts_.firstBad) counts_.firstBad = firstOdd_;
  counts_.bad += odd_;
  badSince_ += odd_;
  odd_ = 0;
  firstOdd_.reset();
  counts_.footer.reset();
  oddCount_ = oddNumbers_ = false;
  oddRates_.clear();
  return Done{};
}

Status TextRows::settleEnd() {
  if (odd_ == 0) return Done{};
  const bool cut = odd_ == 1 && oddCount_ && static_cast<int>(cells_.size()) < layout_.minCells;
  if (oddNumbers_ && !cut) return *firstOdd_;
  if (oddNumbers_) {
    counts_.cutLine = oddLine_;
    counts_.footer.reset();
  }
  counts_.footerRates = oddRates_;
  return Done{};
}

Result<std::int64_t> TextRows::missingBetween(double before, double after) const {
  if (segment_ && !(after > before)) return anotherSegment();
  if (!(after > before)) {
    return Error{lines_->where(), after < before ? message("the time runs backwards") : message("the time repeats"),
                 evenly()};
  }
  constexpr double kEarliest = 0.5;
  constexpr double kGapFrom = 1.5;
  constexpr double kLongest = 1e12;
  const double steps = (after - before) / step_;
  if (steps < kEarliest || steps > kLongest)
    return Error{lines_->where(), message("the time steps are uneven"), evenly()};
  return steps < kGapFrom ? 0 : std::llround(steps) - 1;
}

}  // namespace stillcut::record
