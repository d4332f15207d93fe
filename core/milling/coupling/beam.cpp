#include "core/milling/coupling/beam.h"

#include <Eigen/LU>
#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

namespace stillcut::coupling {
namespace {

using Complex = std::complex<double>;
using Transfer = Eigen::Matrix4cd;

constexpr double kPi = 0.5 * kTwoPi;

// Of a round section: G. Cowper 1966.
double shearCoefficient(double poisson) {
  return 6.0 * (1.0 + poisson) / (7.0 + 6.0 * poisson);
}

// The state (w, phi, M, V) along a section: w' = phi + V / (k G A), phi' = M / (E I), M' = -V - rho I omega^2 phi,
// V' = -rho A omega^2 w.
Transfer over(const BeamSection& section, const BeamMaterial& m, BeamTheory theory, double omega) {
  const double d = section.diameter.value;
  const double area = kPi * d * d / 4.0;
  const double inertia = kPi * d * d * d * d / 64.0;
  const Complex young = m.young * Complex(1.0, m.lossFactor);
  const Complex shear = young / (2.0 * (1.0 + m.poisson)) * shearCoefficient(m.poisson) * area;
  const bool full = theory == BeamTheory::Timoshenko;
  Transfer slope = Transfer::Zero();
  slope(0, 1) = 1.0;
  slope(0, 3) = full ? 1.0 / shear : 0.0;
  slope(1, 2) = 1.0 / (young * inertia);
  slope(2, 1) = full ? -m.density * inertia * omega * omega : 0.0;
  slope(2, 3) = -1.0;
  slope(3, 0) = -m.density * area * omega * omega;
  // Scaled to numbers near 1: displacements and forces lie 1e12 apart, which the exponential's error would mix.
  const double length = section.length.value;
  const double stiffness = m.young * inertia;
  Eigen::Vector4cd scale;
  scale << length, 1.0, stiffness / length, stiffness / (length * length);
  const Transfer scaled = scale.cwiseInverse().asDiagonal() * (slope * length) * scale.asDiagonal();
  return scale.asDiagonal() * scaled.exp() * scale.cwiseInverse().asDiagonal();
}

}  // namespace

BeamMaterial carbide() {
  return {};
}

BeamMaterial highSpeedSteel() {
  return {2.1e11, 8.0e3, 0.29, 0.0015};
}

Status check(const std::vector<BeamSection>& sections, const BeamMaterial& material, const std::string& where) {
  if (sections.empty() || sections.size() > 64) return Error{where, message("the tool needs 1 to 64 sections")};
  for (const BeamSection& s : sections) {
    const double l = s.length.value;
    const double d = s.diameter.value;
    if (!std::isfinite(l) || !std::isfinite(d) || l <= 0.0 || d <= 0.0 || l > 2.0 || d > 1.0) {
      return Error{where, message("a section of the tool has no length or no diameter")};
    }
  }
  const bool sound = material.young > 0.0 && material.density > 0.0 && material.poisson >= 0.0 &&
                     material.poisson < 0.5 && material.lossFactor >= 0.0 && material.lossFactor < 1.0;
  if (!sound) return Error{where, message("the tool's material is none")};
  return Done{};
}

BeamReceptance freeBeam(const std::vector<BeamSection>& sections, const BeamMaterial& material, BeamTheory theory,
                        Hertz frequency) {
  const double omega = kTwoPi * frequency.value;
  Transfer whole = Transfer::Identity();
  for (const BeamSection& section : sections) whole = over(section, material, theory, omega) * whole;
  // State at the held end from that at the tip, z2 = T z1 with z = (u, s), u = (w, phi), s = (M, V). Loads from
  // outside: at the tip f1 = -V, m1 = -M; at the held end f2 = V, m2 = M.
  const Block uu = whole.topLeftCorner<2, 2>();
  const Block us = whole.topRightCorner<2, 2>();
  const Block su = whole.bottomLeftCorner<2, 2>();
  const Block ss = whole.bottomRightCorner<2, 2>();
  Block swap;  // (M, V) from (f, m)
  swap << 0.0, 1.0, 1.0, 0.0;
  // Loads at the held end, none at the tip: s1 = 0, u1 = su^-1 s2, u2 = uu u1. Loads at the tip: s2 = 0.
  const Block suInverse = su.inverse();
  BeamReceptance r;
  r.tipByHeld = suInverse * swap;
  r.held = uu * r.tipByHeld;
  r.tip = suInverse * ss * swap;
  r.heldByTip = uu * r.tip - us * swap;
  return r;
}

}  // namespace stillcut::coupling
