// Natural frequencies and damping from the response alone: a phone, a MEMS sensor, no hammer that measures its force.
// The autocorrelation of a free decay is a sum of decays with the same poles; averaged over the hits its one-sided
// spectrum is fitted as a frequency response is (R. Brincker and C. Ventura, Introduction to Operational Modal
// Analysis, chapter 7). What is missing is the scale: no stiffness, so no depth limit; and how the modes divide the
// deflection is known only as far as the blows excite all of them alike. Thread: any, set-up path; about a second.
#pragma once

#include <complex>
#include <vector>

#include "core/base/result.h"
#include "core/milling/identify/hammer.h"
#include "core/milling/identify/modal_fit.h"

namespace stillcut::identify {

struct DecayMode {
  Hertz frequency{};
  double damping = 0.0;
  double frequencySd = 0.0, dampingSd = 0.0;
  double flexibility = 0.0;  // fraction of the softest mode's, 0..1: 1 / (damping x stiffness), estimated
};

struct DecayAnswer {
  std::vector<DecayMode> modes;  // rising in frequency, at least one
  Frf spectrum;                  // as a compliance without unit
  ModalFit fit;                  // of it; its stiffness means nothing
};

// Records without force, one hit each at whose beginning it is quiet, of one rate. Error: nothing that resonates.
Result<DecayAnswer> analyseDecays(const std::vector<HammerRecord>& records, const ModalOptions& options);

// Hits in one long response, one record each.
std::vector<HammerRecord> cutDecays(const std::vector<double>& response, double rate, double length);

// What two hits without force are compared by: the magnitude of the spectrum, of size 1.
std::vector<std::complex<double>> decaySignature(const HammerRecord& record);

}  // namespace stillcut::identify
