// Steps that nothing but exact storage brings back: every field different, with numbers that formatting would lose.
#pragma once

#include <cstdint>
#include <vector>

#include "core/model/cut_setup.h"
#include "core/model/step_record.h"

namespace stillcut::record {

CutSetup exampleSetup(int channels = 2, int blockFrames = 64);
// Step `number` of a made-up cut; the same number gives the same step. Lengths, gaps, inputs and verdicts vary.
StepRecord exampleStep(int number, int channels = 2, int blockFrames = 64);
// Every field that counts as its bits, one after the other.
std::vector<std::uint64_t> bitsOf(const StepInput& input);
std::vector<std::uint64_t> bitsOf(const StepOutput& output);

}  // namespace stillcut::record
