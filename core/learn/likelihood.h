// How probable a judged cut is on a guessed machine: the verdict with a soft border, the frequency of the chatter, and
// a fraction of cuts whose verdict or cause is another (MODEL.md).
// Thread: pure functions; no allocation but in condense().
#pragma once

#include <span>
#include <vector>

#include "core/learn/cut_evidence.h"
#include "core/learn/learn_params.h"
#include "core/learn/lobe_table.h"

namespace stillcut::learn {

// A kind of engagement and the tables that belong to it, by index.
struct Shape {
  double immersion = 1.0;          // rounded: cuts that differ less share a table
  double start = 0.0, exit = 0.0;  // [rad]
  int teeth = 0;
  ForceShape force;
  double marginSd = 0.0;  // of this engagement

  bool covers(const milling::Engagement& engagement, int teethOfCut) const;
};
Shape makeShape(const milling::Engagement& engagement, int teeth, const LearnParams& params);

// One or several cuts with the same numbers, ready to be held against a table.
struct Term {
  std::size_t shape = 0;
  double speed = 0.0;         // [rev/min]
  double logDepth = 0.0;      // [ln m]
  double toothPassing = 0.0;  // [Hz]
  bool chatter = false;
  double doubt = 0.02;
  double frequency = 0.0;    // [Hz]; 0: not given
  double frequencySd = 0.0;  // relative, with the model's
  double marginSd = 0.0;
  double speedSd = 0.0;
  double weight = 1.0;
};

// Cuts in the order they were made; `shapes[i]` is the shape of cut i. Equal cuts become one term.
std::vector<Term> condense(std::span<const CutEvidence> cuts, std::span<const std::size_t> shapeOfCut,
                           std::span<const Shape> shapes, const LearnParams& params);

using LimitTables = std::span<const std::vector<LimitPoint>>;  // one per shape

double probabilityOfChatter(const Term& term, std::span<const LimitPoint> table, const SpeedGrid& grid);
double logLikelihood(const Term& term, std::span<const LimitPoint> table, const SpeedGrid& grid,
                     const LearnParams& params);
// Of all terms, each with its weight.
double logLikelihood(std::span<const Term> terms, LimitTables tables, const SpeedGrid& grid, const LearnParams& params);

}  // namespace stillcut::learn
