#include "core/milling/stability/semi_discretization.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/milling/stability/argument_principle.h"
#include "core/milling/stability/cell_map.h"
#include "core/milling/stability/dominant_line.h"

namespace stillcut::milling {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kLeastCells = 40, kMostCells = 2000;
constexpr double kCellsPerWave = 8.0;

// Calls `use` with the cell map of the right size.
template <class Use>
auto withMap(const ExactLobes& lobes, Rpm speed, double depth, const SdmOptions& options, WorkMeter& meter,
             const Use& use) {
  const RegenerativeSystem system = systemAt(lobes.model(), Metres(depth));
  const auto run = [&]<int N, int A>() {
    return use(CellMap<N, A>(system, speed, depth, options.cells, options.order, meter));
  };
  if (system.states() == 2) return run.template operator()<2, 1>();
  if (system.states() == 4 && system.axes == 2) return run.template operator()<4, 2>();
  return run.template operator()<Eigen::Dynamic, 2>();
}

template <class Map>
std::optional<int> countOutside(const Map& map) {
  const auto n = static_cast<int>(map.states());
  const auto value = [&](double angle) { return map.characteristic(std::polar(1.0, angle)); };
  const double change = argumentChange(value, 0.0, kPi, 3 + n);
  if (!std::isfinite(change)) return std::nullopt;
  return n - static_cast<int>(std::lround(change / kPi));
}

struct CirclePoint {
  double angle;
  double depth;
};

class SdmRoot {
 public:
  SdmRoot(const ExactLobes& lobes, Rpm speed, const SdmOptions& options, WorkMeter& meter)
      : lobes_(lobes), speed_(speed), options_(options), meter_(meter) {}

  // Narrows [stable, unstable] to a thousandth, then Newton in (theta, w); bisection to the end where that leaves the
  // bracket.
  CirclePoint find(double stable, double unstable) const {
    double low = stable;
    double high = unstable;
    for (double width = 1e-3; high - low > 1e-10 * high && !meter_.stopped(); width *= 1e-2) {
      while (high - low > width * high && !meter_.stopped()) halve(low, high);
      const double middle = 0.5 * (low + high);
      if (const auto root = newton({closestAngle(middle), middle}); root && root->depth >= low && root->depth <= high) {
        return *root;
      }
      if (width < 1e-9) break;
    }
    return {closestAngle(high), high};
  }

 private:
  std::complex<double> value(double angle, double depth) const {
    return withMap(lobes_, speed_, depth, options_, meter_,
                   [&](const auto& map) { return map.characteristic(std::polar(1.0, angle)); });
  }

  void halve(double& low, double& high) const {
    const double middle = 0.5 * (low + high);
    const auto outside =
        withMap(lobes_, speed_, middle, options_, meter_, [](const auto& map) { return countOutside(map); });
    (outside.value_or(1) > 0 ? high : low) = middle;
  }

  double closestAngle(double depth) const {
    return withMap(lobes_, speed_, depth, options_, meter_, [](const auto& map) {
      double best = 0.0;
      double smallest = std::numeric_limits<double>::infinity();
      for (int i = 0; i <= 180; ++i) {
        const double angle = kPi * i / 180;
        const double size = std::abs(map.characteristic(std::polar(1.0, angle)));
        if (size >= smallest) continue;
        smallest = size;
        best = angle;
      }
      return best;
    });
  }

  std::optional<CirclePoint> newton(CirclePoint at) const {
    for (int i = 0; i < 15 && !meter_.stopped(); ++i) {
      const double ha = 1e-5;
      const double hw = 1e-5 * at.depth;
      const auto f = value(at.angle, at.depth);
      const auto fa = (value(at.angle + ha, at.depth) - value(at.angle - ha, at.depth)) / (2 * ha);
      const auto fw = (value(at.angle, at.depth + hw) - value(at.angle, at.depth - hw)) / (2 * hw);
      const double det = fa.real() * fw.imag() - fa.imag() * fw.real();
      const double da = (-f.real() * fw.imag() + f.imag() * fw.real()) / det;
      const double dw = (-fa.real() * f.imag() + fa.imag() * f.real()) / det;
      if (!std::isfinite(da) || !std::isfinite(dw) || std::abs(da) > 0.5 || std::abs(dw) > 0.2 * at.depth) break;
      at.angle += da;
      at.depth += dw;
      if (std::abs(da) < 1e-9 && std::abs(dw) < 1e-11 * at.depth) return at;
    }
    return std::nullopt;
  }

  const ExactLobes& lobes_;
  Rpm speed_;
  SdmOptions options_;
  WorkMeter& meter_;
};

}  // namespace

double wavesBetweenTeeth(const CutModel& model, Rpm speed) {
  double fastest = 0.0;
  for (const Mode& m : model.modes) fastest = std::max(fastest, m.frequency.value);
  return fastest / toothPassing(speed, model.tool.teeth).value;
}

int cellsFor(const CutModel& model, Rpm speed) {
  const double wanted = std::ceil(kCellsPerWave * wavesBetweenTeeth(model, speed));
  return static_cast<int>(std::clamp(wanted, static_cast<double>(kLeastCells), static_cast<double>(kMostCells)));
}

SdmOptions SemiDiscretization::optionsAt(Rpm speed) const {
  return {options_.cells > 0 ? options_.cells : cellsFor(lobes_.model(), speed), options_.order};
}

Result<SemiDiscretization> SemiDiscretization::make(const CutModel& model, const SdmOptions& options,
                                                    const std::string& where) {
  if (options.order != 0 && options.order != 1) {
    return Error{where, message("the order of semi-discretization must be 0 or 1")};
  }
  if (options.cells < 0 || options.cells > kMostCells) {
    return Error{where, message("semi-discretization needs 1 to 2000 cells a tooth period")};
  }
  Result<ExactLobes> lobes = ExactLobes::make(model, where);
  if (!lobes) return lobes.error();
  if (isShaped(model.tool)) {
    return Error{where + ": tool", message("semi-discretization takes no corner radius and no serration"),
                 message("the exact method takes any")};
  }
  if (!lobes->pattern().alike) {
    return Error{where + ": tool", message("semi-discretization needs teeth of one pitch and one helix"),
                 message("the exact method takes any")};
  }
  return SemiDiscretization(std::move(lobes.value()), options);
}

std::optional<int> SemiDiscretization::outside(Rpm speed, Metres depth) const {
  WorkMeter meter;
  return outside(speed, depth, meter);
}

std::optional<int> SemiDiscretization::outside(Rpm speed, Metres depth, WorkMeter& meter) const {
  return withMap(lobes_, speed, depth.value, optionsAt(speed), meter,
                 [](const auto& map) { return countOutside(map); });
}

Result<SpeedLimits> SemiDiscretization::limit(Rpm speed, Metres maxAxialDepth, int scan,
                                              const std::stop_token& stop) const {
  WorkMeter meter(stop);
  return limit(speed, maxAxialDepth, scan, meter);
}

Result<SpeedLimits> SemiDiscretization::limit(Rpm speed, Metres maxAxialDepth, int scan, WorkMeter& meter) const {
  if (Status ok = lobes_.checkSpeed(speed); !ok) return ok.error();
  if (Status ok = ExactLobes::checkDepth(maxAxialDepth); !ok) return ok.error();
  SpeedLimits result;
  result.speed = speed;
  for (int i = 1; i <= scan; ++i) {
    const double depth = i == scan ? maxAxialDepth.value : maxAxialDepth.value * i / scan;
    const std::optional<int> count = outside(speed, Metres(depth), meter);
    if (meter.stopped()) return result;
    if (!count || *count != 0) {
      const double below = maxAxialDepth.value * (i - 1) / scan;
      const CirclePoint root = SdmRoot(lobes_, speed, optionsAt(speed), meter).find(below, depth);
      if (!meter.stopped()) result.crossings.push_back(limitAt(speed, root.angle, root.depth, meter));
    }
    if (meter.stopped()) return result;
    result.searchedTo = Metres(depth);
    if (result.hasLimit()) break;
  }
  result.verified = true;
  return result;
}

StabilityLimit SemiDiscretization::limitAt(Rpm speed, double rootAngle, double depth, WorkMeter& meter) const {
  StabilityLimit limit;
  limit.speed = speed;
  limit.depth = Metres(depth);
  const double angle = std::abs(std::remainder(rootAngle, kTwoPi));
  limit.kind = kPi - angle < 1e-6 ? CrossingKind::Flip : CrossingKind::Hopf;
  limit.angle = Radians(angle);
  limit.after = limit.kind == CrossingKind::Flip ? 1 : 2;
  const SdmOptions options = optionsAt(speed);
  limit.frequency = withMap(lobes_, speed, depth, options, meter, [&](const auto& map) {
    return dominantLine(map.tipMotion(std::polar(1.0, angle)), angle, lobes_.system().toothPeriod(speed),
                        std::max(1, options.cells / 2 - 1), meter);
  });
  return limit;
}

}  // namespace stillcut::milling
