// The part of a frequency response a modal fit works on. Plain values: any thread.
#pragma once

#include <Eigen/Core>

namespace stillcut::identify {

struct ModalLines {
  Eigen::VectorXd frequency;  // [Hz], rising, > 0
  Eigen::VectorXcd value;     // compliance [m/N]
  double from = 0.0;          // band [Hz]
  double to = 0.0;
};

}  // namespace stillcut::identify
