#include "core/evaluate/picture/file_spectra.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/dsp/spectrum.h"

namespace stillcut::evaluate {
namespace {

constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();
constexpr std::int64_t kFewSamples = 1 << 18;  // that are given along
constexpr int kShortest = 64, kLongest = 1 << 17;

dsp::WindowKind kindOf(SpectraWindow window) {
  switch (window) {
    case SpectraWindow::FlatTop:
      return dsp::WindowKind::FlatTop;
    case SpectraWindow::Rectangular:
      return dsp::WindowKind::Rectangular;
    case SpectraWindow::Hann:
      break;
  }
  return dsp::WindowKind::Hann;
}

// One spectrum after the other, into the strongest of its column.
class Columns {
 public:
  Columns(const SampleStore& samples, Hertz rate, Spectra& spectra) : samples_(samples), spectra_(spectra) {
    const int length = spectra.request.length;
    spectrum_.prepare(length, rate, kindOf(spectra.request.window));
    spectra.binWidth = spectrum_.binWidth();
    spectra.bins = spectrum_.bins();
    raw_.resize(static_cast<std::size_t>(length));
    taken_.resize(raw_.size());
  }

  void begin(int columns) {
    spectra_.columns = columns;
    spectra_.level_dB.assign(static_cast<std::size_t>(columns) * static_cast<std::size_t>(spectra_.bins), kMissing);
  }

  bool take(std::int64_t first, int column) {
    if (!samples_.read(spectra_.request.channel, first, raw_)) return false;
    double mean = 0.0;
    for (const float value : raw_) mean += value;
    if (!std::isfinite(mean)) return true;  // samples are missing
    mean /= static_cast<double>(raw_.size());
    for (std::size_t k = 0; k < raw_.size(); ++k) taken_[k] = raw_[k] - mean;
    spectrum_.transform(taken_);
    float* out = spectra_.level_dB.data() + static_cast<std::ptrdiff_t>(column) * spectra_.bins;
    for (int b = 0; b < spectra_.bins; ++b) {
      const double rms = spectrum_.amplitude(b) / std::numbers::sqrt2;
      const auto level = static_cast<float>(20.0 * std::log10(std::max(rms, 1e-12)));
      if (!(out[b] >= level)) out[b] = level;
    }
    return true;
  }

 private:
  const SampleStore& samples_;
  Spectra& spectra_;
  dsp::Spectrum spectrum_;
  std::vector<float> raw_;
  std::vector<double> taken_;
};

SpectraRequest inRange(SpectraRequest request) {
  request.length = dsp::goodFftSize(std::clamp(request.length, kShortest, kLongest));
  request.overlap = std::clamp(request.overlap, 0.0, 0.95);
  request.columns = std::max(request.columns, 1);
  return request;
}

}  // namespace

Result<Spectra> spectraOf(const SampleStore& samples, Hertz rate, const SpectraRequest& request,
                          const std::function<bool(double)>& goOn) {
  const SpectraRequest used = inRange(request);
  Spectra spectra;
  spectra.request = used;
  const auto frameAt = [&](Seconds t) {
    return std::clamp<std::int64_t>(std::llround(t.value * rate.value), 0, samples.frames());
  };
  const std::int64_t from = frameAt(used.from), to = frameAt(used.to);
  if (to > from && to - from <= kFewSamples) {
    spectra.firstSample = from;
    spectra.samples.resize(static_cast<std::size_t>(to - from));
    if (!samples.read(used.channel, from, spectra.samples))
      return Error{message("the recording"), message("cannot be read again")};
  }
  Columns columns(samples, rate, spectra);
  // A stretch that is shorter than one spectrum gets the one around its middle.
  const std::int64_t last = std::max<std::int64_t>(samples.frames() - used.length, 0);
  const std::int64_t begin = std::clamp<std::int64_t>(from - used.length / 2, 0, last);
  const std::int64_t end = std::clamp<std::int64_t>(to - used.length / 2, begin, last);
  const auto hop = std::max<std::int64_t>(std::llround(used.length * (1.0 - used.overlap)), 1);
  const std::int64_t due = (end - begin) / hop + 1;
  const auto count = static_cast<int>(std::min<std::int64_t>(due, kMostSpectra));
  const double apart = count > 1 ? static_cast<double>(end - begin) / (count - 1) : 0.0;
  const int wanted = std::min(used.columns, count);
  columns.begin(samples.frames() >= used.length ? wanted : 0);
  for (int k = 0; k < count && spectra.columns > 0; ++k) {
    const auto at = begin + std::llround(apart * k);
    const int column = static_cast<int>(static_cast<std::int64_t>(k) * wanted / count);
    if (!columns.take(at, column)) return Error{message("the recording"), message("cannot be read again")};
    if (goOn && k % 64 == 0 && !goOn(static_cast<double>(k) / count))
      return Error{message("spectra"), message("stopped")};
  }
  const double width = static_cast<double>(end - begin + (count > 1 ? std::llround(apart) : hop)) / wanted;
  spectra.step = Seconds(width / rate.value);
  const double lead = count > 1 ? 0.5 * (width - apart) : 0.0;
  spectra.first = Seconds((static_cast<double>(begin) + 0.5 * used.length + lead) / rate.value);
  return spectra;
}

}  // namespace stillcut::evaluate
