#include "core/formats/tdms/tdms_import.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "core/formats/tdms/tdms_index.h"
#include "core/formats/variable_channels.h"

namespace stillcut::record {
namespace {

// value = slope raw + offset, by the channel's own linear scale.
struct Scale {
  double slope = 1.0, offset = 0.0;
};

// The values of a channel one after the other, as their bits.
class TdmsValues {
 public:
  TdmsValues(const std::string& path, TdmsChannel channel)
      : path_(path), file_(path, std::ios::binary), channel_(std::move(channel)) {}

  TdmsType type() const { return channel_.type; }
  // Of a time `low` is its fraction and `high` its seconds; of a number `low` is all of it.
  Status next(std::uint64_t& low, std::uint64_t& high) {
    while (run_ < channel_.runs.size() && done_ == channel_.runs[run_].count) {
      ++run_;
      done_ = 0;
    }
    const std::size_t size = sizeOf(channel_.type);
    if (run_ == channel_.runs.size()) return early();
    const TdmsRun& run = channel_.runs[run_];
    const std::uint64_t at = run.from + done_ * run.stride;
    if (at < begin_ || at + size > begin_ + buffer_.size()) {
      if (!fill(at, run)) return early();
    }
    const std::span<const unsigned char> bytes =
        std::span(buffer_).subspan(static_cast<std::size_t>(at - begin_), size);
    const std::size_t half = std::min(size, sizeof low);
    low = high = 0;
    for (std::size_t i = 0; i < size; ++i) {
      // From the most significant on, which lies first or last.
      std::uint64_t& word = i < size - half ? high : low;
      word = word << 8U | bytes[run.bigEndian ? i : size - 1 - i];
    }
    ++done_;
    return Done{};
  }

 private:
  bool fill(std::uint64_t at, const TdmsRun& run) {
    constexpr std::uint64_t kAtOnce = std::uint64_t{256} << 10U;
    const std::uint64_t left = (run.count - done_ - 1) * run.stride + sizeOf(channel_.type);
    buffer_.resize(static_cast<std::size_t>(std::min(kAtOnce, left)));
    begin_ = at;
    file_.clear();
    file_.seekg(static_cast<std::streamoff>(at));
    file_.read(reinterpret_cast<char*>(buffer_.data()), static_cast<std::streamsize>(buffer_.size()));
    return static_cast<std::size_t>(file_.gcount()) == buffer_.size();
  }
  Error early() const { return Error{path_, message("ends early"), message("a truncated or damaged file")}; }

  std::string path_;
  std::ifstream file_;
  TdmsChannel channel_;
  std::size_t run_ = 0;
  std::uint64_t done_ = 0;   // values of the run
  std::uint64_t begin_ = 0;  // of the buffer, in the file
  std::vector<unsigned char> buffer_;
};

class TdmsColumn final : public Column {
 public:
  TdmsColumn(const std::string& path, TdmsChannel channel, Scale scale)
      : values_(path, std::move(channel)), scale_(scale) {}

  Status read(std::span<double> out) override {
    std::uint64_t bits = 0, none = 0;
    for (double& value : out) {
      if (Status s = values_.next(bits, none); !s) return s;
      value = scale_.slope * tdmsNumber(bits, values_.type()) + scale_.offset;
    }
    return Done{};
  }

 private:
  TdmsValues values_;
  Scale scale_;
};

// Time stamps as seconds from the first.
class TdmsTimes final : public Column {
 public:
  TdmsTimes(const std::string& path, TdmsChannel channel) : path_(path), values_(path, std::move(channel)) {}

  Status read(std::span<double> out) override {
    for (double& value : out) {
      const Result<std::int64_t> ns = next();
      if (!ns) return ns.error();
      if (!first_) first_ = *ns;
      value = static_cast<double>(*ns - *first_) * 1e-9;
    }
    return Done{};
  }
  // ns since 1970 UTC.
  Result<std::int64_t> next() {
    std::uint64_t fraction = 0, seconds = 0;
    if (const Status s = values_.next(fraction, seconds); !s) return s.error();
    const std::optional<std::int64_t> ns = tdmsTime(static_cast<std::int64_t>(seconds), fraction);
    if (!ns) return Error{path_, message("holds a time stamp that makes no sense"), message("a damaged file")};
    return *ns;
  }

 private:
  std::string path_;
  TdmsValues values_;
  std::optional<std::int64_t> first_;
};

const std::string& textAt(const TdmsChannel& c, const std::string& key) {
  static const std::string none;
  const auto found = c.texts.find(key);
  return found == c.texts.end() ? none : found->second;
}

// Error: its values are raw, and how they are scaled is beyond a line.
Result<Scale> scaleOf(const TdmsChannel& c, const std::string& path) {
  const auto scales = c.numbers.find("NI_Number_Of_Scales");
  if (scales == c.numbers.end() || scales->second < 1.0 || textAt(c, "NI_Scaling_Status") == "scaled") return Scale{};
  const std::string last = "NI_Scale[" + std::to_string(static_cast<int>(scales->second) - 1) + "]_";
  const auto slope = c.numbers.find(last + "Linear_Slope");
  const auto offset = c.numbers.find(last + "Linear_Y_Intercept");
  if (textAt(c, last + "Scale_Type") == "Linear" && slope != c.numbers.end() && offset != c.numbers.end())
    return Scale{slope->second, offset->second};
  return Error{path, message("'%1' is raw, with a scale that is no straight line", cleanName(c.name)),
               message("export it scaled, or as CSV")};
}

// When its first value was taken, ns since 1970 UTC; 0: not said.
std::int64_t startOf(const TdmsChannel& c) {
  const auto offset = c.numbers.find("wf_start_offset");
  constexpr double kDay = 86'400.0;  // [s] offsets beyond make no sense
  const bool told = c.started_ns != 0 && offset != c.numbers.end() && std::abs(offset->second) <= kDay;
  return told ? c.started_ns + std::llround(offset->second * 1e9) : c.started_ns;
}

double incrementOf(const TdmsChannel& c) {
  const auto found = c.numbers.find("wf_increment");
  return found != c.numbers.end() && found->second > 0.0 ? found->second : 0.0;
}

// The time between samples that most values have; 0: none says one.
double usualIncrement(const std::vector<TdmsChannel>& channels) {
  double usual = 0.0;
  std::uint64_t most = 0;
  for (const TdmsChannel& c : channels) {
    std::uint64_t values = 0;
    for (const TdmsChannel& other : channels) {
      if (incrementOf(other) == incrementOf(c)) values += other.values;
    }
    if (incrementOf(c) > 0.0 && values > most) {
      most = values;
      usual = incrementOf(c);
    }
  }
  return usual;
}

// A channel of time stamps beside the samples: when each was taken.
Status takeTimes(const TdmsChannel& c, const std::string& path, FileContents& contents) {
  if (contents.started_ns == 0) {
    const Result<std::int64_t> first = TdmsTimes(path, c).next();
    if (!first) return first.error();
    contents.started_ns = *first;
  }
  FileArray array;
  array.name = cleanName(c.name);
  array.frames = static_cast<std::int64_t>(c.values);
  array.unit = "s";
  array.open = [path, c](int) -> Result<std::unique_ptr<Column>> {
    return std::unique_ptr<Column>(new TdmsTimes(path, c));
  };
  contents.arrays.push_back(std::move(array));
  return Done{};
}

bool isNumber(TdmsType type) {
  return sizeOf(type) > 0 && type != TdmsType::TimeStamp;
}

Status takeChannel(const TdmsChannel& c, const std::string& path, double increment, FileContents& contents) {
  const std::string name = cleanName(c.name);
  if (c.type == TdmsType::TimeStamp && c.values >= 2) return takeTimes(c, path, contents);
  const bool otherRate = incrementOf(c) > 0.0 && incrementOf(c) != increment;
  if (!isNumber(c.type) || c.values < 2 || otherRate) {
    contents.skipped.push_back(name);
    return Done{};
  }
  const auto scale = scaleOf(c, path);
  if (!scale) return scale.error();
  FileArray array;
  array.name = name;
  array.frames = static_cast<std::int64_t>(c.values);
  array.unit = textAt(c, "unit_string").empty() ? textAt(c, "NI_UnitDescription") : textAt(c, "unit_string");
  array.open = [path, c, scale = *scale](int) -> Result<std::unique_ptr<Column>> {
    return std::unique_ptr<Column>(new TdmsColumn(path, c, scale));
  };
  contents.arrays.push_back(std::move(array));
  return Done{};
}

// A last segment that is cut off holds more of some channels than of others: all end at the shortest, unless that
// would be far less.
void endTogether(std::vector<TdmsChannel>& channels) {
  std::uint64_t shortest = std::numeric_limits<std::uint64_t>::max(), longest = 0;
  for (const TdmsChannel& c : channels) {
    shortest = std::min(shortest, c.values);
    longest = std::max(longest, c.values);
  }
  if (2 * shortest < longest) return;
  for (TdmsChannel& c : channels) c.values = shortest;
}

// What the file, a group or a channel says of the rate.
void takeRates(const TdmsChannel& c, FileContents& contents) {
  for (const auto& number : c.numbers) contents.numbers.emplace_back(number);
  for (const auto& text : c.texts) contents.texts.emplace_back(text);
}

}  // namespace

Result<std::unique_ptr<RecordingReader>> openTdms(const std::string& path, const std::string& inner,
                                                  const ReadOptions& options) {
  auto index = readTdmsIndex(path);
  if (!index) return index.error();
  std::vector<TdmsChannel> wanted;
  for (TdmsChannel& c : index->channels) {
    const std::string place = "/" + c.group;
    if (inner.empty() || inner == place || inner == place + "/" + c.name) wanted.push_back(std::move(c));
  }
  if (wanted.empty()) {
    if (!inner.empty()) return Error{path + ":" + inner, message("there is no such channel in the file")};
    return Error{path, message("holds no values")};
  }
  FileContents contents;
  contents.path = path;
  contents.kind = "LabVIEW TDMS";
  const double increment = usualIncrement(wanted);
  if (increment > 0.0) contents.numbers.emplace_back("dt", increment);
  if (index->cut) endTogether(wanted);
  for (const TdmsChannel& c : wanted) takeRates(c, contents);
  for (const TdmsChannel& c : index->above) takeRates(c, contents);
  contents.started_ns = index->started_ns;
  for (const TdmsChannel& c : wanted) {
    if (c.started_ns != 0 && incrementOf(c) == increment) contents.started_ns = startOf(c);
  }
  for (const TdmsChannel& c : wanted) {
    if (const Status s = takeChannel(c, path, increment, contents); !s) return s.error();
  }
  if (index->cut) contents.notes.push_back(message("the file was not finished; what was written until then is read"));
  if (contents.arrays.empty()) return Error{path, message("holds no channel of numbers")};
  return openArrays(std::move(contents), options);
}

}  // namespace stillcut::record
