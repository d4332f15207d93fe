// Tap test files of any kind this program reads: a frequency response function (text of frequency, real, imaginary;
// universal file), or a hammer record (text of time, force, acceleration; universal file with two time responses).
// Thread: any, set-up path. Errors: one line with file, place and cause.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/result.h"
#include "core/milling/identify/frf.h"
#include "core/milling/identify/hammer.h"

namespace stillcut::identify {

enum class MeasurementKind { Automatic, Frf, Hammer };

struct ImportOptions {
  MeasurementKind kind = MeasurementKind::Automatic;
  std::optional<FrfQuantity> quantity;  // overrules the file; a text without units counts as compliance
  std::optional<double> scale;          // factor of the response to SI; overrules the file's units
  std::size_t dataset = 0;              // which FRF of a universal file, from 0
};

struct Measurement {
  std::variant<Frf, HammerRecord> data;
  std::vector<std::string> remarks;  // what was assumed
};

// Automatic: a universal file says what it holds; of a text, a header naming time or frequency decides, else the first
// column's step: below 5 ms it is time (no FRF is that fine), above it is frequency.
Result<Measurement> importMeasurement(const std::string& path, const ImportOptions& options);

// The same from the file's content.
Result<Measurement> parseMeasurement(std::string_view bytes, const std::string& where, const ImportOptions& options);

}  // namespace stillcut::identify
