#include "core/dsp/kernels/set.h"
#include "core/dsp/kernels/tables.h"

namespace stillcut::dsp::kernels::STILLCUT_SET {

void fill(Kernels& k) noexcept {
  k.powers = powers;
  k.turn = turn;
  k.harmonics = harmonics;
  k.harmonicPair = harmonicPair;
  k.cascade = cascade;
  k.weightedPower = weightedPower;
  k.covariance = covariance;
  k.covarianceTimes = covarianceTimes;
  k.parametric = parametric;
  k.turns = turns;
  k.multiply = multiply;
  k.sum = sum;
  k.largest = largest;
  k.addScaled = addScaled;
  k.squares = squares;
  k.unfold = unfold;
  k.maskHarmonics = maskHarmonics;
  k.scanLines = scanLines;
  k.scanCross = scanCross;
  k.coherence = coherence;
  k.sharpen = sharpen;
  k.bank = bank;
  k.designBank = designBank;
  k.operatorSums = operatorSums;
  k.separate = separate;
  k.tapSum = tapSum;
  k.tapSteer = tapSteer;
  k.newTapSum = newTapSum;
  k.newTapSteer = newTapSteer;
  k.filterPair = filterPair;
  k.lineSums = lineSums;
  k.demodulate = demodulate;
}

}  // namespace stillcut::dsp::kernels::STILLCUT_SET
