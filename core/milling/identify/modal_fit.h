// Modes of a structure from one measured frequency response at the tool tip: poles by the least-squares complex
// frequency-domain estimator with stabilisation (lscf.h), constants and residuals by least squares with refined poles
// (modal_model.h), as few modes as the measurement calls for.
//
// A mode is kept when leaving it out raises the misfit by half or by what amounts to 5 % of the response; modes that a
// driving point cannot have (negative stiffness, shape more than 60 degrees off real, damping above 0.3) never are.
// The band is that of the resonances by their negative real part (modal_band.h); those left out are named with it.
// Thread: any, set-up path; about a second for a usual measurement.
#pragma once

#include <array>
#include <complex>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/milling/cut_model.h"
#include "core/milling/identify/frf.h"
#include "core/milling/identify/modal_pole.h"

namespace stillcut::identify {

struct ModalOptions {
  double from = 0.0;  // band to fit [Hz]; 0: a free end, found from the resonances (modal_band.h)
  double to = 0.0;
  int modes = 0;          // how many; 0: as many as the measurement calls for
  int highestOrder = 30;  // of the stabilisation, 4 .. 60
};

struct IdentifiedMode {
  milling::Mode mode;        // direction left at (1, 0): the caller knows which axis was hit
  double frequencySd = 0.0;  // from the scatter of the residual; errors of the model itself are not in it [Hz]
  double dampingSd = 0.0;
  double stiffnessSd = 0.0;  // [N/m]
  double share = 0.0;        // part of the response (2-norm, 0..1) that is lost without this mode
  double stability = 0.0;    // fraction of the orders at which a stable pole was seen within 2 % of it
  double depth = 0.0;        // of its negative real part, 1 / (4 k z (1 + z)) [m/N]
  double coherence = 0.0;    // around its frequency, 0..1; 0: not measured
  double phase = 0.0;        // by which the mode's shape departs from real [rad]
  std::string caveat;        // one line, empty when there is none
};

// What the modes outside the band add inside it: of those above a constant, of those below an inertia. Beside the real
// modes as they are written, by least squares.
struct Residual {
  std::complex<double> upper, lower;          // [m/N]
  double at = 0.0;                            // frequency at which `lower` is meant [Hz]; 0: there is no residual
  std::array<double, 2> direction{1.0, 0.0};  // as the modes'
  std::complex<double> value(double frequency) const {
    return at > 0.0 ? upper - lower * (at / frequency) * (at / frequency) : 0.0;
  }
};

struct ModalFit {
  std::vector<IdentifiedMode> modes;  // rising in frequency, at least one
  // Real modes and residuals as they were fitted together, for what takes no residuals: the last ones stand for the
  // inertia of what lies below the band and the compliance of what lies above, as far as they have the sign of one.
  std::vector<milling::Mode> whole;
  int outside = 0;              // how many of them lie outside the band
  double misfit = 0.0;          // |fit - measured| / |measured| over the band, complex constants
  double realMisfit = 0.0;      // the same with real modes and residuals
  double writtenMisfit = 0.0;   // the same with the real modes alone: what a file of modes holds
  Residual residual;            // of the band, beside the modes as written
  double residualMisfit = 0.0;  // misfit of both together
  double measuredDepth = 0.0;   // deepest negative real part of the compliance wherever the hammer reached [m/N]
  double writtenDepth = 0.0;    // the same of the real modes alone
  double missing = 0.0;         // frequency of a resonance deeper than every mode, too noisy to be fitted [Hz]; 0: none
  double from = 0.0;            // band [Hz]
  double to = 0.0;
  std::vector<double> frequency;               // lines of the band [Hz], thinned where more than 3000
  std::vector<std::complex<double>> measured;  // compliance [m/N]
  std::vector<std::complex<double>> fitted;
  std::vector<std::vector<ModalPole>> diagram;  // poles of order 2, 3, ...
  std::vector<Message> remarks;
};

// Any quantity; converted to compliance first. Error when nothing resonates, when the response and the force point
// against each other, when the options are out of range or no physical mode is left.
Result<ModalFit> fitModes(const Frf& frf, const ModalOptions& options);

}  // namespace stillcut::identify
