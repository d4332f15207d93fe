// Work done with every instruction set that the machine has, held to the baseline bit by bit.
#pragma once

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "core/dsp/kernels/choose.h"

namespace stillcut::dsp::kernels {

using Values = std::vector<double>;

inline Values noise(std::size_t n, unsigned seed) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal;
  Values x(n);
  for (double& v : x) v = normal(engine);
  return x;
}

// What `work` makes with each set; all the same.
template <class Work>
Values sameWithEverySet(const Work& work) {
  Values baseline = work(kernelsOf(InstructionSet::Baseline));
  for (const InstructionSet set : availableSets()) {
    EXPECT_EQ(kernelsOf(set).set, set);
    EXPECT_EQ(work(kernelsOf(set)), baseline) << nameOf(set);
  }
  return baseline;
}

}  // namespace stillcut::dsp::kernels
