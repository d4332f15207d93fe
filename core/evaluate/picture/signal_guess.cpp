#include "core/evaluate/picture/signal_guess.h"

#include <algorithm>
#include <cmath>

#include "core/dsp/spectrum.h"
#include "core/spindle/line_list.h"
#include "core/spindle/two_series.h"

namespace stillcut::evaluate {
namespace {

constexpr double kWindow_s = 0.8;         // of one spectrum: a spindle wanders more in a longer one
constexpr int kMostWindows = 60;          // evenly over the recording
constexpr std::size_t kMostChannels = 3;  // the first
constexpr double kSlowest = 4.0;          // Hz
constexpr double kFastest = 700.0;        // Hz
constexpr double kStep = 4e-4;            // of one speed to the next
constexpr double kToldReach = 0.05;       // around the nominal speed
constexpr double kHeardReach = 0.01;      // around what the detector found
constexpr double kNearlyAsGood = 0.8;     // a rival
constexpr double kNeighbours = 0.02;      // one speed, not two
constexpr double kLeastExplained = 0.5;   // of the lines' weight
constexpr double kMostExplained = 0.7;    // by a speed in another unit than was told
constexpr std::size_t kMostRivals = 3;
constexpr double kTeethCarry = 0.7;  // of what stands on the orders
constexpr int kMostTeeth = 12;

// The power of every bin, averaged over the louder half of the windows.
std::vector<double> loudHalf(const SampleStore& samples, int channel, dsp::Spectrum& spectrum,
                             const std::function<bool()>& goOn) {
  const int length = spectrum.segment();
  const std::int64_t last = samples.frames() - length;
  if (last < 0) return {};
  const auto count = static_cast<int>(std::min<std::int64_t>(last / (length / 2) + 1, kMostWindows));
  std::vector<float> raw(static_cast<std::size_t>(length));
  std::vector<double> taken(raw.size());
  std::vector<std::pair<double, std::vector<double>>> all;
  for (int k = 0; k < count; ++k) {
    if (goOn && !goOn()) return {};
    const std::int64_t at = count > 1 ? last * k / (count - 1) : 0;
    if (!samples.read(channel, at, raw)) return {};
    double mean = 0.0;
    for (const float v : raw) mean += v;
    if (!std::isfinite(mean)) continue;
    mean /= length;
    for (std::size_t i = 0; i < raw.size(); ++i) taken[i] = raw[i] - mean;
    spectrum.transform(taken);
    std::vector<double> power(static_cast<std::size_t>(spectrum.bins()));
    spectrum.powers(power);
    double sum = 0.0;
    for (const double p : power) sum += p;
    all.emplace_back(sum, std::move(power));
  }
  if (all.empty()) return {};
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<double> mean(static_cast<std::size_t>(spectrum.bins()), 0.0);
  for (std::size_t k = 0; k < (all.size() + 1) / 2; ++k) {
    for (std::size_t b = 0; b < mean.size(); ++b) mean[b] += all[k].second[b];
  }
  return mean;
}

struct Scored {
  double hertz = 0.0, score = 0.0;
};

// The speeds at which the score is higher than around them, best first.
std::vector<Scored> peaksOf(const detect::TwoSeries& lines, double low, double high) {
  std::vector<Scored> grid;
  for (double f = low; f <= high; f *= 1.0 + kStep) grid.push_back({f, lines.fit(Hertz(f)).score});
  std::vector<Scored> peaks;
  for (std::size_t k = 1; k + 1 < grid.size(); ++k) {
    if (grid[k].score >= grid[k - 1].score && grid[k].score > grid[k + 1].score) peaks.push_back(grid[k]);
  }
  std::sort(peaks.begin(), peaks.end(), [](const Scored& a, const Scored& b) { return a.score > b.score; });
  return peaks;
}

void addRivals(const detect::TwoSeries& lines, double highest, const Scored& best, SignalGuess& guess) {
  std::vector<Scored> rivals;
  for (const Scored& p : peaksOf(lines, kSlowest, highest)) {
    const auto near = [&p](const Scored& q) { return std::abs(p.hertz / q.hertz - 1.0) < kNeighbours; };
    if (p.score < kNearlyAsGood * best.score || rivals.size() == kMostRivals) break;
    if (near(best) || std::any_of(rivals.begin(), rivals.end(), near)) continue;
    rivals.push_back(p);
    guess.speedRivals.emplace_back(60.0 * p.hertz);
  }
}

// Power on the lines of a harmonic series, the main lobe of each.
double powerOn(const std::vector<double>& power, double binWidth, double spacing) {
  double sum = 0.0;
  for (int n = 1;; ++n) {
    const auto bin = static_cast<std::ptrdiff_t>(std::lround(n * spacing / binWidth));
    if (bin + 2 >= static_cast<std::ptrdiff_t>(power.size())) return sum;
    for (std::ptrdiff_t b = std::max<std::ptrdiff_t>(bin - 1, 0); b <= bin + 1; ++b)
      sum += power[static_cast<std::size_t>(b)];
  }
}

void guessTeeth(const std::vector<double>& power, double binWidth, double spindle, SignalGuess& guess) {
  const double all = powerOn(power, binWidth, spindle);
  if (!(all > 0.0)) return;
  std::vector<int> fitting;
  for (int z = kMostTeeth; z >= 2; --z) {
    if (powerOn(power, binWidth, z * spindle) > kTeethCarry * all) fitting.push_back(z);
  }
  if (fitting.empty()) return;
  guess.teeth = fitting.front();
  guess.teethRivals.assign(fitting.begin() + 1, fitting.end());
  if (guess.teethRivals.size() > kMostRivals) guess.teethRivals.resize(kMostRivals);
}

}  // namespace

SignalGuess guessFromSignal(const SampleStore& samples, const GuessRequest& request,
                            const std::function<bool()>& goOn) {
  SignalGuess guess;
  const int length = dsp::goodFftSize(static_cast<int>(request.rate.value * kWindow_s));
  if (request.rate.value <= 0.0 || samples.frames() < length) return guess;
  dsp::Spectrum spectrum;
  spectrum.prepare(length, request.rate, dsp::WindowKind::Hann);
  const double width = spectrum.binWidth();
  detect::TwoSeries lines;
  lines.begin(Hertz(0.3 * width));
  detect::LineList list;
  list.prepare(spectrum.bins(), Hertz(width));
  std::vector<double> all(static_cast<std::size_t>(spectrum.bins()), 0.0);
  std::size_t used = 0;
  for (const int channel : request.channels) {
    if (++used > kMostChannels) break;
    const std::vector<double> power = loudHalf(samples, channel, spectrum, goOn);
    if (power.empty()) continue;
    for (std::size_t b = 0; b < all.size(); ++b) all[b] += power[b];
    list.find(power, Hertz(2.0 * width), Hertz(0.45 * request.rate.value));
    lines.add(list.lines());
  }
  if (lines.lines() == 0 || (goOn && !goOn())) return guess;
  const bool isTold = request.told.value > 0.0;
  const double centre = (isTold ? request.told : request.heard).value / 60.0;
  const double reach = isTold ? kToldReach : kHeardReach;
  if (!(centre > 0.0)) return guess;
  const auto near = [&lines](double hertz, double around, double least) {
    std::vector<Scored> found = peaksOf(lines, hertz * (1.0 - around), hertz * (1.0 + around));
    if (!found.empty() && lines.explained(Hertz(found.front().hertz)) < least) found.clear();
    return found;
  };
  // The number in revolutions a second first: the orders of a spindle so slow as it says stand so close that any line
  // is near one. The other way round the slow cutter's teeth leave most of these places empty.
  std::vector<Scored> peaks;
  const double perSecond = request.told.value;
  if (isTold && perSecond > kSlowest && perSecond < kFastest) peaks = near(perSecond, kHeardReach, kMostExplained);
  if (peaks.empty()) peaks = near(centre, reach, kLeastExplained);
  if (peaks.empty()) return guess;
  const Scored& best = peaks.front();
  guess.speed = Rpm(60.0 * best.hertz);
  guess.doubt = Rpm(60.0 * std::max(0.1 * width, 0.5 * kStep * best.hertz));
  if (isTold) {
    guessTeeth(all, width, best.hertz, guess);
  } else {
    addRivals(lines, std::min(kFastest, 0.2 * request.rate.value), best, guess);
  }
  return guess;
}

}  // namespace stillcut::evaluate
