#include "core/milling/identify/frf.h"

#include "core/base/units.h"

namespace stillcut::identify {

Frf toCompliance(const Frf& frf) {
  Frf out;
  out.quantity = FrfQuantity::Compliance;
  out.usableTo = frf.usableTo;
  out.addedDecay = frf.addedDecay;
  out.axis = frf.axis;
  out.unitKnown = frf.unitKnown;
  out.source = frf.source;
  for (std::size_t i = 0; i < frf.frequency.size(); ++i) {
    if (frf.frequency[i] <= 0.0) continue;
    // An exponential window moves the whole response to i w + decay: integrate there too.
    const std::complex<double> s(frf.addedDecay, kTwoPi * frf.frequency[i]);
    std::complex<double> divisor = 1.0;
    if (frf.quantity == FrfQuantity::Mobility) divisor = s;
    if (frf.quantity == FrfQuantity::Accelerance) divisor = s * s;
    out.frequency.push_back(frf.frequency[i]);
    out.value.push_back(frf.value[i] / divisor);
    if (!frf.coherence.empty()) out.coherence.push_back(frf.coherence[i]);
  }
  return out;
}

}  // namespace stillcut::identify
