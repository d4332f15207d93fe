#include "core/formats/text/text_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "core/formats/time_unit.h"
#include "core/formats/utf_text.h"

namespace stillcut::record {
namespace {

constexpr std::size_t kSniffLines = 400;
constexpr std::size_t kStepSample = 1000;  // rows from which the typical time step is taken
constexpr int kMostColumns = 256;
constexpr double kMostBad = 0.1;   // of the rows may hold no number: more, and this is no recording with a few gaps
constexpr double kShortest = 0.5;  // of the rows a column must reach to, or it is left out

constexpr double kManyRepeats = 10.0;  // one row in so many, or more, has the time of the row before it

Message evenly() {
  return message("give --rate HZ to read the rows as evenly spaced");
}

// The person at hand knows it, whatever the header says.
void takeTimeUnit(double secondsPerTime, TextLayout& layout) {
  if (layout.timeColumn < 0 || layout.timeStamps) return;
  layout.secondsPerTime = secondsPerTime;
  layout.timeUnitAssumed = layout.days = false;
  layout.unknownTimeUnit.clear();
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

// As "%.6g" prints it.
std::string shortNumber(double value) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

}  // namespace

TextReader::TextReader(std::string path, TextLayout layout, TextChannels channels)
    : path_(std::move(path)), layout_(std::move(layout)), channels_(std::move(channels)) {}

bool TextReader::holdsTable(const std::string& path) {
  bool complete = false;
  const Result<std::vector<std::string>> lines = firstLines(path, complete);
  return lines && detectTextLayout(lines.value(), complete, path).ok();
}

Result<std::unique_ptr<RecordingReader>> TextReader::open(const std::string& path, const ReadOptions& options,
                                                          std::vector<Message> notes) {
  bool complete = false;
  const Result<std::vector<std::string>> lines = firstLines(path, complete);
  if (!lines) return lines.error();
  Result<TextLayout> layout = detectTextLayout(lines.value(), complete, path);
  if (!layout) return layout.error();
  if (layout->columns.size() > kMostColumns) return Error{path, message("has more than 256 columns")};
  if (options.secondsPerTime) takeTimeUnit(*options.secondsPerTime, *layout);
  Result<TextChannels> channels = chooseTextChannels(*layout, options, path);
  if (!channels) return channels.error();
  std::unique_ptr<TextReader> reader(new TextReader(path, std::move(*layout), std::move(*channels)));
  reader->format_.notes = std::move(notes);
  if (const Status s = reader->scan(options); !s) return s.error();
  return std::unique_ptr<RecordingReader>(std::move(reader));
}

// First pass: every cell is checked, rows are counted, the rate is found.
Status TextReader::scan(const ReadOptions& options) {
  if (const Status s = checkTime(options); !s) return s.error();
  if (const Status s = pass(); !s) return s.error();
  if (settleColumns()) {
    if (const Status s = pass(); !s) return s.error();
  }
  if (const Status s = checkBadRows(); !s) return s.error();
  format_.frames = rows_->counts().rows;
  format_.started_ns = rows_->startedNs().value_or(0);
  format_.kind = layout_.kind;
  format_.channels = channels_.channels;
  format_.skipped = channels_.skipped;
  format_.skippedWhy = channels_.skippedWhy;
  if (const Status s = settleRate(options); !s) return s.error();
  makeNotes();
  return rows_->rewind();
}

Status TextReader::checkTime(const ReadOptions& options) {
  if (options.rate && !(options.rate->value > 0.0 && std::isfinite(options.rate->value))) {
    return Error{"--rate", message("must be above zero")};
  }
  timed_ = layout_.timeColumn >= 0 && !options.rate;
  if (!layout_.frequencies.empty() && !options.rate) {
    return Error{path_, message("is a spectrum and no recording: '%1' holds frequencies", layout_.frequencies),
                 message("open the samples that it was made of; a frequency response goes into the tap test")};
  }
  if (timed_ && !layout_.unknownTimeUnit.empty()) {
    return Error{path_, message("the unit '%1' of its time is not known", layout_.unknownTimeUnit),
                 message("say --time-unit s, ms, us or ns, or give --rate HZ")};
  }
  if (timed_ && layout_.days) {
    return Error{path_, message("its time seems to be in days, as spreadsheets count them"),
                 message("format it as a time of day and export again, or give --rate HZ")};
  }
  if (timed_ && !layout_.otherTime.empty()) {
    return Error{path_, message("its columns have times of their own: '%1' goes in other steps", layout_.otherTime),
                 message("export each with its channels as a file of its own, or give --rate HZ")};
  }
  return Done{};
}

// By the times alone, whatever the channels hold.
Status TextReader::findStep() {
  TextRows times(path_, layout_, {}, timed_);
  if (const Status s = times.rewind(); !s) return s.error();
  std::vector<double> steps;
  double before = 0.0;
  for (std::size_t n = 0; n <= kStepSample; ++n) {
    const Result<bool> more = times.next();
    if (!more) return more.error();
    if (!*more) break;
    if (n > 0) steps.push_back(times.row().time - before);
    before = times.row().time;
  }
  if (steps.empty()) {
    if (times.counts().firstBad) return *times.counts().firstBad;
    return Error{path_, message("one row of numbers is no recording")};
  }
  const auto repeated = std::count(steps.begin(), steps.end(), 0.0);
  step_ = median(steps);
  coarse_ = layout_.rateFromHeader && kManyRepeats * static_cast<double>(repeated) > static_cast<double>(steps.size());
  if (!(step_ > 0.0) && !coarse_) return Error{path_, message("the time column does not grow"), evenly()};
  return Done{};
}

Status TextReader::pass() {
  rows_ = std::make_unique<TextRows>(path_, layout_, channels_.columns, timed_);
  if (end_ > 0) rows_->setEnd(end_);
  if (timed_) {
    if (const Status s = findStep(); !s) return s.error();
    if (coarse_) {
      takeHeaderRate();
      return pass();
    }
    rows_->setStep(step_);
  }
  if (const Status s = rows_->rewind(); !s) return s.error();
  evenTime_ = 0.0;
  evenSteps_ = 0;
  while (true) {
    const double before = rows_->row().time;
    const Result<bool> more = rows_->next();
    if (!more) return more.error();
    if (!*more) return Done{};
    if (rows_->counts().rows > 1 && rows_->row().lost == 0) {
      evenTime_ += rows_->row().time - before;
      ++evenSteps_;
    }
  }
}

// Stamps that repeat cannot part the rows, and gaps cannot be seen in them.
void TextReader::takeHeaderRate() {
  timed_ = coarse_ = false;
  format_.notes.push_back(
      message("its times are too coarse for its rows, several of which share one: they are taken "
              "as evenly spaced by the rate of its header, %1 Hz",
              shortNumber(layout_.rateFromHeader->value)));
}

bool TextReader::settleColumns() {
  const TextRowCounts& counts = rows_->counts();
  const auto all = static_cast<double>(counts.all());
  std::vector<bool> out(channels_.columns.size(), false);
  std::int64_t end = counts.all();
  for (std::size_t c = 0; c < out.size(); ++c) {
    const std::int64_t filled = counts.filledTo[c];
    const std::int64_t within = counts.badCells[c] - (counts.all() - filled);  // without those behind its end
    out[c] = static_cast<double>(filled) < kShortest * all ||
             static_cast<double>(within) > kMostBad * static_cast<double>(filled);
    if (!out[c]) end = std::min(end, filled);
  }
  const auto gone = std::count(out.begin(), out.end(), true);
  if (gone == static_cast<std::ptrdiff_t>(out.size())) return false;  // checkBadRows() says why
  if (gone == 0 && end == counts.all()) return false;
  if (end < counts.all()) {
    end_ = end;
    format_.notes.push_back(
        message("some columns end after %1 of %2 rows, where the recording ends; --channel N reads one alone", end,
                counts.all()));
  }
  leaveOut(out);
  return true;
}

void TextReader::leaveOut(const std::vector<bool>& out) {
  TextChannels kept;
  kept.skipped = channels_.skipped;
  kept.skippedWhy = channels_.skippedWhy;
  for (std::size_t c = 0; c < out.size(); ++c) {
    if (out[c]) {
      kept.skipped.push_back(channels_.channels[c].info.name);
      kept.skippedWhy.push_back(message("most of its cells hold no number"));
      format_.notes.push_back(
          message("column '%1' is left out: most of its cells hold no number", channels_.channels[c].info.name));
    } else {
      kept.columns.push_back(channels_.columns[c]);
      kept.channels.push_back(channels_.channels[c]);
    }
  }
  channels_ = std::move(kept);
}

Status TextReader::checkBadRows() {
  const TextRowCounts& counts = rows_->counts();
  if (counts.bad > 0 && static_cast<double>(counts.bad) > kMostBad * static_cast<double>(counts.all()))
    return *counts.firstBad;
  if (counts.rows < 2) return Error{path_, message("one row of numbers is no recording")};
  return Done{};
}

Status TextReader::settleRate(const ReadOptions& options) {
  std::optional<Hertz> stated = layout_.rateFromHeader;
  const std::vector<double>& footer = rows_->counts().footerRates;
  if (!stated && !footer.empty() &&
      std::count(footer.begin(), footer.end(), footer.front()) == static_cast<std::ptrdiff_t>(footer.size())) {
    stated = Hertz(footer.front());
  }
  if (options.rate) {
    format_.rate = *options.rate;
  } else if (timed_ && evenSteps_ > 0) {
    format_.rate = Hertz(snapped(static_cast<double>(evenSteps_) / evenTime_, evenTime_));
  } else if (timed_) {
    return Error{path_, message("the time steps are uneven"), evenly()};
  } else if (stated) {
    format_.rate = *stated;
  } else if (!layout_.unclearRate.empty()) {
    return Error{path_,
                 message("it is not clear whether the rate '%1' of its header is a fraction or has thousands set apart",
                         layout_.unclearRate),
                 message("give it with --rate HZ")};
  } else {
    return Error{path_, message("the sampling rate is not known: there is no time column"),
                 message("give it with --rate HZ")};
  }
  if (timed_ && layout_.timeUnitAssumed) {
    if (Status clear = checkAssumedSeconds(path_, 1.0 / format_.rate.value); !clear) return clear;
    format_.notes.push_back(message("its times have no unit: seconds are assumed"));
  }
  constexpr double kApart = 0.01;
  if (timed_ && stated && std::abs(stated->value - format_.rate.value) > kApart * format_.rate.value) {
    format_.notes.push_back(message("its header says %1 Hz, its times %2 Hz, which are taken",
                                    shortNumber(stated->value), shortNumber(format_.rate.value)));
  }
  return Done{};
}

void TextReader::makeNotes() {
  const TextRowCounts& counts = rows_->counts();
  if (counts.bad > 0) {
    format_.notes.push_back(message("%1 of %2 rows hold no number where one belongs and are missing; the first: %3",
                                    counts.bad, counts.all(), counts.firstBad->asMessage()));
  }
  if (counts.cutLine) format_.notes.push_back(message("line %1, the last, is cut off and left out", *counts.cutLine));
  if (counts.footer)
    format_.notes.push_back(message("what stands below the rows is left out: %1", counts.footer->asMessage()));
}

Result<bool> TextReader::read(SampleBlock& block) {
  block.frames = 0;
  block.flags = 0;
  block.lostFrames = 0;
  std::int64_t firstFrame = 0;
  while (block.frames < block.capacityFrames && framesRead_ < format_.frames) {
    if (!havePending_) {
      const Result<bool> more = rows_->next();
      if (!more) return more.error();
      if (!*more) break;
    }
    const TextRow& row = rows_->row();
    havePending_ = row.lost > 0 && block.frames > 0;  // missing frames are announced by the block after them
    if (havePending_) break;
    if (block.frames == 0) {
      if (row.lost > 0) block.flags |= kBlockGap;
      block.lostFrames = static_cast<std::uint64_t>(row.lost);
      lostTotal_ += row.lost;
      firstFrame = framesRead_ + lostTotal_;
    }
    for (std::size_t c = 0; c < row.values.size(); ++c) {
      block.samples[c * static_cast<std::size_t>(block.capacityFrames) + static_cast<std::size_t>(block.frames)] =
          row.values[c];
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
