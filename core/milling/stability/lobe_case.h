// A lobe case in a file: the cut, the range of the chart, and what a reference file said besides. Own format TOML (the
// tables of model_toml.h, [chart] and [reference]); the shared reference cases come as JSON and convert without loss.
// Thread: set-up. Errors: one line with file, place and cause.
#pragma once

#include <map>
#include <string>

#include "core/base/result.h"
#include "core/milling/cut_model.h"
#include "core/milling/model_toml.h"

namespace stillcut::milling {

struct LobeCase {
  std::string name;
  CutModel model;
  Metres maxAxialDepth{0.010};
  // Everything else a JSON case says, as text under its key, nested keys joined by '-' ("sdm1_k40_rel_err-median",
  // "modes-0-m"): kept so that a conversion loses nothing; not read by any method.
  std::map<std::string, std::string> reference;
};

// Reads a .toml or a shared .json case, by its suffix; the model is checked, with `parts` in place.
Result<LobeCase> loadLobeCase(const std::string& path, const ModelParts& parts = {});
Result<LobeCase> importLobeJson(const std::string& path, const ModelParts& parts = {});
Result<LobeCase> readLobeCase(const std::string& path, const ModelParts& parts = {});
std::string lobeCaseText(const LobeCase& lobeCase);
Status saveLobeCase(const LobeCase& lobeCase, const std::string& path);

}  // namespace stillcut::milling
