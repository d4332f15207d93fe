#include "core/formats/variable_channels.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <utility>

#include "core/formats/sensor_notes.h"
#include "core/formats/utf_text.h"
#include "core/units/unit_names.h"

namespace stillcut::record {
namespace {

Message giveRate() {
  return message("give it with --rate HZ");
}

// "Sample_Rate" and "sampleRate" are "samplerate".
std::string plainWord(std::string_view name) {
  std::string word;
  for (const char c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  return word;
}

std::optional<double> rateFromNumbers(const FileContents& contents) {
  constexpr auto kRates =
      std::to_array<std::string_view>({"ratehz", "rate", "fs", "fshz", "samplerate", "samplingrate", "samplefrequency",
                                       "samplingfrequency", "samplefreq", "samplingratehz", "sampleratehz"});
  constexpr auto kSteps = std::to_array<std::string_view>(
      {"dt", "ts", "deltat", "deltax", "xincrement", "sampletime", "sampleinterval", "samplinginterval", "tstep"});
  for (const auto& [name, value] : contents.numbers) {
    const std::string word = plainWord(name);
    if (std::find(kRates.begin(), kRates.end(), word) != kRates.end()) return value;
    if (std::find(kSteps.begin(), kSteps.end(), word) != kSteps.end() && value != 0.0) {
      return wholeRate(1.0 / value, 1e-9);
    }
  }
  return std::nullopt;
}

std::int64_t usualLength(const std::vector<FileArray>& arrays) {
  std::map<std::int64_t, std::int64_t> samples;  // by length
  for (const FileArray& a : arrays) samples[a.frames] += a.frames * a.columns;
  std::int64_t best = 0;
  std::int64_t most = 0;
  for (const auto& [frames, count] : samples) {
    if (count >= most) {
      best = frames;
      most = count;
    }
  }
  return best;
}

bool isTime(const FileArray& a) {
  const std::optional<UnitMeaning> unit = unitFromText(a.unit);
  return a.columns == 1 && ((unit && unit->kind == UnitKind::Time) || meaningOfName(a.name) == NameMeaning::Time);
}

// Reads the whole column: one bad step and the times are no times.
Result<double> rateFromTimes(const FileArray& times, const std::string& path) {
  Result<std::unique_ptr<Column>> column = times.open(0);
  if (!column) return column.error();
  const std::string where = path + ": '" + times.name + "'";
  std::vector<double> values;
  double first = 0.0;
  double before = 0.0;
  double shortest = INFINITY;
  double longest = 0.0;
  constexpr std::int64_t kAtOnce = 65536;
  for (std::int64_t at = 0; at < times.frames; at += kAtOnce) {
    values.resize(static_cast<std::size_t>(std::min(kAtOnce, times.frames - at)));
    if (const Status s = (*column)->read(values); !s) return s.error();
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (at == 0 && i == 0) {
        first = values[0];
      } else {
        shortest = std::min(shortest, values[i] - before);
        longest = std::max(longest, values[i] - before);
      }
      if (!std::isfinite(values[i])) return Error{where, message("holds times that are not finite"), giveRate()};
      before = values[i];
    }
  }
  const std::optional<UnitMeaning> unit = unitFromText(times.unit);
  const double toSeconds = unit && unit->kind == UnitKind::Time ? unit->toSi : 1.0;
  const double seconds = (before - first) * toSeconds;
  const double step = (before - first) / static_cast<double>(times.frames - 1);
  if (!(step > 0.0) || shortest < 0.5 * step || longest > 1.5 * step) {
    return Error{where, message("the time steps are uneven"),
                 message("give --rate HZ to read the samples as evenly spaced")};
  }
  constexpr double kFrames = 0.05;  // what a clock could tell
  const double rate = static_cast<double>(times.frames - 1) / seconds;
  return wholeRate(rate, kFrames / (rate * seconds));
}

// The first column of several as an array of its own.
FileArray firstColumn(const FileArray& array) {
  FileArray first;
  first.name = array.name + " 0";
  first.frames = array.frames;
  first.open = [open = array.open](int) { return open(0); };
  return first;
}

// Rate of a first column that grows in even steps below a second, which fits the rate that the file states, if it does;
// nothing: it is a channel like the others.
std::optional<double> rateOfFirstColumn(const FileArray& array, std::optional<double> stated, const std::string& path) {
  constexpr double kApart = 0.01;
  constexpr std::int64_t kFewest = 8;
  if (array.columns < 2 || array.frames < kFewest) return std::nullopt;
  FileArray first = firstColumn(array);
  constexpr std::int64_t kGlance = 1000;  // most signals show here that they are no times
  first.frames = std::min(array.frames, kGlance);
  if (!rateFromTimes(first, path)) return std::nullopt;
  first.frames = array.frames;
  const Result<double> rate = rateFromTimes(first, path);
  if (!rate || !(*rate > 1.0)) return std::nullopt;
  if (stated && std::abs(*rate - *stated) > kApart * *stated) return std::nullopt;
  return *rate;
}

RecordedChannel channelOf(const FileArray& array, int column) {
  const std::string name = array.columns == 1 ? array.name : array.name + " " + std::to_string(column);
  RecordedChannel channel = channelFromWords(name, array.unit);
  if (!array.axis.empty()) channel.info.axis = array.axis;
  takeSensor(array.sensor, channel.info);
  if (const auto quantity = sensorQuantityFromName(array.quantity)) {
    if (channel.info.quantity != *quantity) channel.info.scale = 1.0;
    channel.info.quantity = *quantity;
    channel.quantityKnown = true;
  }
  if (array.scale && std::isfinite(*array.scale) && *array.scale != 0.0) channel.info.scale = *array.scale;
  return channel;
}

bool isNoSignal(const FileArray& array) {
  const std::optional<UnitMeaning> unit = unitFromText(array.unit);
  return meaningOfName(array.name) == NameMeaning::NoSignal || (unit && unit->kind == UnitKind::Other);
}

}  // namespace

Result<std::unique_ptr<RecordingReader>> openArrays(FileContents contents, const ReadOptions& options) {
  if (options.rate && !(options.rate->value > 0.0 && std::isfinite(options.rate->value))) {
    return Error{"--rate", message("must be above zero")};
  }
  RecordingFormat format;
  format.kind = contents.kind;
  format.frames = usualLength(contents.arrays);
  format.skipped = std::move(contents.skipped);
  format.notes = std::move(contents.notes);
  format.started_ns = contents.started_ns;
  const std::optional<double> stated = rateFromNumbers(contents);
  std::optional<double> rate = stated;
  if (options.rate) rate = options.rate->value;
  std::vector<ColumnChannel> all;
  for (const FileArray& array : contents.arrays) {
    const bool time = array.frames == format.frames && isTime(array);
    if (time && !rate) {
      const Result<double> found = rateFromTimes(array, contents.path);
      if (!found) return found.error();
      rate = *found;
    }
    if (time) continue;
    if (array.frames != format.frames || isNoSignal(array)) {
      format.skipped.push_back(array.name);
      continue;
    }
    const std::optional<double> times = rateOfFirstColumn(array, stated, contents.path);
    if (!rate) rate = times;
    if (times) format.skipped.push_back(array.name + " 0");
    for (int c = times ? 1 : 0; c < array.columns; ++c) {
      all.push_back({channelOf(array, c), [open = array.open, c] { return open(c); }});
    }
  }
  if (all.empty()) return Error{contents.path, message("holds no array of samples")};
  if (!rate) {
    return Error{contents.path, message("the sampling rate is not known: it holds neither a rate nor times"),
                 giveRate()};
  }
  format.rate = Hertz(*rate);
  return openColumns(contents.path, std::move(format), std::move(all), options);
}

std::string cleanName(std::string_view text) {
  constexpr std::size_t kLongest = 80;
  const std::string utf8 = utf8Of(text);
  std::string clean(cutUtf8(utf8, kLongest));
  for (char& c : clean) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  return clean;
}

}  // namespace stillcut::record
