#include "core/formats/variable_channels.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <utility>

#include "core/formats/sensor_notes.h"
#include "core/formats/text/text_cells.h"
#include "core/formats/time_unit.h"
#include "core/formats/utf_text.h"
#include "core/units/time_names.h"
#include "core/units/unit_names.h"

namespace stillcut::record {
namespace {

Message giveRate() {
  return message("give it with --rate HZ");
}

Message secondsAssumed(const std::string& name) {
  return message("its times '%1' have no unit: seconds are assumed", name);
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

struct RateKey {
  bool step = false;
  double toSi = 1.0;  // Hz, or seconds
};

// "fs", "SampleRate", "sr_khz", "dt_us": what a number of this name is.
std::optional<RateKey> rateKey(std::string_view name) {
  constexpr auto kRates =
      std::to_array<std::string_view>({"rate", "fs", "sr", "samplerate", "samplingrate", "samplefrequency",
                                       "samplingfrequency", "samplefreq", "samplingfreq", "sfreq"});
  constexpr auto kSteps =
      std::to_array<std::string_view>({"dt", "ts", "deltat", "deltax", "xincrement", "sampletime", "sampleinterval",
                                       "samplinginterval", "tstep", "wfincrement"});
  const std::string word = plainWord(name);
  const auto find = [&word](const auto& keys, std::string_view unit) {
    return word.ends_with(unit) &&
           std::find(keys.begin(), keys.end(), word.substr(0, word.size() - unit.size())) != keys.end();
  };
  for (const auto& [unit, toSi] : {std::pair{"", 1.0}, {"hz", 1.0}, {"khz", 1e3}, {"mhz", 1e6}, {"sps", 1.0}}) {
    if (find(kRates, unit)) return RateKey{false, toSi};
  }
  for (const auto& [unit, toSi] : {std::pair{"", 1.0}, {"s", 1.0}, {"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}}) {
    if (find(kSteps, unit)) return RateKey{true, toSi};
  }
  return std::nullopt;
}

// "10000 Hz", "51.2 kHz", "0.1 ms", "10000".
std::optional<double> rateOfText(const RateKey& key, std::string_view text) {
  text = trimmed(text);
  const std::size_t end = std::min(text.find_first_not_of("+-.0123456789eE"), text.size());
  const std::optional<double> number = parseNumber(text.substr(0, end), false);
  const std::string unit(trimmed(text.substr(end)));
  if (!number || !(*number > 0.0)) return std::nullopt;
  if (unit.empty()) return key.step ? 1.0 / (*number * key.toSi) : *number * key.toSi;
  if (key.step) {
    const std::optional<UnitMeaning> meaning = unitFromText(unit);
    if (!meaning || meaning->kind != UnitKind::Time) return std::nullopt;
    return 1.0 / (*number * meaning->toSi);
  }
  for (const auto& [name, toSi] : {std::pair{"Hz", 1.0}, {"kHz", 1e3}, {"MHz", 1e6}, {"S/s", 1.0}, {"kS/s", 1e3}}) {
    if (unit == name) return *number * toSi;
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

struct TimesRate {
  double hertz = 0.0;
  bool assumed = false;  // nothing says that its numbers are seconds
};

// Seconds per unit; nothing: neither a unit, nor one in its name, nor a time since 1970.
Result<std::optional<double>> unitOfTimes(const FileArray& times, const ReadOptions& options) {
  if (options.secondsPerTime) return options.secondsPerTime;
  NameAndUnit both = splitNameAndUnit(times.name);
  if (!times.unit.empty()) both.unit = times.unit;
  if (both.unit.empty()) both.unit = timeUnitInName(times.name);
  const std::optional<UnitMeaning> unit = unitFromText(both.unit);
  if (unit && unit->kind == UnitKind::Time) return std::optional(unit->toSi);
  Result<std::unique_ptr<Column>> column = times.open(0);
  if (!column) return column.error();
  std::array<double, 1> first{};
  if (const Status s = (*column)->read(first); !s) return s.error();
  return epochUnit(first[0]);
}

// Reads the whole column: one bad step and the times are no times.
Result<TimesRate> rateFromTimes(const FileArray& times, const ReadOptions& options, const std::string& path) {
  const Result<std::optional<double>> unit = unitOfTimes(times, options);
  if (!unit) return unit.error();
  Result<std::unique_ptr<Column>> column = times.open(0);
  if (!column) return column.error();
  (*column)->countFromFirst();
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
  const double seconds = (before - first) * unit->value_or(1.0);
  const double step = (before - first) / static_cast<double>(times.frames - 1);
  if (!(step > 0.0) || shortest < 0.5 * step || longest > 1.5 * step) {
    return Error{where, message("the time steps are uneven"),
                 message("give --rate HZ to read the samples as evenly spaced")};
  }
  constexpr double kFrames = 0.05;  // what a clock could tell
  const double rate = static_cast<double>(times.frames - 1) / seconds;
  return TimesRate{wholeRate(rate, kFrames / (rate * seconds)), !*unit};
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
std::optional<TimesRate> rateOfFirstColumn(const FileArray& array, std::optional<double> stated,
                                           const ReadOptions& options, const std::string& path) {
  constexpr double kApart = 0.01;
  constexpr std::int64_t kFewest = 8;
  if (array.columns < 2 || array.frames < kFewest) return std::nullopt;
  FileArray first = firstColumn(array);
  constexpr std::int64_t kGlance = 1000;  // most signals show here that they are no times
  first.frames = std::min(array.frames, kGlance);
  if (!rateFromTimes(first, options, path)) return std::nullopt;
  first.frames = array.frames;
  const Result<TimesRate> rate = rateFromTimes(first, options, path);
  if (!rate || !(rate->hertz > 1.0)) return std::nullopt;
  if (stated && std::abs(rate->hertz - *stated) > kApart * *stated) return std::nullopt;
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

// The time of a file whose rate nothing else tells.
Status takeTimes(const std::string& name, const TimesRate& found, const std::string& path, std::optional<double>& rate,
                 RecordingFormat& format) {
  rate = found.hertz;
  if (!found.assumed) return Done{};
  format.notes.push_back(secondsAssumed(name));
  return checkAssumedSeconds(path + ": '" + name + "'", 1.0 / found.hertz);
}

}  // namespace

bool namesRate(std::string_view name) {
  return rateKey(name).has_value();
}

std::optional<double> statedRate(const std::vector<std::pair<std::string, double>>& numbers,
                                 const std::vector<std::pair<std::string, std::string>>& texts) {
  for (const auto& [name, value] : numbers) {
    const std::optional<RateKey> key = rateKey(name);
    if (!key || value == 0.0) continue;
    return key->step ? wholeRate(1.0 / (value * key->toSi), 1e-9) : value * key->toSi;
  }
  for (const auto& [name, text] : texts) {
    const std::optional<RateKey> key = rateKey(name);
    const std::optional<double> rate = key ? rateOfText(*key, text) : std::nullopt;
    if (rate) return wholeRate(*rate, 1e-9);
  }
  return std::nullopt;
}

Result<std::unique_ptr<RecordingReader>> openArrays(FileContents contents, const ReadOptions& options) {
  if (options.rate && !(options.rate->value > 0.0 && std::isfinite(options.rate->value))) {
    return Error{"--rate", message("must be above zero")};
  }
  RecordingFormat format;
  format.kind = contents.kind;
  format.frames = usualLength(contents.arrays);
  for (std::string& name : contents.skipped) {
    leaveOut(format, std::move(name), message("it holds no row of numbers that is read"));
  }
  format.notes = std::move(contents.notes);
  format.started_ns = contents.started_ns;
  const std::optional<double> stated = statedRate(contents.numbers, contents.texts);
  std::optional<double> rate = stated;
  if (options.rate) rate = options.rate->value;
  std::vector<ColumnChannel> all;
  for (const FileArray& array : contents.arrays) {
    const bool time = array.frames == format.frames && isTime(array);
    if (time && !rate) {
      const Result<TimesRate> found = rateFromTimes(array, options, contents.path);
      if (!found) return found.error();
      if (const Status s = takeTimes(array.name, *found, contents.path, rate, format); !s) return s.error();
    }
    if (time) continue;
    if (array.frames != format.frames) {
      leaveOut(format, array.name,
               message("it has %1 numbers where the recording has %2", array.frames, format.frames));
      continue;
    }
    if (isNoSignal(array)) {
      leaveOut(format, array.name, message("its name or its unit says that it is no vibration"));
      continue;
    }
    const std::optional<TimesRate> times = rateOfFirstColumn(array, stated, options, contents.path);
    if (times && !rate) {
      if (const Status s = takeTimes(array.name + " 0", *times, contents.path, rate, format); !s) return s.error();
    }
    if (times) leaveOut(format, array.name + " 0", message("it holds times"));
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
