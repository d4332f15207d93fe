// stillcut-cli run --profile P.toml [--mode off|advise|auto] [--status] [--json] [--record FILE.h5] [--flights DIR]
//                  [--cuts FILE] [--seconds N] [--give-up N] [--log-level L]: the monitor without a screen. Prints what
//                  happens, a
// line a change, until the source ends, samples stop or somebody interrupts; then the machine has its programmed values
// back.

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <utility>

#include "app/cli/command.h"
#include "app/cli/run/run_watch.h"
#include "app/compose/ending/interruption.h"
#include "app/compose/learn/evidence_log.h"
#include "app/compose/profile_rig.h"
#include "app/compose/resource_folder.h"
#include "app/io/wires.h"
#include "core/pipeline/catalog.h"
#include "core/session/session_folder.h"
#include "generated/version.h"

namespace stillcut::app {
namespace {

struct RunOptions {
  std::string profile, record, job, flights, cuts, operatorName, logLevel = "info", mode = "off";
  double seconds = 0.0, giveUp = 10.0;
  bool json = false, status = false;

  Authority authority() const {
    return mode == "auto" ? Authority::Auto : mode == "advise" ? Authority::Advise : Authority::Off;
  }
};

Status checkOptions(const RunOptions& options) {
  for (const auto& [name, value, zero] : {std::tuple{"--seconds", options.seconds, message("0: to the end")},
                                          {"--give-up", options.giveUp, message("0: never")}}) {
    if (!(value >= 0.0 && std::isfinite(value))) return Error{name, message("must be a number from 0 up"), zero};
  }
  std::error_code unknown;
  if (std::filesystem::is_directory(options.record, unknown)) return Done{};
  if (!options.record.empty() && !options.record.ends_with(".h5")) {
    return Error{options.record, message("is no name for a session"),
                 message("the suffix must be .h5, or it must be a folder")};
  }
  return Done{};  // a folder that is away, as a share may be: said when the recording fails, and the cut is watched
}

// What Advise and Auto need is known before anything moves.
Status checkMode(const RunOptions& options, const config::Profile& profile, const Rig& rig) {
  if (options.authority() == Authority::Off) return Done{};
  if (profile.strategy == "monitor")
    return Error{options.profile, message("its strategy is 'monitor'"),
                 message("--mode needs one that advises, for example stable-pocket")};
  if (options.authority() != Authority::Auto) return Done{};
  if (!profile.allowAuto)
    return Error{options.profile, message("does not allow Auto"),
                 message("set allow_auto, once you have read safety.md")};
  return rig.hasLink() ? Status(Done{})
                       : Error{options.profile, message("has no link"), message("Auto needs a machine")};
}

// What is asked for here goes before what the profile says.
Status record(Rig& rig, const config::Profile& profile, const RunOptions& options) {
  const auto told = [](const record::Deleted& file) {
    if (file.problem.empty()) {
      std::fprintf(stderr, "deleted %s (%s)\n", file.file.c_str(), file.why.c_str());
    } else {
      fail(Error{file.file, message("cannot be deleted, though it is %1", file.why), foreign(file.problem)});
    }
  };
  if (options.record.empty()) return recordAsProfileSays(rig, profile, options.profile, told);
  const std::string origin = profileOrigin(profile, options.profile);
  std::error_code unknown;
  if (std::filesystem::is_directory(options.record, unknown)) return rig.recordInto(options.record, origin, told);
  Status recording = rig.recordToNew(options.record, origin);
  const std::string path = rig.recorder()->status().path;
  if (recording && path != options.record)
    std::fprintf(stderr, "%s is there already: recording to %s\n", options.record.c_str(), path.c_str());
  return recording;
}

// A replay and a simulation are no cuts of the shop, and are kept only where a file for them is named.
void keepCuts(std::optional<EvidenceLog>& cuts, const config::Profile& profile, const RunOptions& options) {
  const bool real = profile.source.id != "replay" && profile.source.id != "simulated";
  const auto known = evidenceOf(profile, options.profile);
  if (!known) fail(known.error());
  if ((options.cuts.empty() && !real) || !known || !*known) return;
  cuts.emplace(**known, options.cuts.empty() ? defaultCutStore() : std::filesystem::path(options.cuts));
}

int run(const RunOptions& options) {
  if (const Status usable = checkOptions(options); !usable) return fail(usable.error());
  const config::ParamCatalog catalog = pipeline::fullCatalog();
  auto profile = config::loadProfile(options.profile, catalog, knownIds());
  if (!profile) return fail(profile.error());
  if (!options.operatorName.empty()) profile->operatorName = options.operatorName;
  if (!options.job.empty()) profile->recording.job = options.job;
  const auto events = wireEvents();  // outlives the rig and its wires
  SetUpFault fault = SetUpFault::Input;
  const auto level = logLevelFrom(options.logLevel);
  auto log = ProgramLog::open(defaultLogFile(), level.value_or(LogLevel::Info));
  if (!log) fail(log.error());
  const ProgramLog into = log ? std::move(log).value() : ProgramLog();
  into.write(LogLevel::Info, "stillcut-cli " STILLCUT_VERSION " run starts");
  auto rig = buildProfileRig(*profile, options.profile, &fault);
  if (!rig) into.write(LogLevel::Error, "not started: " + rig.error().line());
  if (!rig) return fail(rig.error(), fault == SetUpFault::Hardware ? kExitDevice : kExitInput);
  if (const Status usable = checkMode(options, *profile, **rig); !usable) return fail(usable.error());
  const auto reporter = options.json ? makeJsonReporter(**rig) : makeTextReporter(**rig);
  mindInterruption();
  (void)record(**rig, *profile, options).ok();  // the console says what is not recorded
  std::optional<EvidenceLog> cuts;
  keepCuts(cuts, *profile, options);
  const RunWatchOptions watched{options.authority(),     options.status,  Seconds(options.seconds),
                                Seconds(options.giveUp), options.flights, cuts ? &*cuts : nullptr};
  return RunWatch(**rig, watched, into, *reporter).run({*profile, options.profile, options.authority()});
}

}  // namespace

void addRun(CLI::App& app, int& exitCode) {
  auto o = std::make_shared<RunOptions>();
  CLI::App* command = app.add_subcommand("run", "Monitor a machine without a screen");
  command->add_option("--profile", o->profile, "Profile of the machine (.toml)")->required();
  command->add_option(
      "--record", o->record,
      "Record to FILE.h5, or into a FOLDER as the parameters record.* say; left out: as the profile says");
  command->add_option("--job", o->job,
                      "Name of the job, kept in recordings and in their names; left out: as the profile says");
  command->add_option("--operator", o->operatorName, "Who signs markers; left out: as the profile says");
  command->add_option("--flights", o->flights, "Folder of the flight recordings; left out: the user's own");
  command->add_option("--cuts", o->cuts,
                      "Keep judged cuts in this file; left out: in your own where the machine is a real one");
  command->add_option("--log-level", o->logLevel, "What the log keeps")
      ->check(CLI::IsMember({"info", "warning", "error", "off"}))
      ->capture_default_str();
  command
      ->add_option("--mode", o->mode, "off: monitor; advise: say what to do; auto: do it, where the profile allows it")
      ->check(CLI::IsMember({"off", "advise", "auto"}))
      ->capture_default_str();
  command->add_option("--seconds", o->seconds, "Stop after so many seconds of samples");
  command->add_option("--give-up", o->giveUp, "End with code 3 after so many seconds without samples; 0: never")
      ->capture_default_str();
  command->add_flag("--status", o->status, "Print a line a second as well");
  command->add_flag("--json", o->json, "Print JSON lines");
  command->callback([o, &exitCode] {
    o->profile = foundFile(o->profile);
    exitCode = run(*o);
  });
}

}  // namespace stillcut::app
