// stillcut-cli info FILE [--repair] [--json]

#include <cstdio>

#include "app/cli/command.h"
#include "core/record/describe_recording.h"
#include "core/record/session_reader.h"

namespace stillcut::app {
namespace {

struct InfoOptions {
  std::string file;
  bool repair = false, json = false;
  double rate = 0.0;
};

int info(const InfoOptions& options) {
  if (options.repair) {
    const auto repaired = record::repairSession(options.file);
    if (!repaired) return fail(repaired.error());
  }
  record::ReadOptions read;
  if (options.rate > 0.0) read.rate = Hertz(options.rate);
  const auto description = record::describeRecording(options.file, read);
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
  command->add_option("--rate", o->rate, "Sampling rate of a text file without times [Hz]");
  command->add_flag("--json", o->json, "Print one JSON object");
  command->callback([o, &exitCode] { exitCode = info(*o); });
}

}  // namespace stillcut::app
