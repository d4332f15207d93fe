// Which speeds to take: the stable pockets of a speed range at one depth, from the exact lobes; and where there is
// none, the largest stable depth of the range. What screens show and strategies choose from. Thread: any; a second or
// less for a usual range. Allocates; not for the sample path.
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/milling/stability/exact_lobes.h"
#include "core/milling/stability/forced_vibration.h"
#include "core/milling/stability/limit_band.h"

namespace stillcut::milling {

struct AdviceRequest {
  Metres depth{};                      // axial depth of the cut
  Rpm lowest{}, highest{};             // what the machine allows
  Metres feedPerTooth{};               // for the removal rate; 0: none is given
  std::optional<double> cuttingSpeed;  // largest of the tool [m/min]; speeds above it are no advice
  int steps = 200;                     // speeds looked at before the edges are refined, 8 .. 5000; more where
                                       // the lobes are narrow
  int threads = 2;
  // How well the model is known: with any doubt every limit below is the low end of the band (limit_band.h), so that
  // nine cuts of ten like this one are stable there. As many times slower as it has samples.
  ModelSpread spread{};
  Rpm finest{};  // edges and best speed are looked for no more finely than this; 0: to 0.05 and 0.5 rev/min
};

struct PocketEdge {
  Rpm speed{};
  Hertz frequency{};  // chatter frequency met there; 0 where the range ends before the pocket does
};

// A stable cut can be loud: where a tooth harmonic meets a mode.
struct QuietestSpeed {
  Rpm speed{};
  Metres limit{};  // at least a tenth above the depth asked for
  ForcedVibration forced{};
  bool open = false;  // as SpeedPocket::open
};

struct SpeedPocket {
  PocketEdge from, to;
  Rpm best{};            // the speed with the largest limiting depth inside, to 1 rev/min, 1 % from an edge
  Metres limit{};        // limiting depth there; the largest one searched (4 x depth) where nothing limits it
  Metres expected{};     // with doubt: the limiting depth of the model as it is; else `limit`
  bool open = false;     // nothing limits it: `limit` is as deep as was searched
  double margin = 0.0;   // limit/depth - 1 at `best`
  double width = 0.0;    // how far the speed may be off at `best`, smaller side, as a fraction of it
  double removal = 0.0;  // at `best`: depth x width of cut x feed [m^3/s]; 0 without a feed
  // With a feed and teeth that are alike: at `best`, and where in the pocket the forced vibration is least.
  std::optional<ForcedVibration> forced{};
  std::optional<QuietestSpeed> quietest{};
};

struct LargestStableDepth {
  Rpm speed{};
  Metres depth{};
  Hertz frequency{};  // chatter frequency just above it
};

struct SpeedAdvice {
  std::vector<SpeedPocket> pockets;           // by speed; empty: no stable speed at this depth
  std::optional<LargestStableDepth> deepest;  // where there is no pocket
  Rpm highest{};                              // of the range after the tool's cutting speed
  bool cappedByTool = false;
  std::vector<Message> warnings;  // what the linear cut leaves out
  bool finished = false;          // false: stopped
};

Result<SpeedAdvice> adviseSpeeds(const CutModel& model, const AdviceRequest& request, const std::string& where,
                                 const std::stop_token& stop = {});

}  // namespace stillcut::milling
