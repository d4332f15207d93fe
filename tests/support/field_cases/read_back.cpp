#include "tests/support/field_cases/read_back.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace stillcut::field {
namespace {

constexpr double kRateTolerance = 1e-3;
constexpr double kSame = 0.99;  // correlation; the axes of a cut differ by less

double mean(std::span<const float> x) {
  double sum = 0.0;
  for (const float v : x) sum += static_cast<double>(v);
  return sum / static_cast<double>(x.size());
}

// 0 where one of them is constant.
double correlation(std::span<const float> a, std::span<const float> b) {
  const std::size_t n = std::min(a.size(), b.size());
  if (n == 0) return 0.0;
  const double meanA = mean(a.first(n)), meanB = mean(b.first(n));
  double ab = 0.0, aa = 0.0, bb = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const double u = static_cast<double>(a[i]) - meanA, v = static_cast<double>(b[i]) - meanB;
    ab += u * v;
    aa += u * u;
    bb += v * v;
  }
  return aa > 0.0 && bb > 0.0 ? ab / std::sqrt(aa * bb) : 0.0;
}

bool constant(std::span<const float> x) {
  return std::all_of(x.begin(), x.end(), [&](float v) { return v == x.front(); });
}

// Sample by sample as the blocks' times place them; what is missing between two keeps the last value.
Result<std::vector<std::vector<float>>> samplesOf(record::RecordingReader& reader) {
  constexpr int kFrames = 256;
  const record::RecordingFormat& format = reader.format();
  std::vector<std::vector<float>> all(format.channels.size());
  SampleBlock block;
  block.allocate(static_cast<int>(all.size()), kFrames);
  Result<bool> more = reader.read(block);
  for (; more && *more; more = reader.read(block)) {
    const auto from = static_cast<std::size_t>(std::llround(sinceEpoch(block.firstSample).value * format.rate.value));
    for (std::size_t c = 0; c < all.size(); ++c) {
      if (from > all[c].size()) all[c].resize(from, all[c].empty() ? 0.0F : all[c].back());
      const auto samples = block.channel(static_cast<int>(c));
      all[c].insert(all[c].end(), samples.begin(), samples.end());
    }
  }
  if (!more) return more.error();
  return all;
}

}  // namespace

std::string misreading(record::RecordingReader& reader, const Signal& signal) {
  const double rate = reader.format().rate.value;
  if (std::abs(rate / signal.rate - 1.0) > kRateTolerance) return "read at " + std::to_string(rate) + " Hz";
  const auto read = samplesOf(reader);
  if (!read) return read.error().line();
  std::size_t same = 0, other = 0;
  for (const std::vector<float>& channel : *read) {
    const bool found = std::any_of(signal.channels.begin(), signal.channels.end(),
                                   [&](const auto& of) { return correlation(channel, of) >= kSame; });
    same += found ? 1 : 0;
    other += found || constant(channel) ? 0 : 1;
  }
  if (same == signal.channels.size() && other == 0) return "";
  return "read " + std::to_string(same) + " of " + std::to_string(signal.channels.size()) + " channels and " +
         std::to_string(other) + " that are none";
}

}  // namespace stillcut::field
