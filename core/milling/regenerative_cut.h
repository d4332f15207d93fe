// RegenerativeCut: the time-domain model of a cut (van Dijk 2010 eq. 1-4, Caliskan 2018 section 2): modes driven by the
// cutting forces of teeth that meet the surface their predecessors left.
//
// Steps are equal in spindle angle, so that a tooth meets the surface exactly where it was stored, at any speed. Over a
// step each mode's state is carried by its exact transition, with the force linear between its two ends: second order.
// The force at the end is found from a prediction with the force held, whose displacement error is third order.
// A turning cut is a tooth that stands at 90 degrees while the surface runs past it: its angle counts on, its direction
// does not turn. Axes and angles: core/milling/cut_model.h. Tooth j stands at (spindle angle + pitch[0] + ... +
// pitch[j-1]).
//
// Thread: one. After construction nothing allocates; advance() is real-time safe.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/milling/cut_model.h"
#include "core/milling/surface_history.h"

namespace stillcut::milling {

inline constexpr int kMaxModes = 16;

struct CutNumerics {
  int stepsPerRevolution = 2048;
  int slices = 1;           // axial, used when the tool has a helix
  Metres deepest{0.001};    // largest depth that will be set; slices divide it
  bool mayLeaveCut = true;  // false: the chip may be negative, which makes the model linear (to compare with theory)
  bool leavesMarks = true;  // false: the tool vibrates but cuts as if it did not: forced vibration alone
};

class RegenerativeCut {
 public:
  // `model` has passed check() and has at most kMaxModes modes.
  RegenerativeCut(const CutModel& model, const CutNumerics& numerics);

  void setSpeed(double radPerSecond) noexcept;  // > 0; from the next step on
  void setFeed(double metresPerSecond) noexcept;
  void setAxialDepth(double metres) noexcept;  // 0: air
  void setWindows(std::span<const AngularWindow> windows) noexcept;
  void setForceScale(double scale) noexcept { forceScale_ = scale; }  // material that is not the same everywhere
  void setExternalForce(double fx, double fy) noexcept;               // on the tool tip [N], held
  // Force on one mode alone: `first` [N] at the end of the next step, from there on by `slope` [N/s] until the next
  // call.
  void leadModalForce(int mode, double first, double slope) noexcept;
  double modalForce(int mode) const { return pushed_[static_cast<std::size_t>(mode)]; }
  void disturb(int mode, double displacement, double velocity) noexcept;
  // Motion, surface and forces times `factor`: the same cut at another size. For the linear model without feed only.
  void scaleMotion(double factor) noexcept;

  void advance(int steps) noexcept;

  double time() const { return time_; }          // [s]
  double stepTime() const { return stepTime_; }  // of the next step [s]
  int cell() const { return cell_; }             // spindle angle in steps, 0 .. stepsPerRevolution - 1
  double feedPath() const { return x_; }         // [m]
  int modes() const { return modes_; }
  std::array<double, 2> direction(int mode) const { return shown_[static_cast<std::size_t>(mode)]; }  // along x, y
  double displacement(int mode) const { return q_[static_cast<std::size_t>(mode)]; }
  double velocity(int mode) const { return v_[static_cast<std::size_t>(mode)]; }
  double acceleration(int mode) const noexcept;
  // In turning along the chip's thickness and along the cutting speed.
  std::array<double, 2> tip() const noexcept;
  std::array<double, 2> tipAcceleration() const noexcept;
  // Cutting force on the tool along x and y [N].
  std::array<double, 2> force() const {
    return normal_ ? std::array{fx_ * (*normal_)[0], fx_ * (*normal_)[1]} : std::array{fx_, fy_};
  }
  // Cutting torque averaged since the last call [N m].
  double takeMeanTorque() noexcept;

 private:
  struct Edge {  // one tooth in one slice
    int slice = 0;
    int offset = 0;         // cells ahead of the spindle angle
    double fraction = 0.0;  // and the rest, 0 .. 1
    double sineRest = 0.0, cosineRest = 1.0;
    double runout = 0.0;
    double lastReach = 0.0;  // at the cell behind
    bool hasReach = false;
    double depth = 0.0;  // [m] of this slice in the cut
  };
  struct Forces {
    double x = 0.0, y = 0.0, tangential = 0.0;
  };

  void makeTransition() noexcept;
  double flatFeedPerTooth() const noexcept;
  Forces cut(double tipX, double tipY, double speedX, double speedY) noexcept;
  void cutEdge(Edge& e, double tipX, double tipY, double speedX, double speedY, Forces& sum) noexcept;

  CutModel model_;
  bool mayLeave_, leavesMarks_, linearChip_;
  int modes_, teeth_, cells_, slices_;
  double sliceDepth_, radius_, chipPerFeed_;
  std::optional<std::array<double, 2>> normal_{};  // of the chip's thickness, of an edge that stands
  std::array<std::array<double, 2>, kMaxModes> shown_{};
  SurfaceHistory surface_;
  std::vector<Edge> edges_;
  int liveEdges_ = 0;  // edges of slices in the cut come first

  // Per mode: state, shape, mass, and the transition over one step.
  std::array<double, kMaxModes> q_{}, v_{}, dx_{}, dy_{}, mass_{}, stiffness_{}, damper_{};
  int firstPushed_ = kMaxModes;                                // modes before it have no force of their own
  std::array<double, kMaxModes> pushed_{}, lead_{}, slope_{};  // force on it [N], its rise over the next step, after it
  struct Transition {
    double qq, qv, vq, vv;  // free motion
    double qf, vf;          // force held over the step
    double qr, vr;          // force rising from 0 to 1 over the step
  };
  std::array<Transition, kMaxModes> step_{};

  double omega_ = 1.0, stepTime_ = 0.0, time_ = 0.0;
  double feed_ = 0.0, x_ = 0.0;
  double depth_ = 0.0, forceScale_ = 1.0;
  double fx_ = 0.0, fy_ = 0.0, outerX_ = 0.0, outerY_ = 0.0;
  double drivenX_ = 0.0, drivenY_ = 0.0;  // cutting and external force at the end of the last step
  double torqueSum_ = 0.0;
  long torqueSteps_ = 0;
  int cell_ = 0;
};

}  // namespace stillcut::milling
