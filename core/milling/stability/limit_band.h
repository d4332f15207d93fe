// How sure a limit is: the same lobes for cuts drawn at random around the one that was measured. Every mode's
// frequency, damping and stiffness and the force coefficients get independent normal errors with the standard
// deviations given; the band holds the middle 80 % of the limits drawn. By sampling, and not to first order, because at
// a lobe's edge the limit is anything but linear in the frequency. The draws are the same at every speed and in every
// run. Thread: any; allocates, as long as `samples` sweeps for the first limit.
#pragma once

#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/milling/cut_model.h"

namespace stillcut::milling {

// Standard deviations over the value, 0 .. 0.5 each.
struct ModelSpread {
  double frequency = 0.0, damping = 0.0, stiffness = 0.0;  // of every mode on its own
  double force = 0.0;                                      // of all force coefficients together
  double processDamping = 0.0;                             // besides, of the process damping
  int samples = 24;                                        // 8 .. 1000
  bool any() const {
    return frequency > 0.0 || damping > 0.0 || stiffness > 0.0 || force > 0.0 || processDamping > 0.0;
  }
};
Status check(const ModelSpread& spread, const std::string& where);

// The cuts drawn, the same in every run; and how many of them lie on either side of the band.
std::vector<CutModel> drawnModels(const CutModel& model, const ModelSpread& spread);
std::size_t outsideBand(const ModelSpread& spread);

struct LimitBand {
  Rpm speed{};
  Metres low{}, high{};  // where nothing limits a draw, the depth searched counts
};

struct LimitBands {
  std::vector<LimitBand> speeds;  // in the order asked for
  bool finished = false;          // false: stopped
};

Result<LimitBands> limitBands(const CutModel& model, std::span<const Rpm> speeds, Metres maxAxialDepth,
                              const ModelSpread& spread, int threads, const std::string& where,
                              const std::stop_token& stop = {});

}  // namespace stillcut::milling
