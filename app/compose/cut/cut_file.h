// One cut from any file that describes one: a lobe case, a scenario, or a machine's profile with its model. What the
// commands `lobes` and `advise` start from, so that they say the same of all three.
// Thread: set-up.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/milling/model_toml.h"
#include "core/milling/stability/measured_receptance.h"

namespace stillcut::app {

struct CutFile {
  std::string name;
  milling::CutModel model;
  Metres maxAxialDepth{};          // of the chart
  Metres depth{};                  // of the cut; 0: the file does not say
  Rpm lowest{}, highest{};         // what the speed override reaches; both 0: the file does not say
  Metres feedPerTooth{};           // 0: the file does not say
  std::vector<Message> remarks{};  // what was made of the file's words
  std::optional<milling::MeasuredReceptance> measured{};  // frequency responses given beside it
};

// What is said beside the file, and counts before the force law is linearised.
struct CutChanges {
  Metres feedPerTooth{};                            // 0: the file's
  std::optional<milling::Engagement> engagement{};  // instead of the file's
  std::optional<Metres> offset{};                   // of the cut's middle from the tool's axis
};

// `parts` stand in for the file's own modes and material. The engagement of a scenario is its widest, its depth the
// deepest, as its programme says; a force exponent is linearised at the mean chip where the feed is known.
Result<CutFile> loadCutFile(const std::string& path, const milling::ModelParts& parts = {},
                            const CutChanges& changes = {});

}  // namespace stillcut::app
