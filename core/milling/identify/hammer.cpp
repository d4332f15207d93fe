#include "core/milling/identify/hammer.h"

#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/FFT>

#include "core/base/units.h"
#include "core/milling/identify/hammer_hits.h"

namespace stillcut::identify {
namespace {

using Spectrum = std::vector<std::complex<double>>;

// The hammer's spectrum carries information down to this part of its largest line (-45 dB: a sensor of 16 bits still
// leaves some 50 dB of range below that).
constexpr double kUsableShare = 0.0056;
// Above this the cut-off end of a response shows in the lines around it.
constexpr double kRingingThatMatters = 0.05;

Status checkOptions(const HammerOptions& options, const std::string& where) {
  const bool sane = options.trigger > 0.0 && options.trigger < 1.0 && options.doubleHit > 0.0 &&
                    options.exponentialEnd > 0.0 && options.exponentialEnd <= 1.0 && options.forceWindow >= 0.0 &&
                    options.duration >= 0.0 && options.separation > 0.0;
  if (!sane) return Error{where, message("an option of the hammer analysis is out of range")};
  return Done{};
}

Status checkRecord(const HammerRecord& record) {
  if (!(record.rate > 0.0) || !std::isfinite(record.rate)) {
    return Error{record.source, message("has no sampling rate")};
  }
  if (record.force.size() < 16 || record.force.size() != record.response.size()) {
    return Error{record.source, message("needs at least 16 samples of force and as many of response")};
  }
  const auto finite = [](double v) { return std::isfinite(v); };
  if (!std::all_of(record.force.begin(), record.force.end(), finite) ||
      !std::all_of(record.response.begin(), record.response.end(), finite)) {
    return Error{record.source, message("holds a value that is not finite")};
  }
  return Done{};
}

// Lengths whose prime factors are 2, 3 and 5 keep the transform quick.
std::size_t roundLength(std::size_t n) {
  for (;; ++n) {
    std::size_t rest = n;
    for (const std::size_t p : {2u, 3u, 5u}) {
      while (rest % p == 0) rest /= p;
    }
    if (rest == 1 && n % 2 == 0) return n;
  }
}

// Samples begin..end without the mean of what came before the pulse, zeros behind.
std::vector<double> cutOut(const std::vector<double>& signal, const FoundHit& hit, std::size_t length) {
  double mean = 0.0;
  for (std::size_t i = hit.quietFrom; i < hit.quietEnd; ++i) mean += signal[i];
  if (hit.quietEnd > hit.quietFrom) mean /= static_cast<double>(hit.quietEnd - hit.quietFrom);
  std::vector<double> out(length, 0.0);
  for (std::size_t i = hit.begin; i < hit.end; ++i) out[i - hit.begin] = signal[i] - mean;
  return out;
}

void applyForceWindow(std::vector<double>& force, std::size_t peak, std::size_t hold) {
  const std::size_t taper = std::max<std::size_t>(hold / 2, 1);
  for (std::size_t i = peak + hold; i < force.size(); ++i) {
    const double t = static_cast<double>(i - peak - hold) / static_cast<double>(taper);
    force[i] *= t < 1.0 ? 0.5 * (1.0 + std::cos(0.5 * kTwoPi * t)) : 0.0;
  }
}

void applyDecay(std::vector<double>& signal, double decay, double rate) {
  for (std::size_t i = 0; i < signal.size(); ++i) signal[i] *= std::exp(-decay * static_cast<double>(i) / rate);
}

struct Sums {
  std::vector<double> force, response;  // auto spectra
  Spectrum cross;                       // conj(F) X
};

void accumulate(Sums& sums, const std::vector<double>& force, const std::vector<double>& response) {
  Eigen::FFT<double> fft;
  Spectrum f;
  Spectrum x;
  fft.fwd(f, force);
  fft.fwd(x, response);
  const std::size_t lines = force.size() / 2 + 1;
  sums.force.resize(lines, 0.0);
  sums.response.resize(lines, 0.0);
  sums.cross.resize(lines, 0.0);
  for (std::size_t k = 0; k < lines; ++k) {
    sums.force[k] += std::norm(f[k]);
    sums.response[k] += std::norm(x[k]);
    sums.cross[k] += std::conj(f[k]) * x[k];
  }
}

void add(Sums& sums, const Sums& more) {
  sums.force.resize(more.force.size(), 0.0);
  sums.response.resize(more.response.size(), 0.0);
  sums.cross.resize(more.cross.size(), 0.0);
  for (std::size_t k = 0; k < more.force.size(); ++k) {
    sums.force[k] += more.force[k];
    sums.response[k] += more.response[k];
    sums.cross[k] += more.cross[k];
  }
}

// Lines with no force at all would divide by nothing: the spectrum ends before them.
Frf estimate(const Sums& sums, double resolution, int averages, FrfEstimate kind) {
  Frf frf;
  const double strongest = *std::max_element(sums.force.begin(), sums.force.end());
  bool usable = true;
  for (std::size_t k = 0; k < sums.force.size(); ++k) {
    if (sums.force[k] < strongest * kUsableShare * kUsableShare) usable = false;
    if (sums.force[k] < strongest * 1e-20) break;
    const bool second = kind == FrfEstimate::H2 && std::norm(sums.cross[k]) > 0.0;
    frf.frequency.push_back(static_cast<double>(k) * resolution);
    frf.value.push_back(second ? sums.response[k] / std::conj(sums.cross[k]) : sums.cross[k] / sums.force[k]);
    if (usable) frf.usableTo = frf.frequency.back();
    if (averages < 2) continue;
    const double both = sums.force[k] * sums.response[k];
    frf.coherence.push_back(both > 0.0 ? std::min(1.0, std::norm(sums.cross[k]) / both) : 0.0);
  }
  return frf;
}

// A record ready to be analysed, with its hits.
struct Prepared {
  HammerRecord record;
  std::vector<FoundHit> hits;
};

template <class T>
void turn(std::vector<T>& signal) {
  for (T& v : signal) v = -v;
}

// A hammer pushes for a thousandth of the time: the middle value of its force is the offset of its channel.
void takeOffsetOff(std::vector<double>& force) {
  std::vector<double> sorted = force;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  const double offset = *middle;
  for (double& v : force) v -= offset;
}

// Pulses of a hammer push one way; where the other way is twice as high the channel counts a push as negative.
bool pushesNegative(const std::vector<double>& force) {
  const auto [lowest, highest] = std::minmax_element(force.begin(), force.end());
  return -*lowest > 2.0 * std::max(*highest, 0.0);
}

Result<std::vector<Prepared>> prepare(const std::vector<HammerRecord>& records, const HammerOptions& options,
                                      HammerResult& result) {
  std::vector<Prepared> all;
  bool turned = false;
  for (const HammerRecord& record : records) {
    if (const Status sound = checkRecord(record); !sound) return sound.error();
    if (std::abs(record.rate / records.front().rate - 1.0) > 1e-6 || record.quantity != records.front().quantity) {
      return Error{record.source, message("differs in sampling rate or quantity from %1", records.front().source),
                   message("hits that are averaged need the same")};
    }
    Prepared one{record, {}};
    takeOffsetOff(one.record.force);
    const bool negative = !options.flipForce && pushesNegative(one.record.force);
    turned = turned || negative;
    if (options.flipForce || negative) turn(one.record.force);
    if (options.flipResponse) turn(one.record.response);
    one.hits = findHits(one.record, options);
    for (FoundHit& found : one.hits) found.hit.record = all.size();
    all.push_back(std::move(one));
  }
  if (turned) result.remarks.push_back(message("the force counts a push as negative: turned"));
  return all;
}

Message faultOf(const Hit& hit) {
  if (hit.unwanted) return message("as asked");
  if (hit.alongOther) return message("it went along the other axis");
  if (hit.forceOverload) return message("overload of the force");
  if (hit.responseOverload) return message("overload of the response");
  if (hit.begun) return message("the record begins inside the pulse: record some milliseconds before the trigger");
  return message("double hit");
}

Status judge(std::vector<Prepared>& all, const HammerOptions& options, HammerResult& result) {
  int number = 0;
  for (Prepared& one : all) {
    for (FoundHit& found : one.hits) {
      ++number;
      Hit& hit = found.hit;
      const auto isIn = [number](const std::vector<int>& hits) {
        return std::find(hits.begin(), hits.end(), number) != hits.end();
      };
      hit.unwanted = isIn(options.without);
      hit.alongOther = isIn(options.alongOther);
      const bool tolerated = !hit.doubleHit || options.useDoubleHits;
      hit.used =
          !hit.unwanted && !hit.alongOther && !hit.forceOverload && !hit.responseOverload && !hit.begun && tolerated;
      if (!hit.used) result.remarks.push_back(message("hit %1 left out: %2", number, faultOf(hit)));
      if (hit.used && hit.doubleHit) result.remarks.push_back(message("hit %1 is a double hit, used as asked", number));
      if (hit.used) ++result.averages;
      result.hits.push_back(hit);
    }
  }
  const std::string& where = all.front().record.source;
  for (const int asked : options.without) {
    if (asked >= 1 && asked <= number) continue;
    return Error{where, message("there is no hit %1", asked), message("it holds %1 hits", number)};
  }
  if (number == 0) return Error{where, message("holds no hit"), message("force never positive; a flipped channel?")};
  if (result.averages == 0) {
    return Error{where, message("holds no usable hit"), result.remarks.empty() ? Message() : result.remarks.back()};
  }
  if (result.averages == 1) result.remarks.push_back(message("one hit only: no coherence"));
  return Done{};
}

// How much of the largest response is left at the end of what is analysed.
double ringingAtEnd(const std::vector<double>& response, std::size_t span) {
  double largest = 0.0;
  for (std::size_t i = 0; i < span; ++i) largest = std::max(largest, std::abs(response[i]));
  const std::size_t tail = std::max<std::size_t>(span / 20, 1);
  double power = 0.0;
  for (std::size_t i = span - tail; i < span; ++i) power += response[i] * response[i];
  return largest > 0.0 ? std::sqrt(2.0 * power / static_cast<double>(tail)) / largest : 0.0;
}

// A driving point takes power in: the imaginary part of its compliance is negative wherever it moves.
bool takesPowerOut(const Frf& frf) {
  const Frf compliance = toCompliance(frf);
  double sum = 0.0;
  double size = 0.0;
  for (std::size_t i = 0; i < compliance.frequency.size(); ++i) {
    if (frf.usableTo > 0.0 && compliance.frequency[i] > frf.usableTo) break;
    const double power = compliance.frequency[i] * compliance.frequency[i] * compliance.value[i].imag();
    sum += power;
    size += std::abs(power);
  }
  return sum > 0.5 * size;
}

// What is analysed of each hit.
struct Span {
  std::size_t samples = 0;  // all hits over the same, the shortest one's, so that their lines coincide
  std::size_t length = 0;   // with zeros behind, for the transform
  double decay = 0.0;       // of the exponential window [1/s]
};

Span spanOf(const std::vector<Prepared>& all, const HammerOptions& options) {
  Span span;
  for (const Prepared& one : all) {
    for (const FoundHit& found : one.hits) {
      if (!found.hit.used) continue;
      const std::size_t size = found.end - found.begin;
      span.samples = span.samples == 0 ? size : std::min(span.samples, size);
    }
  }
  span.length = roundLength(span.samples);
  if (options.exponentialEnd < 1.0) {
    span.decay = -std::log(options.exponentialEnd) * all.front().record.rate / static_cast<double>(span.samples);
  }
  return span;
}

// Adds one hit to the sums; how much its response still rings at the end.
double addHit(const HammerRecord& record, FoundHit found, const Span& span, const HammerOptions& options, Sums& sums) {
  found.end = found.begin + span.samples;
  std::vector<double> force = cutOut(record.force, found, span.length);
  std::vector<double> response = cutOut(record.response, found, span.length);
  if (options.forceWindow > 0.0) {
    applyForceWindow(force, found.peak - found.begin, static_cast<std::size_t>(options.forceWindow * record.rate));
  }
  // Both channels, so that their ratio stays the response of a linear system with more damping.
  applyDecay(force, span.decay, record.rate);
  applyDecay(response, span.decay, record.rate);
  accumulate(sums, force, response);
  return ringingAtEnd(response, span.samples);
}

bool pointsAgainstForce(const Sums& sums, const HammerRecord& record, const Span& span) {
  Frf frf = estimate(sums, record.rate / static_cast<double>(span.length), 1, FrfEstimate::H1);
  frf.quantity = record.quantity;
  frf.addedDecay = span.decay;
  return takesPowerOut(frf);
}

Message whatWasTurned(const std::vector<std::string>& turned, std::size_t records) {
  if (turned.size() == records) return message("the response points against the force: turned");
  std::string names;
  for (const std::string& name : turned) names += (names.empty() ? "" : ", ") + name;
  return message("the response points against the force in %1, and not in the other records: turned there", names);
}

}  // namespace

Result<HammerResult> analyseHammer(const std::vector<HammerRecord>& records, const HammerOptions& options) {
  if (records.empty()) return Error{message("hammer analysis"), message("there is no record")};
  if (const Status sane = checkOptions(options, records.front().source); !sane) return sane.error();
  HammerResult result;
  auto all = prepare(records, options, result);
  if (!all) return all.error();
  if (const Status judged = judge(*all, options, result); !judged) return judged.error();
  const Span span = spanOf(*all, options);
  Sums sums;
  double ringing = 0.0;
  std::vector<std::string> turned;  // records whose sensor sits against the force
  for (const Prepared& one : *all) {
    Sums own;
    for (const FoundHit& found : one.hits) {
      if (found.hit.used) ringing = std::max(ringing, addHit(one.record, found, span, options, own));
    }
    if (own.force.empty()) continue;
    if (!options.flipResponse && pointsAgainstForce(own, one.record, span)) {
      turn(own.cross);
      turned.push_back(one.record.source);
    }
    add(sums, own);
  }
  const HammerRecord& first = records.front();
  result.frf = estimate(sums, first.rate / static_cast<double>(span.length), result.averages, options.estimate);
  result.frf.quantity = first.quantity;
  result.frf.axis = first.axis;
  result.frf.addedDecay = span.decay;
  result.frf.source = first.source;
  if (ringing > kRingingThatMatters) {
    result.remarks.push_back(
        message("the response still rings with %1 % of its largest at the end: measure longer, or "
                "give --exponential 0.01",
                std::lround(100.0 * ringing)));
  }
  // What no record says by itself for noise, all of them may say together.
  if (!options.flipResponse && turned.empty() && takesPowerOut(result.frf)) {
    for (auto& v : result.frf.value) v = -v;
    for (const HammerRecord& record : records) turned.push_back(record.source);
  }
  if (!turned.empty()) result.remarks.push_back(whatWasTurned(turned, all->size()));
  return result;
}

}  // namespace stillcut::identify
