#include "core/detect/registry.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <string>
#include <vector>

#include "core/detect/energy_ratio.h"

namespace stillcut::detect {
namespace {

template <class T>
std::unique_ptr<Detector> make() {
  return std::make_unique<T>();
}

constexpr std::array<DetectorRow, 1> kTable{{
    {"energy-ratio", make<EnergyRatioDetector>, energyRatioParams},
}};

std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t substitute = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({substitute, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row[b.size()];
}

}  // namespace

std::span<const DetectorRow> detectorTable() {
  return kTable;
}

Result<std::unique_ptr<Detector>> makeDetector(std::string_view id) {
  for (const DetectorRow& row : kTable) {
    if (row.id == id) return row.make();
  }
  const auto* nearest = std::min_element(kTable.begin(), kTable.end(), [id](const auto& a, const auto& b) {
    return editDistance(id, a.id) < editDistance(id, b.id);
  });
  return Error{"detector", "unknown id '" + std::string(id) + "'", "did you mean '" + std::string(nearest->id) + "'?"};
}

}  // namespace stillcut::detect
