// The physics of a cut in TOML: the tables [[mode]], [tool], [material], [engagement] that scenarios, lobe cases and
// identified models share; [turning] stands in the place of [tool] and [engagement].
// Thread: set-up.
#pragma once

#include <optional>
#include <string>

#include "core/config/toml_reader.h"
#include "core/milling/cut_model.h"

namespace stillcut::milling {

// Identified elsewhere: take the place of the file's own [[mode]] or [material], which may then be missing.
struct ModelParts {
  std::vector<Mode> modes;
  std::optional<Material> material;
};

// Errors collect in the reader; the caller asks it, and check()s the model. [modal_fit] and [force_fit], the notes of
// an identification, may stand beside the tables they belong to. `material = "NAME"` instead of the table [material],
// or `name` in it, takes the values of material_table.h; what stands beside the name replaces them one by one.
CutModel readModel(const config::TomlTable& root, const ModelParts& parts = {});
// One of them, for files that hold only modes or only a material.
std::vector<Mode> readModes(const config::TomlTable& root);
Material readMaterial(const config::TomlTable& table);

std::string modelText(const CutModel& model);
std::string modesText(const std::vector<Mode>& modes);
std::string materialText(const Material& material);

// Shortest text that reads back as the same number; always with a point or exponent.
std::string numberText(double value);
// The text of value/unit that reads back, times unit, as the same number (1.3e-4 m with unit 1e-3: "0.13").
std::string numberText(double value, double perUnit);
// What a file says in `perUnit`-ths of the SI unit, in SI: 0.13 with 1e3 per metre is 1.3e-4 m.
inline double inSi(double value, double perUnit) {
  return value / perUnit;
}

}  // namespace stillcut::milling
