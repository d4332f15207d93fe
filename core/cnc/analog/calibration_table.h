// CalibrationTable: what a voltage means on an analog input of a machine, as measured point by point. Straight lines
// between the points, nothing beyond the ends.
// Thread: made at set-up; voltage() on the link thread, real-time safe.
#pragma once

#include <utility>
#include <vector>

#include "core/base/result.h"

namespace stillcut::cnc {

class CalibrationTable {
 public:
  struct Point {
    double volts = 0.0;
    double value = 0.0;  // percent or rev/min
  };
  // At least two points; voltages rise, values strictly rise or strictly fall. `where` names the table in the error.
  static Result<CalibrationTable> make(std::vector<Point> points, const std::string& where);

  double lowest() const;   // value
  double highest() const;  // value
  // The voltage for `value`, which is brought inside the table's range first. Finite for every finite value.
  double voltage(double value) const noexcept;

 private:
  explicit CalibrationTable(std::vector<Point> points) : points_(std::move(points)) {}
  std::vector<Point> points_;
};

}  // namespace stillcut::cnc
