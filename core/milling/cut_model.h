// The physics of one cut as numbers: structure, tool, material, engagement. Shared by the time-domain model, the
// stability lobes and the identification from measurements. Plain values; check() is the one place that refuses
// nonsense.
//
// Axes: x along the feed, y to the left of it, seen from the spindle; tooth angle phi is measured from +y towards +x
// (clockwise), so that the chip thickness of a straight edge is h = f_z sin(phi) (van Dijk 2010 eq. 1-4).
// Up milling engages phi = 0 .. acos(1 - 2 a/D), down milling pi - acos(1 - 2 a/D) .. pi. Any thread.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/base/units.h"

namespace stillcut::milling {

struct ModeAtSpeed {
  Rpm speed{};
  Hertz frequency{};
  double damping = 0.0, stiffness = 0.0;
};

struct Mode {
  Hertz frequency{};                          // undamped natural frequency
  double damping = 0.0;                       // ratio, > 0
  double stiffness = 0.0;                     // modal stiffness at the tool tip [N/m], > 0
  std::array<double, 2> direction{1.0, 0.0};  // participation of x and y; mass-normalised direction, not nec. unit
  double directionZ = 0.0;                    // and of z
  // Where it changes with the spindle's speed, by rising speed: straight lines between, the ends held. What stands
  // above is then the mode at the first of them. Empty: it does not.
  std::vector<ModeAtSpeed> atSpeeds{};
  bool ofPart = false;   // of the part, not the tool: what counts is how one moves to the other
  double mass() const {  // [kg]
    const double w = kTwoPi * frequency.value;
    return stiffness / (w * w);
  }
};

inline constexpr int kMostTeeth = 200;

// Edges that wave along the axis: tooth j stands A sin(2 pi z/L - phase_j) further out at height z, so that where the
// feed is small only some teeth cut and the delays are several.
struct Serration {
  Metres amplitude{}, length{};  // above 0
  std::vector<double> phase;     // of each tooth [rad]; empty: even shares of a turn, in the order of the teeth
  Metres feedPerTooth{};         // of the cut; 0: not known yet
};

struct Tool {
  int teeth = 2;  // 1 .. kMostTeeth
  Metres diameter{0.010};
  std::vector<double> pitch;       // angle from each tooth to the next [rad], sums to 2 pi; empty: regular
  double helix = 0.0;              // [rad]
  std::vector<double> toothHelix;  // [rad] of each tooth, where they differ; empty: `helix` for all
  std::vector<Metres> runout;      // radial, per tooth; empty: none
  Metres cornerRadius{};           // 0: square; half the diameter: ball-nose
  std::optional<Serration> serration;
};

// With a corner radius or serration: force and delay depend on the height.
bool isShaped(const Tool& tool);

// Helix of a tooth [rad].
double helixOf(const Tool& tool, int tooth);
// Angle from a tooth to the next one ahead of it [rad].
double pitchAfter(const Tool& tool, int tooth);

// F_t = a_p (K_t h^x + K_te), F_r = a_p (K_r h^x + K_re) for h > 0 (van Dijk eq. 1; x = 1 linear).
struct Material {
  double tangential = 6.0e8;    // K_t [N/m^2 for exponent 1, N/m^(1+x) otherwise]
  double radial = 2.0e8;        // K_r in the same unit (K_n of the shared cases)
  double tangentialEdge = 0.0;  // K_te [N/m]
  double radialEdge = 0.0;      // K_re [N/m]
  double exponent = 1.0;        // x, 0 < x <= 1
  double processDamping = 0.0;  // indentation coefficient [N/m]; 0: off. Force = -a_p * c * (dr/dt) / v_c
  // How well they are known: standard deviations over the value, of K_t and K_r together and of the process damping;
  // 0: not given.
  double spread = 0.0, dampingSpread = 0.0;
  Metres usualChip{};  // where lobes take a power law as straight when no feed is known; 0: nowhere
};

// Process damping coefficient [N/m] of a flank with a wear land: the volume it presses under itself, a_p L^2/2 (dr/dt)/
// v_c, times the specific indentation force [N/m^3] (Wu 1989; small-amplitude form of Ahmadi and Ismail 2010).
double processDampingOf(double indentationPerVolume, Metres wearLand);

enum class MillingDirection { Up, Down };

struct Engagement {
  double radialImmersion = 1.0;  // a/D, 0 < a/D <= 1
  MillingDirection side = MillingDirection::Up;
  // Of the middle of the cut from the tool's axis, towards +y, over the radius: 0 is a centred face mill. Empty: the
  // tool's edge is the cut's edge, on `side`. What would lie beyond the tool is not cut.
  std::optional<double> offset{};
  double startAngle() const;  // [rad]
  double exitAngle() const;   // [rad]
};

// The engagement of a tool that cuts from one angle to another [rad], 0 <= start < exit <= pi.
Engagement engagementBetween(double startAngle, double exitAngle);

// Turning, boring, and drilling a pilot hole wider: edges that stand while the work runs past. The tool's teeth are its
// edges, its diameter the work's at the cut, the depth of cut is measured along y, the feed is per revolution and edge.
// Axes of the modes: x along the feed, y into the part, z as the work runs past the edge.
// The chip is f sin(kappa) thick and a_p / sin(kappa) wide, n = (sin kappa, cos kappa, 0) is its thickness' direction.
struct Turning {
  double edgeAngle = 0.25 * kTwoPi;  // kappa, between the edge and the feed [rad]
};

struct CutModel {
  std::vector<Mode> modes;  // at least one
  Tool tool;
  Material material;
  Engagement engagement;           // of no use in turning
  std::optional<Turning> turning;  // empty: milling
};

bool changesWithSpeed(const CutModel& model);
// With the modes that it has at a speed.
CutModel modelAt(CutModel model, Rpm speed);

// A turning cut as a tooth that stands at 90 degrees sees it: modes along n and z as x and y, forces per depth of cut.
// A milling cut is given back as it is.
CutModel standingTooth(const CutModel& model);
// Has a part in x or y; of a standing tooth in n or z. Modes without it neither see the chip nor are moved by forces.
bool takesPart(const Mode& mode);
// The chip's thickness over the feed per revolution, of an edge that stands.
double chipPerFeed(const CutModel& model);

// One clear line for negative damping, zero teeth, immersion outside 0..1, no modes, a pitch that does not close, ...
// `where` names the file or caller.
Status check(const CutModel& model, const std::string& where);

}  // namespace stillcut::milling
