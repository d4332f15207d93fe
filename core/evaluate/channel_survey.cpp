#include "core/evaluate/channel_survey.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "core/evaluate/hum_survey.h"

namespace stillcut::evaluate {
namespace {

constexpr double kLeastLook = 1.0;    // s: two levels, and an angle that wraps, are known no sooner
constexpr std::int64_t kLeast = 256;  // samples: fewer show nothing
constexpr int kAtOnce = 4096;
constexpr double kAtLevel = 0.03;    // of the range, from the lowest or highest value
constexpr double kTwoLevels = 0.98;  // of the samples; a sine clipped to a sixth of itself holds 90 % at its limits
constexpr double kGrows = 0.98;      // of the steps of an angle
constexpr double kWraps = 0.5;       // of the range, a step back

// One channel as it goes by.
class Sketch {
 public:
  void see(std::span<const float> samples) {
    for (const float v : samples) see(v);
  }
  // Neither constant nor a counter any more: the rest of the file cannot make it one.
  bool moves() const { return ups_ > 0 && downs_ > 0; }
  // After the look at the levels: empty where it may be a vibration.
  Message whyNone(const Sketch& whole) const {
    if (count_ < kLeast || !finite_) return {};
    if (ups_ == 0 && downs_ == 0) return message("it is constant");
    if (downs_ == 0 || ups_ == 0) return message("it only counts, as a row number or a time does");
    if (whole.levels() > kTwoLevels) return message("it knows two values only, as a tacho or a switch does");
    if (whole.angle()) return message("it grows evenly and falls back, as an angle or a counter does");
    return {};
  }
  // Second look, at what the first has found the range of.
  void seeLevels(std::span<const float> samples, const Sketch& range) {
    const double span = range.highest_ - range.lowest_;
    for (const float v : samples) {
      const double away = std::min(range.highest_ - static_cast<double>(v), static_cast<double>(v) - range.lowest_);
      if (away <= kAtLevel * span) ++atLevel_;
      if (count_ > 0 && static_cast<double>(v) > last_) ++ups_;
      if (count_ > 0 && last_ - static_cast<double>(v) > kWraps * span) ++wraps_;
      last_ = static_cast<double>(v);
      ++count_;
    }
  }

 private:
  void see(float value) {
    const auto v = static_cast<double>(value);
    finite_ = finite_ && std::isfinite(value);
    if (count_ == 0) {
      lowest_ = highest_ = v;
    } else if (v > last_) {
      ++ups_;
    } else if (v < last_) {
      ++downs_;
    }
    lowest_ = std::min(lowest_, v);
    highest_ = std::max(highest_, v);
    last_ = v;
    ++count_;
  }
  double levels() const { return static_cast<double>(atLevel_) / static_cast<double>(count_); }
  bool angle() const {
    const auto steps = static_cast<double>(count_ - 1);
    return wraps_ > 0 && static_cast<double>(ups_) + static_cast<double>(wraps_) > kGrows * steps &&
           static_cast<double>(ups_) > kGrows * (steps - static_cast<double>(wraps_));
  }

  std::int64_t count_ = 0, ups_ = 0, downs_ = 0, wraps_ = 0, atLevel_ = 0;
  double lowest_ = 0.0, highest_ = 0.0, last_ = 0.0;
  bool finite_ = true;
};

}  // namespace

Result<std::vector<LeftOutChannel>> surveyChannels(record::RecordingReader& reader, Hertz told) {
  const record::RecordingFormat& format = reader.format();
  const std::size_t channels = format.channels.size();
  std::vector<Sketch> sketches(channels), levels(channels);
  std::vector<std::vector<float>> beginning(channels);  // at least a second, for the second look
  SampleBlock block;
  block.allocate(static_cast<int>(channels), std::max(kAtOnce, format.blockFrames));
  const double least = kLeastLook * format.rate.value;
  HumSurvey hum(channels, format.rate);
  const double compared = channels > 1 ? HumSurvey::kLongest.value * format.rate.value : 0.0;
  for (double frames = 0.0;;) {
    const bool decided = frames >= std::max(least, compared) &&
                         std::all_of(sketches.begin(), sketches.end(), [](const Sketch& s) { return s.moves(); });
    if (decided) break;
    const Result<bool> more = reader.read(block);
    if (!more) return more.error();
    if (!*more) break;
    for (std::size_t c = 0; c < channels; ++c) {
      const std::span<const float> samples = block.channel(static_cast<int>(c));
      sketches[c].see(samples);
      if (channels > 1) hum.see(c, samples);
      if (frames < least) beginning[c].insert(beginning[c].end(), samples.begin(), samples.end());
    }
    frames += block.frames;
  }
  const std::vector<Hertz> hums = hum.hums(told);
  std::vector<LeftOutChannel> none;
  for (std::size_t c = 0; c < channels; ++c) {
    levels[c].seeLevels(beginning[c], sketches[c]);
    Message why = sketches[c].whyNone(levels[c]);
    if (why.empty() && hums[c].value > 0.0) {
      why = message("it is mains hum of %1 Hz and little else, look at its shield and ground",
                    std::to_string(std::lround(hums[c].value)));
    }
    if (!why.empty()) none.push_back({static_cast<int>(c), format.channels[c].info.name, std::move(why)});
  }
  if (none.size() == channels) none.clear();
  return none;
}

}  // namespace stillcut::evaluate
