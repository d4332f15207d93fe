#include "core/milling/identify/import/measurement_import.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/formats/universal/uff58.h"
#include "core/milling/identify/import/file_bytes.h"
#include "core/milling/identify/import/frf_table.h"
#include "core/milling/identify/import/hammer_channels.h"
#include "core/milling/identify/import/mat_table.h"
#include "core/milling/identify/import/uff_frf.h"

namespace stillcut::identify {
namespace {

constexpr std::size_t kHead = std::size_t{256} * 1024;

Result<Measurement> frfsAs(Result<ImportedFrfs> frfs) {
  if (!frfs) return frfs.error();
  return Measurement{std::move(frfs->frfs), std::move(frfs->remarks)};
}

Result<Measurement> hammerAs(const TimeChannels& channels, const ImportOptions& options) {
  auto hammer = hammerFromChannels(channels, options);
  if (!hammer) return hammer.error();
  return Measurement{std::move(hammer->records), std::move(hammer->remarks)};
}

Result<Measurement> fromUff(std::string_view bytes, const std::string& where, const ImportOptions& options) {
  const auto sets = uff::parseUff58(bytes, where);
  if (!sets) return sets.error();
  const auto units = unitsOfUff(bytes);
  const bool frf =
      options.kind == MeasurementKind::Frf || (options.kind == MeasurementKind::Automatic && holdsFrfs(*sets));
  if (frf) return frfsAs(frfsFromUff(*sets, units, where, options));
  const auto channels = timeChannelsFromUff(*sets, units, where);
  return channels ? hammerAs(*channels, options) : Result<Measurement>(channels.error());
}

Result<Measurement> fromRecording(const std::string& path, const ImportOptions& options) {
  if (!options.open) return Error{path, message("is no frequency response")};
  record::ReadOptions reading;
  reading.rate = options.rate;
  reading.secondsPerTime = options.secondsPerTime;
  auto reader = options.open(path, reading);
  if (!reader) return reader.error();
  const auto channels = readTimeChannels(**reader, path);
  return channels ? hammerAs(*channels, options) : Result<Measurement>(channels.error());
}

// A recording whose channels are the columns of frequency responses, as HDF5 files of other programs hold them: the
// reader asks for a sampling rate, which has no meaning here.
Result<Measurement> fromColumns(const std::string& path, const ImportOptions& options) {
  record::ReadOptions reading;
  reading.rate = Hertz(1.0);
  auto reader = options.open(path, reading);
  if (!reader) return reader.error();
  const auto channels = readTimeChannels(**reader, path);
  if (!channels) return channels.error();
  NumberTable table;
  for (const TimeChannel& c : channels->channels) table.columns.push_back({c.name, c.unit, c.samples, {}});
  if (table.rows() < 2 || !looksLikeFrfs(table)) return Error{path, message("is no frequency response")};
  return frfsAs(frfsFromTable(table, path, options));
}

Result<Measurement> fromText(std::string_view bytes, const std::string& path, const ImportOptions& options) {
  bool frf = options.kind == MeasurementKind::Frf;
  if (options.kind == MeasurementKind::Automatic) {
    std::string_view head = bytes.substr(0, kHead);
    if (head.size() < bytes.size()) head = head.substr(0, head.rfind('\n') + 1);
    const auto begins = parseNumberTable(head, path, 3);
    frf = begins && looksLikeFrfs(*begins);
    if (!begins && !options.open) return begins.error();
  }
  if (!frf) return fromRecording(path, options);
  const auto table = parseNumberTable(bytes, path, 3);
  return table ? frfsAs(frfsFromTable(*table, path, options)) : Result<Measurement>(table.error());
}

Result<Measurement> fromMat(const std::string& path, const ImportOptions& options) {
  const auto table = readMatTable(path);
  const bool frf = options.kind == MeasurementKind::Frf ||
                   (options.kind == MeasurementKind::Automatic && table && looksLikeFrfs(*table));
  if (!frf) return fromRecording(path, options);
  return table ? frfsAs(frfsFromTable(*table, path, options)) : Result<Measurement>(table.error());
}

Result<Measurement> fromOther(const std::string& path, const ImportOptions& options) {
  if (options.kind == MeasurementKind::Frf) return fromColumns(path, options);
  auto hammer = fromRecording(path, options);
  if (hammer || options.kind == MeasurementKind::Hammer || !options.open) return hammer;
  auto columns = fromColumns(path, options);
  return columns ? columns : hammer;
}

bool isText(std::string_view bytes) {
  return bytes.substr(0, 4096).find('\0') == std::string_view::npos;
}

}  // namespace

Result<Measurement> importMeasurement(const std::string& path, const ImportOptions& options) {
  if (options.scale && !(std::isfinite(*options.scale) && *options.scale != 0.0)) {
    return Error{path, message("the scale is not a number other than 0")};
  }
  const auto bytes = readFileBytes(path);
  const bool placeInside = !bytes && path.find(":/") != std::string::npos;  // "FILE.h5:/folder"
  if (placeInside && options.open) return fromOther(path, options);
  if (!bytes) return bytes.error();
  if (uff::looksLikeUff(*bytes)) return fromUff(*bytes, path, options);
  if (bytes->starts_with("MATLAB 5.0")) return fromMat(path, options);
  if (isText(*bytes)) return fromText(*bytes, path, options);
  return fromOther(path, options);
}

}  // namespace stillcut::identify
