#include "app/session/tap/tap_materials.h"

#include <array>

namespace stillcut::app {
namespace {

milling::Material linear(double tangential, double radial) {
  milling::Material m;
  m.tangential = tangential;
  m.radial = radial;
  return m;
}

}  // namespace

// 7075-T6: Altintas and Budak 1995 (K_t = 796 N/mm2, K_r = 0.212 K_t). The others: specific cutting force of the group
// at a chip of 0.05 mm by Kienzle's law, radial share 0.36, as in Schmitz and Smith, Machining Dynamics, chapter 4.
std::span<const TapMaterialRow> tapMaterials() {
  static const std::array<TapMaterialRow, 6> kRows{{
      {"7075-T6", "Aluminium, wrought", linear(7.96e8, 1.69e8), 0.15},
      {"cast-aluminium", "Aluminium, cast", linear(1.0e9, 3.6e8), 0.2},
      {"1045", "Steel, unalloyed", linear(2.9e9, 1.04e9), 0.2},
      {"4140", "Steel, alloyed, tempered", linear(3.5e9, 1.26e9), 0.2},
      {"cast-iron", "Cast iron, grey", linear(1.9e9, 6.8e8), 0.2},
      {"Ti-6Al-4V", "Titanium alloy", linear(2.6e9, 9.4e8), 0.2},
  }};
  return kRows;
}

const TapMaterialRow* findTapMaterial(std::string_view id) {
  for (const TapMaterialRow& row : tapMaterials()) {
    if (row.id == id) return &row;
  }
  return nullptr;
}

const TapMaterialRow& tapMaterial(std::string_view id) {
  const TapMaterialRow* row = findTapMaterial(id);
  return row != nullptr ? *row : tapMaterials().front();
}

}  // namespace stillcut::app
