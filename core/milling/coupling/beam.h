// A tool as a free-free beam of round sections: its exact receptances at both ends, for displacement and rotation,
// force and moment.
// Source: the differential equations of Timoshenko's beam (S. Timoshenko 1921; L. Meirovitch, Fundamentals of
// Vibrations, sec. 8.9) with structural damping E (1 + i eta), solved exactly by the matrix exponential over each
// section; Euler and Bernoulli's beam is the same without shear and without rotary inertia.
// Units: SI. Pure: any thread; set-up, not real-time.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/units.h"

namespace stillcut::coupling {

struct BeamMaterial {
  double young = 5.5e11;    // [Pa]
  double density = 1.45e4;  // [kg/m^3]
  double poisson = 0.22;
  double lossFactor = 0.0015;  // eta: twice the damping ratio of a free mode
};

// Cemented carbide with some 10 % cobalt (G. Schneider, Cutting Tool Applications, ch. 1; T. Schmitz and K. Smith,
// Machining Dynamics, 2nd ed., table 9.1) and high-speed steel.
BeamMaterial carbide();
BeamMaterial highSpeedSteel();

enum class BeamTheory { Timoshenko, EulerBernoulli };

// A cylinder, from the tip towards the holder.
struct BeamSection {
  Metres length{};
  Metres diameter{};
};

using Block = Eigen::Matrix2cd;  // displacement [m] and rotation [rad] by force [N] and moment [N m]

// End 1 is the tip, end 2 the one that is held. Rotation is the slope's; every block is symmetric to its transpose's.
struct BeamReceptance {
  Block tip, tipByHeld, heldByTip, held;
};

// Error: no section, a length or diameter that is none, more than 64 sections.
Status check(const std::vector<BeamSection>& sections, const BeamMaterial& material, const std::string& where);

// At a frequency above zero; sections and material as check() wants them.
BeamReceptance freeBeam(const std::vector<BeamSection>& sections, const BeamMaterial& material, BeamTheory theory,
                        Hertz frequency);

}  // namespace stillcut::coupling
