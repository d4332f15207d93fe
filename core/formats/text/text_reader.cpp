#include "core/formats/text/text_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/formats/utf_text.h"

namespace stillcut::record {
namespace {

constexpr std::size_t kSniffLines = 400;
constexpr std::size_t kStepSample = 1000;  // rows from which the typical time step is taken
constexpr int kMostColumns = 256;
Message evenly() {
  return message("give --rate HZ to read the rows as evenly spaced");
}

Result<std::vector<std::string>> firstLines(const std::string& path, bool& complete) {
  LineReader reader(path);
  if (const Status s = reader.open(); !s) return s.error();
  std::vector<std::string> lines;
  std::string_view line;
  complete = false;
  while (lines.size() < kSniffLines) {
    const Result<bool> more = reader.next(line);
    if (!more) return more.error();
    if (!*more) {
      complete = true;
      break;
    }
    lines.push_back(utf8Of(line));
  }
  return lines;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// A rate that no clock could tell from a whole number over this recording is that whole number.
double snapped(double rate, double seconds) {
  constexpr double kFrames = 0.05;
  const double whole = std::round(rate);
  return whole > 0.0 && std::abs(rate - whole) * seconds < kFrames ? whole : rate;
}

std::string quoted(std::string_view cell) {
  constexpr std::size_t kShown = 40;
  return "'" + std::string(cell.substr(0, kShown)) + "'";
}

}  // namespace

TextReader::TextReader(std::string path, TextLayout layout, TextChannels channels)
    : path_(std::move(path)), layout_(std::move(layout)), channels_(std::move(channels)) {}

Result<std::unique_ptr<RecordingReader>> TextReader::open(const std::string& path, const ReadOptions& options) {
  bool complete = false;
  const Result<std::vector<std::string>> lines = firstLines(path, complete);
  if (!lines) return lines.error();
  Result<TextLayout> layout = detectTextLayout(lines.value(), complete, path);
  if (!layout) return layout.error();
  if (layout->columns.size() > kMostColumns) return Error{path, message("has more than 256 columns")};
  Result<TextChannels> channels = chooseTextChannels(*layout, options, path);
  if (!channels) return channels.error();
  std::unique_ptr<TextReader> reader(new TextReader(path, std::move(*layout), std::move(*channels)));
  if (const Status s = reader->scan(options); !s) return s.error();
  return std::unique_ptr<RecordingReader>(std::move(reader));
}

Status TextReader::rewind() {
  lines_ = std::make_unique<LineReader>(path_);
  if (const Status s = lines_->open(); !s) return s.error();
  std::string_view line;
  for (std::int64_t i = 1; i < layout_.firstDataLine; ++i) {
    const Result<bool> more = lines_->next(line);
    if (!more) return more.error();
  }
  row_.values.assign(channels_.columns.size(), 0.0F);
  rows_ = 0;
  return Done{};
}

Result<bool> TextReader::nextRow() {
  std::string_view line;
  do {
    const Result<bool> more = lines_->next(line);
    if (!more) return more.error();
    if (!*more) return false;
  } while (isSkippedLine(line));
  if (line.starts_with("***End_of_Header***") || line.starts_with("Channels\t")) {
    return Error{lines_->where(), message("a second segment of the measurement begins"),
                 message("save each segment as a file of its own")};
  }
  splitCells(line, layout_.cells.delimiter, cells_);
  const double before = row_.time;
  if (const Status s = parseRow(); !s) return s.error();
  row_.lost = 0;
  if (timed_ && step_ > 0.0 && rows_ > 0) {
    const Result<std::int64_t> lost = missingBetween(before, row_.time);
    if (!lost) return lost.error();
    row_.lost = *lost;
  }
  ++rows_;
  return true;
}

Result<double> TextReader::numberIn(int column) const {
  const std::string_view cell = cells_[static_cast<std::size_t>(column)];
  const std::optional<double> value = parseNumber(cell, layout_.cells.decimalComma);
  const std::string& name = layout_.columns[static_cast<std::size_t>(column)].name;
  const Message what =
      message("column %1 holds %2", name.empty() ? std::to_string(column) : "'" + name + "'", quoted(cell));
  if (!value || !std::isfinite(*value)) return Error{lines_->where(), what, message("a finite number was expected")};
  constexpr double kLargest = std::numeric_limits<float>::max();
  if (std::abs(*value) > kLargest) return Error{lines_->where(), what, message("too large for a sample")};
  return *value;
}

Status TextReader::parseRow() {
  const auto count = static_cast<int>(cells_.size());
  if (count < layout_.minCells || count > layout_.maxCells) {
    return Error{
        lines_->where(),
        message("has %1 columns where %2 were expected", std::to_string(count), std::to_string(layout_.minCells)),
        message("a damaged or truncated file")};
  }
  for (std::size_t i = 0; i < channels_.columns.size(); ++i) {
    const Result<double> value = numberIn(channels_.columns[i]);
    if (!value) return value.error();
    row_.values[i] = static_cast<float>(*value);
  }
  if (timed_) {
    const Result<double> time = numberIn(layout_.timeColumn);
    if (!time) return time.error();
    row_.time = *time * layout_.secondsPerTime;
  }
  return Done{};
}

Result<std::int64_t> TextReader::missingBetween(double before, double after) const {
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

Result<double> TextReader::typicalStep() {
  if (const Status s = rewind(); !s) return s.error();
  std::vector<double> steps;
  double before = 0.0;
  for (std::size_t n = 0; n <= kStepSample; ++n) {
    const Result<bool> more = nextRow();
    if (!more) return more.error();
    if (!*more) break;
    if (n > 0) steps.push_back(row_.time - before);
    before = row_.time;
  }
  if (steps.empty()) return Error{path_, message("one row of numbers is no recording")};
  const double step = median(std::move(steps));
  if (!(step > 0.0)) return Error{path_, message("the time column does not grow"), evenly()};
  return step;
}

// First pass: every cell is checked, rows are counted, the rate is found.
Status TextReader::scan(const ReadOptions& options) {
  if (options.rate && !(options.rate->value > 0.0 && std::isfinite(options.rate->value))) {
    return Error{"--rate", message("must be above zero")};
  }
  timed_ = layout_.timeColumn >= 0 && !options.rate;
  if (!timed_ && !options.rate && !layout_.rateFromHeader) {
    return Error{path_, message("the sampling rate is not known: there is no time column"),
                 message("give it with --rate HZ")};
  }
  if (timed_) {
    const Result<double> step = typicalStep();
    if (!step) return step.error();
    step_ = *step;
  }
  if (const Status s = rewind(); !s) return s.error();
  double evenTime = 0.0;  // over all steps without a gap
  std::int64_t evenSteps = 0;
  while (true) {
    const double before = row_.time;
    const Result<bool> more = nextRow();
    if (!more) return more.error();
    if (!*more) break;
    if (rows_ > 1 && row_.lost == 0) {
      evenTime += row_.time - before;
      ++evenSteps;
    }
  }
  format_.frames = rows_;
  format_.kind = layout_.kind;
  format_.channels = channels_.channels;
  format_.skipped = channels_.skipped;
  if (const Status s = settleRate(options, evenTime, evenSteps); !s) return s.error();
  return rewind();
}

Status TextReader::settleRate(const ReadOptions& options, double evenTime, std::int64_t evenSteps) {
  if (options.rate) {
    format_.rate = *options.rate;
  } else if (!timed_) {
    format_.rate = *layout_.rateFromHeader;
  } else if (evenSteps > 0) {
    format_.rate = Hertz(snapped(static_cast<double>(evenSteps) / evenTime, evenTime));
  } else {
    return Error{path_, message("the time steps are uneven"), evenly()};
  }
  return Done{};
}

Result<bool> TextReader::read(SampleBlock& block) {
  block.frames = 0;
  block.flags = 0;
  block.lostFrames = 0;
  std::int64_t firstFrame = 0;
  while (block.frames < block.capacityFrames) {
    if (!havePending_) {
      const Result<bool> more = nextRow();
      if (!more) return more.error();
      if (!*more) break;
    }
    havePending_ = row_.lost > 0 && block.frames > 0;  // missing frames are announced by the block after them
    if (havePending_) break;
    if (block.frames == 0) {
      if (row_.lost > 0) block.flags |= kBlockGap;
      block.lostFrames = static_cast<std::uint64_t>(row_.lost);
      lostTotal_ += row_.lost;
      firstFrame = framesRead_ + lostTotal_;
    }
    for (std::size_t c = 0; c < row_.values.size(); ++c) {
      block.samples[c * static_cast<std::size_t>(block.capacityFrames) + static_cast<std::size_t>(block.frames)] =
          row_.values[c];
    }
    ++block.frames;
    ++framesRead_;
  }
  if (block.frames == 0) return false;
  block.sequence = sequence_++;
  block.rate = format_.rate;
  block.firstSample = Instant(toDuration(Seconds(static_cast<double>(firstFrame) / format_.rate.value)));
  if (framesRead_ >= format_.frames) block.flags |= kBlockEnd;
  return true;
}

}  // namespace stillcut::record
