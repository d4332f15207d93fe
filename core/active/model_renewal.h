// ModelRenewal: whether an estimate that was made while the control was on may take the place of the model. It becomes
// a recursive model of the same lengths and delay, and is held against the next estimate, which knows nothing of it:
// from that one's impulse response both it and the estimate it was made from must be half as far as the old model, in
// energy (both see the noise of that estimate; a good old model is as far as that alone, another estimate of the same
// path twice as far), and on no line to quieten may it be farther from it than the old one. It must pass checkPath()
// and change the phase on these lines by no more than 60 degrees at once: that far the old model is still driven the
// right way while the weights follow. Thread: not the loop's; allocates.
#pragma once

#include <optional>
#include <vector>

#include "core/active/path_model.h"

namespace stillcut::active {

class ModelRenewal {
 public:
  void prepare(const PathModel& model, std::vector<Hertz> lines, Hertz rate);
  // One estimate after the other (OnlineIdentifier::takeEstimate). Gives the model that is in force from now on.
  std::optional<PathModel> judge(const std::vector<double>& impulse);

 private:
  PathModel model_;
  std::vector<Hertz> lines_;
  Hertz rate_{};
  std::vector<double> before_;  // the estimate before this one
};

}  // namespace stillcut::active
