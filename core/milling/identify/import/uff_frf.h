// Tap tests in universal files, dataset 58: frequency responses, or force and responses over time. Units from the axes
// of each function, where they are silent from dataset 164; directions and signs from the degrees of freedom.
// Thread: any, set-up path. Errors: one line with file, dataset and the option to give.
#pragma once

#include <string>
#include <vector>

#include "core/formats/universal/uff58.h"
#include "core/milling/identify/import/frf_table.h"
#include "core/milling/identify/import/time_channels.h"
#include "core/milling/identify/import/uff_units.h"

namespace stillcut::identify {

bool holdsFrfs(const std::vector<uff::Uff58Dataset>& sets);

Result<ImportedFrfs> frfsFromUff(const std::vector<uff::Uff58Dataset>& sets, const std::optional<UffUnits>& units,
                                 const std::string& where, const ImportOptions& options);
Result<TimeChannels> timeChannelsFromUff(const std::vector<uff::Uff58Dataset>& sets,
                                         const std::optional<UffUnits>& units, const std::string& where);

}  // namespace stillcut::identify
