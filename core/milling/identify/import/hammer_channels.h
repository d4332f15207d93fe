// Which channel of a recording is the hammer, which the response, and in what unit: from the file, from the options,
// and where neither says it, asked for by name. A factor is never guessed.
// Thread: any, set-up path. Errors: one line that names every option that is missing.
#pragma once

#include <vector>

#include "core/milling/identify/hammer.h"
#include "core/milling/identify/import/import_options.h"
#include "core/milling/identify/import/time_channels.h"

namespace stillcut::identify {

struct ImportedHammer {
  std::vector<HammerRecord> records;  // one a response along an axis, rising in axis, at least one
  std::vector<Message> remarks;
};

Result<ImportedHammer> hammerFromChannels(const TimeChannels& channels, const ImportOptions& options);

}  // namespace stillcut::identify
