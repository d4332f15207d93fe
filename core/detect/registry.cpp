#include "core/detect/registry.h"

#include <algorithm>
#include <array>
#include <string>

#include "core/config/nearest_word.h"
#include "core/detect/caliskan/energy_ratio.h"
#include "core/detect/liao/spectral.h"
#include "core/detect/van_dijk/parametric.h"
#include "core/detect/xu/coherence.h"

namespace stillcut::detect {
namespace {

template <class T>
std::unique_ptr<Detector> make() {
  return std::make_unique<T>();
}

constexpr std::array<DetectorRow, 4> kTable{{
    {"parametric", make<ParametricDetector>, parametricParams},
    {"spectral", make<SpectralDetector>, spectralParams},
    {"energy-ratio", make<EnergyRatioDetector>, energyRatioParams},
    {"coherence", make<CoherenceDetector>, coherenceParams},
}};

}  // namespace

std::span<const DetectorRow> detectorTable() {
  return kTable;
}

Result<std::unique_ptr<Detector>> makeDetector(std::string_view id) {
  for (const DetectorRow& row : kTable) {
    if (row.id == id) return row.make();
  }
  std::array<std::string_view, kTable.size()> ids;
  std::transform(kTable.begin(), kTable.end(), ids.begin(), [](const DetectorRow& row) { return row.id; });
  return Error{message("detector"), message("unknown id '%1'", id), config::didYouMean(id, ids)};
}

}  // namespace stillcut::detect
