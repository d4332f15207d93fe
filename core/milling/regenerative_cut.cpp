#include "core/milling/regenerative_cut.h"

#include <algorithm>
#include <cmath>

namespace stillcut::milling {

namespace {
std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

bool hasHelix(const Tool& tool) {
  for (int j = 0; j < tool.teeth; ++j) {
    if (helixOf(tool, j) != 0.0) return true;
  }
  return false;
}
}  // namespace

RegenerativeCut::RegenerativeCut(const CutModel& model, const CutNumerics& numerics)
    : model_(standingTooth(model)),
      mayLeave_(numerics.mayLeaveCut),
      leavesMarks_(numerics.leavesMarks),
      linearChip_(model.material.exponent == 1.0),
      modes_(std::min(static_cast<int>(model_.modes.size()), kMaxModes)),
      teeth_(model.tool.teeth),
      cells_(numerics.stepsPerRevolution),
      slices_(hasHelix(model.tool) ? std::max(1, numerics.slices) : 1),
      sliceDepth_(std::max(numerics.deepest.value, 1e-9) / slices_),
      radius_(0.5 * model.tool.diameter.value),
      chipPerFeed_(milling::chipPerFeed(model)),
      surface_(cells_, slices_) {
  if (model.turning) {
    surface_.stand();
    normal_ = {std::sin(model.turning->edgeAngle), std::cos(model.turning->edgeAngle)};
  }
  for (int i = 0; i < modes_; ++i) shown_[at(i)] = model.modes[at(i)].direction;
  for (int i = 0; i < modes_; ++i) {
    const Mode& m = model_.modes[at(i)];
    dx_[at(i)] = m.direction[0];
    dy_[at(i)] = m.direction[1];
    mass_[at(i)] = m.mass();
    stiffness_[at(i)] = m.stiffness;
    damper_[at(i)] = 2.0 * m.damping * std::sqrt(m.stiffness * m.mass());
  }
  for (int s = 0; s < slices_; ++s) {
    double angle = 0.0;
    for (int j = 0; j < teeth_; ++j) {
      // A right-hand helix lets the edge trail behind its tip with height.
      const double lag = (s + 0.5) * sliceDepth_ * std::tan(helixOf(model_.tool, j)) / radius_;
      double cells = (angle - lag) / kTwoPi * cells_;
      cells -= std::floor(cells / cells_) * cells_;
      Edge e;
      e.slice = s;
      e.offset = static_cast<int>(std::floor(cells + 1e-9));
      e.fraction = std::max(0.0, cells - e.offset);
      if (e.fraction < 1e-7) e.fraction = 0.0;
      e.offset %= cells_;
      e.sineRest = std::sin(e.fraction * kTwoPi / cells_);
      e.cosineRest = std::cos(e.fraction * kTwoPi / cells_);
      e.runout = model_.tool.runout.empty() ? 0.0 : model_.tool.runout[at(j)].value;
      edges_.push_back(e);
      angle += pitchAfter(model_.tool, j);
    }
  }
  setSpeed(1.0);
}

void RegenerativeCut::setSpeed(double radPerSecond) noexcept {
  omega_ = radPerSecond;
  stepTime_ = kTwoPi / (omega_ * cells_);
  makeTransition();
}

void RegenerativeCut::setFeed(double metresPerSecond) noexcept {
  feed_ = metresPerSecond;
}

double RegenerativeCut::flatFeedPerTooth() const noexcept {
  return feed_ * kTwoPi / (omega_ * teeth_);
}

void RegenerativeCut::setAxialDepth(double metres) noexcept {
  depth_ = metres;
  liveEdges_ = 0;
  for (int s = 0; s < slices_; ++s) {
    // Without a helix the one slice takes any depth; with one, deeper than announced goes to the topmost slice.
    const double below = s * sliceDepth_;
    const double top = s + 1 == slices_ ? metres : below + sliceDepth_;
    const double inCut = std::max(0.0, std::min(metres, top) - below);
    const bool wasIn = edges_[at(s * teeth_)].depth > 0.0;
    if (inCut > 0.0 && !wasIn) surface_.restartSlice(s);
    for (int j = 0; j < teeth_; ++j) {
      Edge& e = edges_[at(s * teeth_ + j)];
      e.depth = inCut;
      e.hasReach = e.hasReach && wasIn;
    }
    if (inCut > 0.0) liveEdges_ = (s + 1) * teeth_;
  }
}

void RegenerativeCut::setWindows(std::span<const AngularWindow> windows) noexcept {
  surface_.setWindows(windows);
}

void RegenerativeCut::leadModalForce(int mode, double first, double slope) noexcept {
  if (mode < 0 || mode >= modes_) return;
  firstPushed_ = std::min(firstPushed_, mode);
  lead_[at(mode)] = first - pushed_[at(mode)];
  slope_[at(mode)] = slope;
}

void RegenerativeCut::setExternalForce(double fx, double fy) noexcept {
  outerX_ = fx;
  outerY_ = fy;
}

void RegenerativeCut::disturb(int mode, double displacement, double velocity) noexcept {
  q_[at(mode)] += displacement;
  v_[at(mode)] += velocity;
}

void RegenerativeCut::scaleMotion(double factor) noexcept {
  for (int i = 0; i < modes_; ++i) {
    q_[at(i)] *= factor;
    v_[at(i)] *= factor;
    for (auto* force : {&pushed_, &lead_, &slope_}) (*force)[at(i)] *= factor;
  }
  for (Edge& e : edges_) e.lastReach *= factor;
  for (double* force : {&fx_, &fy_, &drivenX_, &drivenY_}) *force *= factor;
  surface_.scale(factor);
}

void RegenerativeCut::makeTransition() noexcept {
  const double h = stepTime_;
  for (int i = 0; i < modes_; ++i) {
    const double zeta = model_.modes[at(i)].damping;
    const double wn = kTwoPi * model_.modes[at(i)].frequency.value;
    const double decay = zeta * wn, wd = wn * std::sqrt(1.0 - zeta * zeta);
    const double e = std::exp(-decay * h), c = std::cos(wd * h), s = std::sin(wd * h) / wd;
    const double k = stiffness_[at(i)], lag = damper_[at(i)] / k;
    Transition& t = step_[at(i)];
    t.qq = e * (c + decay * s);
    t.qv = e * s;
    t.vq = -e * wn * wn * s;
    t.vv = e * (c - decay * s);
    // Held force: the static deflection 1/k is the resting point of the free motion.
    t.qf = (1.0 - t.qq) / k;
    t.vf = -t.vq / k;
    // Force t/h: the particular solution is (t - lag) / (k h).
    t.qr = (h - lag + t.qq * lag - t.qv) / (k * h);
    t.vr = (1.0 + t.vq * lag - t.vv) / (k * h);
  }
}

void RegenerativeCut::cutEdge(Edge& e, double tipX, double tipY, double speedX, double speedY, Forces& sum) noexcept {
  int m = cell_ + e.offset;
  if (m >= cells_) m -= cells_;
  if (surface_.live()[m] == 0) return;
  double s = surface_.sine()[m], c = surface_.cosine()[m];
  double weight = surface_.weight()[m];
  double* const heights = surface_.slice(e.slice);
  double height = heights[m];
  // What the tip does comes last everywhere: the rest is known before the motion is, and need not be waited for.
  const double fed = chipPerFeed_ * x_;
  double rigid = e.runout + s * fed, reach = 0.0;
  if (e.fraction == 0.0) {
    reach = rigid + (s * tipX + c * tipY);
    if (!mayLeave_ || reach > height) heights[m] = reach;
  } else {
    // Between two cells: read both, and leave the reach the edge had when it passed the one behind.
    const int next = m + 1 == cells_ ? 0 : m + 1, before = m == 0 ? cells_ - 1 : m - 1;
    const double s0 = s;
    s = s0 * e.cosineRest + c * e.sineRest;
    c = c * e.cosineRest - s0 * e.sineRest;
    rigid = e.runout + s * fed;
    reach = rigid + (s * tipX + c * tipY);
    weight += e.fraction * (surface_.weight()[next] - weight);
    height += e.fraction * (heights[next] - height);
    const double last = e.hasReach && surface_.live()[before] != 0 ? e.lastReach : reach;
    const double passed = reach - e.fraction * (reach - last);
    if (!mayLeave_ || passed > heights[m]) heights[m] = passed;
    e.lastReach = reach;
    e.hasReach = true;
  }
  const double met = SurfaceHistory::isFresh(height) ? s * (fed - chipPerFeed_ * flatFeedPerTooth()) : height;
  const double chip = (rigid - met) + (s * tipX + c * tipY);
  if (weight == 0.0 || (mayLeave_ && chip <= 0.0)) return;
  const Material& mat = model_.material;
  const double scale = weight * e.depth * forceScale_;
  const double perTangential = scale * mat.tangential, perRadial = scale * mat.radial;
  const double area = linearChip_ ? chip : std::copysign(std::pow(std::abs(chip), mat.exponent), chip);
  const double edgeTangential = scale * mat.tangentialEdge;
  double edgeRadial = scale * mat.radialEdge;
  // Indentation under the flank opposes the radial speed; the radial force counts inwards.
  if (mat.processDamping != 0.0) {
    edgeRadial += scale * mat.processDamping * (s * speedX + c * speedY) / (omega_ * radius_);
  }
  sum.x -= area * (perTangential * c + perRadial * s) + (edgeTangential * c + edgeRadial * s);
  sum.y += area * (perTangential * s - perRadial * c) + (edgeTangential * s - edgeRadial * c);
  sum.tangential += area * perTangential + edgeTangential;
}

RegenerativeCut::Forces RegenerativeCut::cut(double tipX, double tipY, double speedX, double speedY) noexcept {
  Forces sum;
  for (int i = 0; i < liveEdges_; ++i) cutEdge(edges_[at(i)], tipX, tipY, speedX, speedY, sum);
  return sum;
}

void RegenerativeCut::advance(int steps) noexcept {
  const double dx = feed_ * stepTime_;
  for (int n = 0; n < steps; ++n) {
    if (++cell_ == cells_) cell_ = 0;
    x_ += dx;
    time_ += stepTime_;
    double tipX = 0.0, tipY = 0.0, speedX = 0.0, speedY = 0.0;
    for (int i = 0; i < modes_; ++i) {
      const auto k = at(i);
      const Transition& t = step_[k];
      const double f = drivenX_ * dx_[k] + drivenY_ * dy_[k] + pushed_[k];
      const double q = (t.qq * q_[k] + t.qv * v_[k]) + t.qf * f;
      v_[k] = (t.vq * q_[k] + t.vv * v_[k]) + t.vf * f;
      q_[k] = q;
      tipX += dx_[k] * q;
      tipY += dy_[k] * q;
      speedX += dx_[k] * v_[k];
      speedY += dy_[k] * v_[k];
    }
    const Forces now = leavesMarks_ ? cut(tipX, tipY, speedX, speedY) : cut(0.0, 0.0, 0.0, 0.0);
    const double riseX = now.x + outerX_ - drivenX_, riseY = now.y + outerY_ - drivenY_;
    for (int i = 0; i < modes_; ++i) {
      const auto k = at(i);
      const double rise = riseX * dx_[k] + riseY * dy_[k];
      q_[k] += step_[k].qr * rise;
      v_[k] += step_[k].vr * rise;
    }
    for (int i = firstPushed_; i < modes_; ++i) {
      const auto k = at(i);
      q_[k] += step_[k].qr * lead_[k];
      v_[k] += step_[k].vr * lead_[k];
      pushed_[k] += lead_[k];
      lead_[k] = slope_[k] * stepTime_;
    }
    fx_ = now.x;
    fy_ = now.y;
    drivenX_ += riseX;
    drivenY_ += riseY;
    torqueSum_ += now.tangential;
  }
  torqueSteps_ += steps;
}

double RegenerativeCut::acceleration(int mode) const noexcept {
  const auto k = at(mode);
  const double f = drivenX_ * dx_[k] + drivenY_ * dy_[k] + pushed_[k];
  return (f - damper_[k] * v_[k] - stiffness_[k] * q_[k]) / mass_[k];
}

std::array<double, 2> RegenerativeCut::tip() const noexcept {
  std::array<double, 2> p{};
  for (int i = 0; i < modes_; ++i) {
    p[0] += dx_[at(i)] * q_[at(i)];
    p[1] += dy_[at(i)] * q_[at(i)];
  }
  return p;
}

std::array<double, 2> RegenerativeCut::tipAcceleration() const noexcept {
  std::array<double, 2> a{};
  for (int i = 0; i < modes_; ++i) {
    const double acc = acceleration(i);
    a[0] += dx_[at(i)] * acc;
    a[1] += dy_[at(i)] * acc;
  }
  return a;
}

double RegenerativeCut::takeMeanTorque() noexcept {
  const double mean = torqueSteps_ > 0 ? torqueSum_ * radius_ / static_cast<double>(torqueSteps_) : 0.0;
  torqueSum_ = 0.0;
  torqueSteps_ = 0;
  return mean;
}

}  // namespace stillcut::milling
