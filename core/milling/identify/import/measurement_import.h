// Tap test files of any kind this program reads. A frequency response: text with any columns, universal file, MATLAB.
// A hammer record: everything recordings are read from (core/session/open_recording.h), universal files with their
// directions.
// Thread: any, set-up path. Errors: one line with file, cause and the option that would help.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/base/result.h"
#include "core/milling/identify/frf.h"
#include "core/milling/identify/hammer.h"
#include "core/milling/identify/import/import_options.h"

namespace stillcut::identify {

struct Measurement {
  // One a response along an axis, rising in axis, at least one.
  std::variant<std::vector<Frf>, std::vector<HammerRecord>> data;
  std::vector<Message> remarks;  // what was taken, and what was left
};

// Automatic: a universal file says what it holds; a text or a MATLAB file by its columns (frf_table.h).
Result<Measurement> importMeasurement(const std::string& path, const ImportOptions& options);

}  // namespace stillcut::identify
