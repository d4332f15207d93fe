#include "core/milling/identify/hammer_hits.h"

#include <algorithm>
#include <cmath>

namespace stillcut::identify {
namespace {

constexpr double kFoot = 0.05;  // of the peak

// One stretch of force above the trigger.
struct Pulse {
  std::size_t peak = 0;
  std::size_t rise = 0;  // where the force leaves a twentieth of its peak
  std::size_t fall = 0;  // where it has come back to it
};

std::size_t samples(double seconds, double rate) {
  return static_cast<std::size_t>(std::max(0.0, std::round(seconds * rate)));
}

Pulse pulseAround(const std::vector<double>& force, std::size_t peak) {
  const double foot = kFoot * force[peak];
  Pulse pulse{peak, peak, peak};
  while (pulse.rise > 0 && force[pulse.rise] > foot) --pulse.rise;
  while (pulse.fall + 1 < force.size() && force[pulse.fall] > foot) ++pulse.fall;
  return pulse;
}

std::vector<Pulse> findPulses(const std::vector<double>& force, double level) {
  std::vector<Pulse> pulses;
  for (std::size_t i = 0; i < force.size();) {
    if (force[i] < level) {
      ++i;
      continue;
    }
    std::size_t peak = i;
    std::size_t end = i;
    while (end < force.size() && force[end] >= level) {
      if (force[end] > force[peak]) peak = end;
      ++end;
    }
    const Pulse pulse = pulseAround(force, peak);
    pulses.push_back(pulse);
    i = std::max(end, pulse.fall + 1);
  }
  return pulses;
}

// Where nobody says the limit of the input: a flat top. A round one holds its very largest value once, or twice where
// two samples lie even on both sides of it: three in a row are none. A response that rings meets the limit again and
// again: three samples anywhere. Values that are coarse (an oscilloscope's 8 bits) are equal without any limit: there
// it takes four in a row.
constexpr double kSame = 1e-6;    // of the largest
constexpr double kCoarse = 1e-3;  // of the largest, between two values
constexpr int kFlatCoarse = 4, kFlatForce = 3, kFlatResponse = 3;

bool isClipped(const std::vector<double>& signal, std::size_t begin, std::size_t end, double limit, bool rings) {
  double largest = 0.0;
  for (std::size_t i = begin; i < end; ++i) largest = std::max(largest, std::abs(signal[i]));
  if (largest == 0.0) return false;
  if (limit > 0.0) return largest >= limit;
  double step = largest;
  int run = 0, longest = 0, all = 0;
  for (std::size_t i = begin; i < end; ++i) {
    const bool top = std::abs(signal[i]) >= largest * (1.0 - kSame);
    run = top ? run + 1 : 0;
    longest = std::max(longest, run);
    all += top ? 1 : 0;
    const double difference = i > begin ? std::abs(signal[i] - signal[i - 1]) : 0.0;
    if (difference > 0.0) step = std::min(step, difference);
  }
  if (step > kCoarse * largest) return longest >= kFlatCoarse;
  return rings ? all >= kFlatResponse : longest >= kFlatForce;
}

// The last quarter of the time since the hit before, or all before the first. A record that begins just before the hit
// leaves what lies well before the force leaves a hundredth of its peak; where that is next to nothing no offset can be
// known, and none is taken off.
void setQuiet(FoundHit& found, const std::vector<double>& force, const Pulse& pulse, std::size_t before) {
  constexpr std::size_t kFew = 3;
  constexpr double kStill = 0.01;  // of the peak
  found.quietFrom = before > 0 ? pulse.rise - (pulse.rise - before) / 4 : 0;
  found.quietEnd = found.begin;
  if (found.begin >= found.quietFrom + kFew) return;
  std::size_t still = pulse.rise;
  while (still > 0 && force[still] > kStill * force[pulse.peak]) --still;
  const std::size_t margin = 2 * (pulse.rise - still);
  found.quietEnd = still > margin + found.quietFrom + kFew ? still - margin : found.quietFrom;
}

double responseSize(const std::vector<double>& response, const FoundHit& found) {
  double mean = 0.0;
  for (std::size_t i = found.quietFrom; i < found.quietEnd; ++i) mean += response[i];
  if (found.quietEnd > found.quietFrom) mean /= static_cast<double>(found.quietEnd - found.quietFrom);
  double power = 0.0;
  for (std::size_t i = found.begin; i < found.end; ++i) power += (response[i] - mean) * (response[i] - mean);
  return std::sqrt(power / static_cast<double>(std::max<std::size_t>(found.end - found.begin, 1)));
}

double halfWidth(const std::vector<double>& force, std::size_t peak, double rate) {
  std::size_t a = peak;
  std::size_t b = peak;
  while (a > 0 && force[a] > 0.5 * force[peak]) --a;
  while (b + 1 < force.size() && force[b] > 0.5 * force[peak]) ++b;
  return static_cast<double>(b - a) / rate;
}

// Largest force after the pulse, once the ringing of the force channel (as long again as the pulse) is over.
bool hasSecondPulse(const std::vector<double>& force, const Pulse& pulse, std::size_t end, double share) {
  const std::size_t length = pulse.fall - pulse.rise;
  for (std::size_t i = pulse.fall + length / 2; i < end; ++i) {
    if (force[i] > share * force[pulse.peak]) return true;
  }
  return false;
}

}  // namespace

std::vector<FoundHit> findHits(const HammerRecord& record, const HammerOptions& options) {
  const std::vector<double>& force = record.force;
  const double largest = *std::max_element(force.begin(), force.end());
  std::vector<FoundHit> hits;
  if (!(largest > 0.0)) return hits;
  const std::vector<Pulse> pulses = findPulses(force, options.trigger * largest);
  const std::size_t apart = samples(options.separation, record.rate);
  std::vector<Pulse> first;  // of each hit
  std::size_t last = 0;
  for (const Pulse& pulse : pulses) {
    if (first.empty() || pulse.peak - last > apart) first.push_back(pulse);
    last = pulse.peak;
  }
  for (std::size_t k = 0; k < first.size(); ++k) {
    const Pulse& pulse = first[k];
    FoundHit found;
    found.peak = pulse.peak;
    const std::size_t lead = pulse.fall - pulse.rise;
    found.begin = pulse.rise > lead ? pulse.rise - lead : 0;
    setQuiet(found, force, pulse, k > 0 ? first[k - 1].fall : 0);
    const std::size_t nextRise = k + 1 < first.size() ? first[k + 1].rise : force.size();
    const std::size_t nextLead = k + 1 < first.size() ? first[k + 1].fall - first[k + 1].rise : 0;
    found.end = std::max(nextRise > nextLead ? nextRise - nextLead : 0, pulse.fall);
    if (options.duration > 0.0) {
      found.end = std::min(found.end, found.begin + samples(options.duration, record.rate));
    }
    found.hit.time = static_cast<double>(pulse.peak) / record.rate;
    found.hit.peakForce = force[pulse.peak];
    found.hit.width = halfWidth(force, pulse.peak, record.rate);
    found.hit.begun = pulse.rise == 0 && force[0] > kFoot * force[pulse.peak];
    found.hit.doubleHit = hasSecondPulse(force, pulse, found.end, options.doubleHit);
    found.hit.forceOverload = isClipped(force, found.begin, found.end, options.overload, false);
    found.hit.responseOverload = isClipped(record.response, found.begin, found.end, options.overload, true);
    found.hit.response = responseSize(record.response, found);
    hits.push_back(found);
  }
  return hits;
}

}  // namespace stillcut::identify
