// What foreign units are in SI units. Exact by definition. Constants: any thread.
#pragma once

namespace stillcut {

inline constexpr double kStandardGravity = 9.80665;     // [m/s^2] one g (ISO 80000-3)
inline constexpr double kInch = 0.0254;                 // [m]
inline constexpr double kPoundForce = 4.4482216152605;  // [N] one lbf: 0.45359237 kg at one g

}  // namespace stillcut
