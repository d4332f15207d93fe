#include "core/cnc/analog/calibration_table.h"

#include <algorithm>
#include <cmath>

namespace stillcut::cnc {

Result<CalibrationTable> CalibrationTable::make(std::vector<Point> points, const std::string& where) {
  if (points.size() < 2)
    return Error{where, message("has fewer than two points"), message("[[volts, value], [volts, value], ...]")};
  const bool rises = points[1].value > points[0].value;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(points[i].volts) || !std::isfinite(points[i].value)) {
      return Error{where, message("point %1 is not finite", std::to_string(i + 1))};
    }
    if (i == 0) continue;
    const std::string place = "point " + std::to_string(i + 1);
    if (!(points[i].volts > points[i - 1].volts))
      return Error{where, message("%1 has no higher voltage", place), message("they must rise")};
    const double step = points[i].value - points[i - 1].value;
    if (!(rises ? step > 0.0 : step < 0.0)) {
      return Error{where, message("%1 turns the table round", place), message("a value must belong to one voltage")};
    }
  }
  return CalibrationTable(std::move(points));
}

double CalibrationTable::lowest() const {
  return std::min(points_.front().value, points_.back().value);
}

double CalibrationTable::highest() const {
  return std::max(points_.front().value, points_.back().value);
}

double CalibrationTable::voltage(double value) const noexcept {
  const double inside = std::clamp(value, lowest(), highest());
  const bool rises = points_.back().value > points_.front().value;
  std::size_t i = 1;
  while (i + 1 < points_.size() && (rises ? points_[i].value < inside : points_[i].value > inside)) ++i;
  const Point& a = points_[i - 1];
  const Point& b = points_[i];
  return a.volts + (inside - a.value) / (b.value - a.value) * (b.volts - a.volts);
}

}  // namespace stillcut::cnc
