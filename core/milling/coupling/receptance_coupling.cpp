#include "core/milling/coupling/receptance_coupling.h"

#include <Eigen/LU>
#include <cmath>

namespace stillcut::coupling {
namespace {

using Complex = std::complex<double>;
using identify::Frf;

bool sameLines(const Frf& a, const Frf& b) {
  if (a.frequency.size() != b.frequency.size()) return false;
  for (std::size_t i = 0; i < a.frequency.size(); ++i) {
    if (std::abs(a.frequency[i] - b.frequency[i]) > 1e-6 * a.frequency[i]) return false;
  }
  return true;
}

// Rotations count along the tool, from the tip into the holder, as those of the beam do.
Block holderAt(Complex direct, Complex cross, double spacing) {
  const Complex slope = (cross - direct) / spacing;
  Block h;
  h << direct, slope, slope, slope * slope / direct;
  return h;
}

Block rigidInRotation(Complex direct) {
  Block h = Block::Zero();
  h(0, 0) = direct;
  return h;
}

}  // namespace

Result<std::vector<BeamSection>> sectionsOf(const ToolGeometry& tool, const std::string& where) {
  const double flutes = tool.fluteLength.value;
  const double out = tool.stickOut.value;
  if (!(tool.diameter.value > 0.0) || !(out > 0.0))
    return Error{where, message("needs the tool's diameter and stick-out")};
  if (flutes < 0.0 || flutes > out) {
    return Error{where, message("the flutes are longer than the stick-out"), message("what is clamped does not count")};
  }
  if (!(tool.fluteRatio > 0.3 && tool.fluteRatio <= 1.0)) {
    return Error{where, message("the flutes' effective diameter must be 0.3 to 1 of the tool's")};
  }
  const Metres shank = tool.shank.value > 0.0 ? tool.shank : tool.diameter;
  std::vector<BeamSection> sections;
  if (flutes > 0.0) sections.push_back({tool.fluteLength, tool.fluteRatio * tool.diameter});
  if (out > flutes) sections.push_back({Metres(out - flutes), shank});
  return sections;
}

Block tipOf(const BeamReceptance& tool, const Block& holder) {
  return tool.tip - tool.tipByHeld * (tool.held + holder).inverse() * tool.heldByTip;
}

Result<TipResponse> couple(const HolderResponse& holder, const std::vector<BeamSection>& tool,
                           const BeamMaterial& material, BeamTheory theory) {
  if (const Status sound = check(tool, material, holder.direct.source); !sound) return sound.error();
  const Frf direct = identify::toCompliance(holder.direct);
  const Frf cross = identify::toCompliance(holder.cross);
  const bool rotates = !cross.value.empty();
  if (direct.value.empty()) return Error{direct.source, message("holds no line above 0 Hz")};
  if (rotates && (!sameLines(direct, cross) || direct.addedDecay != cross.addedDecay)) {
    return Error{cross.source, message("has other lines than %1", direct.source),
                 message("measure both with the same sampling rate and length")};
  }
  if (rotates && !(holder.spacing.value > 0.0)) return Error{cross.source, message("needs its distance from the face")};
  TipResponse out;
  out.tip = direct;
  out.tip.coherence.clear();
  out.noRotation = out.tip;
  for (std::size_t i = 0; i < direct.value.size(); ++i) {
    const BeamReceptance beam = freeBeam(tool, material, theory, Hertz(direct.frequency[i]));
    const Complex rigid = tipOf(beam, rigidInRotation(direct.value[i]))(0, 0);
    out.noRotation.value[i] = rigid;
    out.tip.value[i] =
        rotates ? tipOf(beam, holderAt(direct.value[i], cross.value[i], holder.spacing.value))(0, 0) : rigid;
  }
  if (direct.addedDecay > 0.0) {
    out.remarks.push_back(
        message("the holder was measured with an exponential window: the damping is too high by %1 1/s",
                std::lround(direct.addedDecay)));
    out.tip.addedDecay = out.noRotation.addedDecay = 0.0;
  }
  if (!rotates) {
    out.remarks.push_back(
        message("the holder's rotation was not measured and is left out: the tip is softer, and its "
                "frequencies are lower, than computed here; --cross measures it"));
  }
  return out;
}

}  // namespace stillcut::coupling
