// What was learned of a cut's stability from the judged cuts of its tool on its machine, as the Lobes page shows it.
// Plain values: any thread.
#pragma once

#include <QString>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "ui/facade/lobe_service.h"

namespace stillcut::ui {

// A judged cut: what was learned from.
struct LearnedCut {
  SpeedDepth at;
  bool chatter = false;
  Hertz frequency{}, frequencySd{};  // of the chatter; 0: not known
  std::int64_t wallS = 0;            // when, in seconds since 1970 UTC
};

struct LearnedAdvice {
  SpeedDepth at;
  double probabilityStable = 0.0;
};

struct LearnedLobes {
  enum class State {
    NotDescribed,  // the profile does not say what is cut: nothing can be kept of it
    NoCuts,        // none has been judged so far
    Failed,        // `problem` says why
    Known
  };
  State state = State::NotDescribed;
  QString problem;
  std::vector<LearnedCut> cuts;  // that count, by time
  int forgotten = 0;             // cuts of before the tool was changed
  std::vector<Rpm> speeds;
  std::vector<Metres> depths;
  std::vector<float> probability;  // of a stable cut, [speed * depths.size() + depth]
  double risk = 0.0;               // of chatter, that `best` may carry
  LearnedAdvice best;              // removes most at this risk
  LearnedAdvice next;              // the next most useful cut; speed 0: none could be named
  double gain = 0.0;               // of the removal rate, expected once the next cut is judged

  double at(std::size_t speed, std::size_t depth) const { return probability[speed * depths.size() + depth]; }
};

// How much deeper the stable cut that runs could go before it chatters, from its own free vibration.
struct DepthMargin {
  Metres rise{};         // median
  Metres low{}, high{};  // 10 and 90 %
  bool operator==(const DepthMargin&) const = default;
};

}  // namespace stillcut::ui
