// A machine whose dynamics the learner does not know: modes along x and y, cutting coefficients, a tool with runout,
// and a drift while it works. What its cuts do is told by the exact lobes, not by the learner's own.
#pragma once

#include <cstdint>
#include <vector>

#include "core/learn/cut_evidence.h"
#include "core/learn/machine_prior.h"
#include "core/learn/random.h"
#include "core/milling/cut_model.h"

namespace stillcut::test {

struct HiddenMachine {
  milling::CutModel model;  // before its first cut; the engagement is that of its main work
  std::string material = "aluminium";
  Rpm lowest{}, highest{};
  Metres deepest{};
  double drift = 0.0;  // of ln f over 30 cuts

  milling::CutModel after(int cuts) const;
};

// Drawn from another law than the learner's prior: frequencies evenly in ln f, one to three modes.
HiddenMachine hiddenMachine(std::uint64_t seed);

// The limit as the exact lobes have it; `deepest` where there is none up to there.
struct TrueLimit {
  double depth = 0.0;  // [m]
  Hertz frequency{};   // of the chatter; 0: none
};
TrueLimit trueLimit(const milling::CutModel& model, Rpm speed, Metres deepest);

// A cut on the machine after `cuts` others, judged as a shop judges: 1.5 % of verdicts wrong, 1.5 % of stable cuts
// chatter for another cause, the frequency known to 0.5 %, the depth to 3 %.
learn::CutEvidence makeCut(const HiddenMachine& machine, int cuts, Rpm speed, Metres depth,
                           const milling::Engagement& engagement, learn::Random& random);

// The next cut of a shop that knows no lobes: three favourite speeds, a little deeper after quiet ones, less after
// chatter.
class OrdinaryShop {
 public:
  OrdinaryShop(const HiddenMachine& machine, std::uint64_t seed);
  learn::CutEvidence next();
  int cuts() const { return made_; }

 private:
  const HiddenMachine& machine_;
  learn::Random random_;
  std::vector<double> speeds_, depths_;
  int made_ = 0;
};

// Modes as a tap test gives them: off by 0.5 % in frequency, 8 % in damping, 6 % in stiffness.
learn::MachinePrior tapped(const HiddenMachine& machine, learn::Random& random);

}  // namespace stillcut::test
