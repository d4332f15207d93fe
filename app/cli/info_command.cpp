// stillcut-cli info FILE [--repair] [--json]

#include <cstdio>

#include "app/cli/command.h"
#include "app/cli/reading_options.h"
#include "core/session/describe_recording.h"
#include "core/session/file/session_reader.h"

namespace stillcut::app {
namespace {

struct InfoOptions {
  std::string file;
  bool repair = false, json = false;
  ReadingOptions reading;
};

int info(const InfoOptions& options) {
  const auto read = options.reading.understand();
  if (!read) return fail(read.error());
  if (options.repair) {
    const auto repaired = record::repairSession(options.file);
    if (!repaired) return fail(repaired.error());
    if (!options.json) std::printf("%s\n", *repaired ? "repaired" : "nothing to repair");
  }
  const auto description = record::describeRecording(options.file, *read);
  if (!description) return fail(description.error());
  std::printf("%s", options.json ? record::toJson(*description).c_str() : record::toText(*description).c_str());
  return kExitDone;
}

}  // namespace

void addInfo(CLI::App& app, int& exitCode) {
  auto o = std::make_shared<InfoOptions>();
  CLI::App* command = app.add_subcommand("info", "Say what a recording holds");
  command->add_option("FILE", o->file, "Sound file, text table, or Stillcut session")->required();
  command->add_flag("--repair", o->repair, "Make a session whole that was not closed");
  o->reading.add(*command);
  command->add_flag("--json", o->json, "Print one JSON object");
  command->callback([o, &exitCode] { exitCode = info(*o); });
}

}  // namespace stillcut::app
