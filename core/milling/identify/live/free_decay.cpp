#include "core/milling/identify/live/free_decay.h"

#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/FFT>

#include "core/milling/identify/live/hit_catcher.h"

namespace stillcut::identify {
namespace {

using Spectrum = std::vector<std::complex<double>>;

constexpr double kAfterPeak = 0.6e-3;  // [s] then the blow itself is over
constexpr double kLongestLag = 0.25;   // [s] of the autocorrelation: 4 Hz between lines
constexpr double kSignatureTo = 0.4;   // of the rate
constexpr std::size_t kSmoothed = 4;   // lines a magnitude is compared over

// The free part of a hit, from shortly after its largest sample.
std::vector<double> freePart(const HammerRecord& record) {
  const std::vector<double>& r = record.response;
  const auto peak = std::max_element(r.begin(), r.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  const auto skip = static_cast<std::ptrdiff_t>(std::ceil(kAfterPeak * record.rate));
  if (r.end() - peak <= skip + 32) return {};
  return {peak + skip, r.end()};
}

// Of one hit, of its own energy; lags 0 .. lags - 1.
void addAutocorrelation(const std::vector<double>& decay, std::vector<double>& sum) {
  const std::size_t size = decay.size() + sum.size();
  std::vector<double> padded(size + size % 2, 0.0);
  std::copy(decay.begin(), decay.end(), padded.begin());
  Eigen::FFT<double> fft;
  Spectrum spectrum;
  fft.fwd(spectrum, padded);
  for (auto& line : spectrum) line = std::norm(line);
  std::vector<double> correlation;
  fft.inv(correlation, spectrum);
  if (!(correlation[0] > 0.0)) return;
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += correlation[i] / correlation[0];
}

// One-sided: the lag 0, where sensor noise gathers, counts half as the integral does. Times i, so that a mode's peak
// lies where a compliance has it once the acceleration is integrated.
Frf halfSpectrum(std::vector<double> correlation, double rate, FrfQuantity quantity) {
  correlation[0] *= 0.5;
  Eigen::FFT<double> fft;
  Spectrum lines;
  fft.fwd(lines, correlation);
  Frf frf;
  frf.quantity = quantity;
  const double sign = quantity == FrfQuantity::Accelerance ? 1.0 : -1.0;
  for (std::size_t k = 1; k < correlation.size() / 2; ++k) {
    frf.frequency.push_back(static_cast<double>(k) * rate / static_cast<double>(correlation.size()));
    frf.value.push_back(std::complex<double>(0.0, sign) * lines[k]);
  }
  return frf;
}

}  // namespace

Result<DecayAnswer> analyseDecays(const std::vector<HammerRecord>& records, const ModalOptions& options) {
  if (records.empty()) return Error{message("free decay"), message("there is no hit")};
  const double rate = records.front().rate;
  auto lags = static_cast<std::size_t>(kLongestLag * rate);
  std::vector<std::vector<double>> decays;
  for (const HammerRecord& record : records) {
    if (std::abs(record.rate / rate - 1.0) > 1e-6) {
      return Error{record.source, message("differs in sampling rate from %1", records.front().source)};
    }
    decays.push_back(freePart(record));
    lags = std::min(lags, decays.back().size());
  }
  lags -= lags % 2;
  if (lags < 64) return Error{records.front().source, message("ends too soon after the hit")};
  std::vector<double> sum(lags, 0.0);
  for (const auto& decay : decays) addAutocorrelation(decay, sum);
  // Velocity or displacement are known by the caller's quantity; most sensors without a hammer feel acceleration.
  Frf frf = halfSpectrum(std::move(sum), rate, records.front().quantity);
  frf.source = records.front().source;
  auto fit = fitModes(frf, options);
  if (!fit) return fit.error();
  DecayAnswer answer;
  double softest = 0.0;
  for (const IdentifiedMode& m : fit->modes) {
    // The one-sided spectrum goes with the square of the amplitude: see the compliance's law in modal_band.h.
    const double flexibility = std::sqrt(m.depth) / m.mode.frequency.value;
    answer.modes.push_back({m.mode.frequency, m.mode.damping, m.frequencySd, m.dampingSd, flexibility});
    softest = std::max(softest, flexibility);
  }
  for (DecayMode& mode : answer.modes) mode.flexibility /= softest;
  answer.spectrum = toCompliance(frf);
  answer.fit = std::move(*fit);
  return answer;
}

std::vector<HammerRecord> cutDecays(const std::vector<double>& response, double rate, double length) {
  CatcherOptions options;
  options.length = length;
  HitCatcher catcher(rate, false, options);
  std::vector<double> whole = response;
  whole.resize(response.size() + static_cast<std::size_t>(length * rate), 0.0);  // the last hit may end early
  std::vector<HammerRecord> records;
  for (CaughtHit& hit : catcher.feed({}, whole, false)) {
    HammerRecord record;
    record.rate = rate;
    record.response = std::move(hit.response);
    records.push_back(std::move(record));
  }
  return records;
}

Spectrum decaySignature(const HammerRecord& record) {
  Eigen::FFT<double> fft;
  Spectrum lines;
  fft.fwd(lines, record.response);
  Spectrum out;
  double size = 0.0;
  const auto end = static_cast<std::size_t>(kSignatureTo * static_cast<double>(record.response.size()));
  for (std::size_t k = 1; k + kSmoothed < end; k += kSmoothed) {
    double power = 0.0;
    for (std::size_t i = 0; i < kSmoothed; ++i) power += std::norm(lines[k + i]);
    out.emplace_back(std::sqrt(power), 0.0);
    size += power;
  }
  for (auto& line : out) line /= std::sqrt(std::max(size, 1e-300));
  return out;
}

}  // namespace stillcut::identify
