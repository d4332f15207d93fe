// Along which machine axis a force or a response points. Values: any thread.
#pragma once

#include <string_view>

namespace stillcut::identify {

enum class Axis { Unknown, X, Y, Z };

constexpr std::string_view name(Axis axis) {
  return axis == Axis::X ? "x" : axis == Axis::Y ? "y" : axis == Axis::Z ? "z" : "";
}

constexpr Axis axisFromLetter(char letter) {
  return letter == 'x' || letter == 'X'   ? Axis::X
         : letter == 'y' || letter == 'Y' ? Axis::Y
         : letter == 'z' || letter == 'Z' ? Axis::Z
                                          : Axis::Unknown;
}

}  // namespace stillcut::identify
