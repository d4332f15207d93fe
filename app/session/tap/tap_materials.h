// Cutting coefficients of common materials for first lobes, where the shop has not measured its own. Thread: any.
#pragma once

#include <span>
#include <string_view>

#include "core/milling/cut_model.h"

namespace stillcut::app {

struct TapMaterialRow {
  std::string_view id, name;  // name in English
  milling::Material material;
  double spread = 0.2;  // standard deviation of all its coefficients together, over the value
};

std::span<const TapMaterialRow> tapMaterials();
// Null: none of that id.
const TapMaterialRow* findTapMaterial(std::string_view id);
// The first one where there is no such id.
const TapMaterialRow& tapMaterial(std::string_view id);

}  // namespace stillcut::app
