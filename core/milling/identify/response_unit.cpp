#include "core/milling/identify/response_unit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "core/base/conversions.h"

namespace stillcut::identify {
namespace {

struct UsualUnit {
  std::string_view name;
  double factor;
};
constexpr auto kUsual =
    std::to_array<UsualUnit>({{"m/N", 1.0}, {"mm/N", 1e-3}, {"um/N", 1e-6}, {"in/lbf", kInch / kPoundForce}});

// The imaginary part of a driving point's compliance is negative; that of its accelerance is positive.
bool looksLikeCompliance(const Frf& frf) {
  double sum = 0.0;
  double size = 0.0;
  for (const auto& v : frf.value) {
    sum += v.imag();
    size += std::abs(v.imag());
  }
  return sum < -0.5 * size;
}

}  // namespace

Result<UnitFound> unitByStiffness(const Frf& frf, const ModalOptions& options) {
  const Error ask{frf.source, message("does not say the unit of its response"),
                  message("give --unit m/N, mm/N, um/N, (m/s^2)/N or g/N")};
  if (frf.quantity != FrfQuantity::Compliance || !looksLikeCompliance(frf)) return ask;
  const auto fit = fitModes(frf, options);
  if (!fit) return ask;
  double softest = fit->modes.front().mode.stiffness;
  for (const IdentifiedMode& m : fit->modes) softest = std::min(softest, m.mode.stiffness);
  const UsualUnit* only = nullptr;
  for (const UsualUnit& unit : kUsual) {
    const double stiffness = softest / unit.factor;
    if (stiffness < kSoftestTool || stiffness > kStiffestTool) continue;
    if (only != nullptr) return ask;
    only = &unit;
  }
  if (only == nullptr) return ask;
  return UnitFound{only->factor,
                   message("no unit in the file: read as %1, the only usual one that gives the stiffness of a tool "
                           "(--unit says otherwise)",
                           only->name)};
}

}  // namespace stillcut::identify
