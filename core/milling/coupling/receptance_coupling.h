// The response at the tip of a tool from a holder and spindle that were measured once and the tool's geometry:
// receptance coupling substructure analysis.
// Source: T. Schmitz and R. Donaldson, Predicting high-speed machining dynamics by substructure analysis, CIRP Annals
// 49 (2000); T. Schmitz and K. Smith, Machining Dynamics, 2nd ed., ch. 9: G11 = R11 - R12 (R22 + H)^-1 R21, where R is
// the free tool, end 2 held, and H the holder where the tool leaves it. Rotations of the holder from a second
// measurement a distance s up the holder: l = (h_cd - h_dd) / s (slopes from the tip into the holder), n = l,
// p = l^2 / h_dd (ch. 9).
// Units: SI. Pure: any thread; set-up, not real-time.
#pragma once

#include <complex>
#include <string>
#include <vector>

#include "core/milling/coupling/beam.h"
#include "core/milling/identify/frf.h"

namespace stillcut::coupling {

// Tool with its flutes as a cylinder: a section of `fluted` diameter in front of the shank.
struct ToolGeometry {
  Metres diameter{};     // of the cutting edges
  Metres shank{};        // 0: as `diameter`
  Metres stickOut{};     // from the holder's face to the tip
  Metres fluteLength{};  // of it; 0: no flutes
  // The cylinder of a fluted part is as stiff as one of this part of its diameter: 0.8 for two to four flutes
  // (L. Kops and D. Vo, Determination of the equivalent diameter of an end mill based on its compliance, CIRP Annals 39
  // (1990)).
  double fluteRatio = 0.8;
};

// Tip first. Error: a length that is none, flutes longer than the stick-out.
Result<std::vector<BeamSection>> sectionsOf(const ToolGeometry& tool, const std::string& where);

// What was measured at the face of the holder (or of a stub left in it), on the same lines.
struct HolderResponse {
  identify::Frf direct;  // compliance h_dd: response and force at the face
  identify::Frf cross;   // compliance h_cd: response at the distance `spacing` from the face; empty: not measured
  Metres spacing{};
};

struct TipResponse {
  identify::Frf tip;         // compliance at the tool's tip
  identify::Frf noRotation;  // the same as if the holder could not rotate: how much hangs on the second measurement
  std::vector<Message> remarks;
};

// Error: lines that differ, a direct response of another quantity, a tool that is none.
Result<TipResponse> couple(const HolderResponse& holder, const std::vector<BeamSection>& tool,
                           const BeamMaterial& material, BeamTheory theory);

// The coupling itself, at one frequency: the tip of a free tool on a holder with the receptance `holder`.
Block tipOf(const BeamReceptance& tool, const Block& holder);

}  // namespace stillcut::coupling
