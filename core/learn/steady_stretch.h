// From the samples and verdicts of a run to a stretch of a stable steady cut at one speed, without a gap, long enough
// for its free vibration to be heard. What is not judged, alarms, is forced vibration alone, or changes its speed, ends
// the stretch. Thread: one; looked at some tens of times a second, never on the sample path.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/model/sample_block.h"
#include "core/model/verdict.h"

namespace stillcut::learn {

struct StretchParams {
  Seconds length{5.0};         // of a stretch
  double speedChange = 0.002;  // of the speed, that ends it [1]
};

struct SteadyStretch {
  Hertz rate{};
  Rpm speed{};                                // mean
  std::vector<std::vector<double>> channels;  // in device units, all of one length
};

class StretchCollector {
 public:
  // `channels`: those that a vibration is heard on, by number.
  explicit StretchCollector(std::vector<int> channels, const StretchParams& params = {})
      : params_(params), channels_(std::move(channels)) {}

  // Every block, in order; a missing one ends the stretch.
  void add(const SampleBlock& block);
  // The newest verdict of the detector in charge. False: it has ended the stretch.
  bool look(const Verdict& verdict);
  // A stretch that is long enough, once; the next one begins.
  std::optional<SteadyStretch> take();

 private:
  void begin();

  StretchParams params_;
  std::vector<int> channels_;
  SteadyStretch stretch_;
  double speedSum_ = 0.0;  // rev/min
  int looks_ = 0;
  std::optional<std::uint64_t> last_;  // sequence of the newest block
};

}  // namespace stillcut::learn
