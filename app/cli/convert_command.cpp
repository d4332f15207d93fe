// stillcut-cli convert IN OUT: recordings to any format there is an export for, shared cases from JSON to .toml.

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/cli/command.h"
#include "app/cli/out_path.h"
#include "app/cli/reading_options.h"
#include "core/milling/simulation/case_json.h"
#include "core/milling/stability/lobe_case.h"
#include "core/session/convert_recording.h"
#include "core/session/marker_span.h"

namespace stillcut::app {
namespace {

struct ConvertOptions {
  std::string in, out;
  ReadingOptions reading;
  std::optional<double> from, to;
  std::string marker;
};

// A cut to simulate tells what happens over time; a case for the lobes does not.
Result<bool> tellsProcess(const std::string& path) {
  std::ifstream in(path);
  if (!in) return Error{path, message("cannot be opened")};
  const nlohmann::json parsed = nlohmann::json::parse(in, nullptr, false);
  if (parsed.is_discarded() || !parsed.is_object())
    return Error{path, message("is no case"), message("not an object in JSON")};
  return parsed.contains("process");
}

Status convertCase(const std::string& from, const std::string& to) {
  const auto isCut = tellsProcess(from);
  if (!isCut) return isCut.error();
  if (*isCut) {
    const auto scenario = milling::loadCaseJson(from);
    return scenario ? milling::saveScenario(*scenario, to) : Status(scenario.error());
  }
  const auto lobes = milling::importLobeJson(from);
  return lobes ? milling::saveLobeCase(*lobes, to) : Status(lobes.error());
}

Status convert(const ConvertOptions& options) {
  const auto reading = options.reading.understand();
  if (!reading) return reading.error();
  if (Status free = checkOutPath(options.out, options.in); !free) return free;
  const auto suffix = [](const std::string& path) { return std::filesystem::path(path).extension().string(); };
  if (suffix(options.in) != ".json") {
    record::TimeSpan span;
    if (!options.marker.empty()) {
      const auto marked = record::markerSpan(options.in, options.marker);
      if (!marked) return marked.error();
      span = *marked;
    }
    if (options.from) span.from = Seconds(*options.from);
    if (options.to) span.to = Seconds(*options.to);
    return record::convertRecording(options.in, options.out, *reading, span);
  }
  if (suffix(options.out) != ".toml")
    return Error{options.out, message("cannot be written"), message("a case becomes a .toml file")};
  return convertCase(options.in, options.out);
}

}  // namespace

void addConvert(CLI::App& app, int& exitCode) {
  auto o = std::make_shared<ConvertOptions>();
  CLI::App* command = app.add_subcommand("convert", "Convert a recording, or a case from JSON to TOML");
  command->add_option("IN", o->in, "Recording, or CASE.json")->required();
  command->add_option("OUT", o->out, "FILE with .wav .flac .csv .mat .uff .unv .h5, or CASE.toml")->required();
  command->add_option("--from", o->from, "Only from this time on [s from the first sample]");
  command->add_option("--to", o->to, "Only up to this time [s from the first sample]");
  command->add_option("--marker", o->marker, "Only what this marker of a session spans: a label, a note, or #NUMBER");
  o->reading.add(*command);
  command->callback([o, &exitCode] {
    const Status done = convert(*o);
    exitCode = done ? kExitDone : fail(done.error());
  });
}

}  // namespace stillcut::app
