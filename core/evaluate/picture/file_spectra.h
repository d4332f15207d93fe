// Spectra of any stretch of a recording, of any length, window and overlap. What takes many spectra a column costs no
// more than kMostSpectra: they then lie apart, evenly, and the picture is one of samples of the recording. Whoever
// looks closer asks for a shorter stretch, and gets all of them.
// Thread: any; not the sample path.
#pragma once

#include <functional>

#include "core/base/result.h"
#include "core/evaluate/picture/sample_store.h"
#include "core/model/recording_spectra.h"

namespace stillcut::evaluate {

inline constexpr int kMostSpectra = 24000;

// `goOn`: receives the fraction done; false: stop with an error. Empty: to the end.
Result<Spectra> spectraOf(const SampleStore& samples, Hertz rate, const SpectraRequest& request,
                          const std::function<bool(double)>& goOn = {});

}  // namespace stillcut::evaluate
