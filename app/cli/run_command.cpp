// stillcut-cli run --profile P.toml [--record FILE.h5] [--flights DIR] [--seconds N] [--log-level L]: the
// monitor without a screen. Prints what happens, one line an event, until the source ends or somebody interrupts; then
// the machine has its programmed values back.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "app/cli/command.h"
#include "app/cli/out_path.h"
#include "app/compose/flight_log.h"
#include "app/compose/interruption.h"
#include "app/compose/left_overrides.h"
#include "app/compose/profile_rig.h"
#include "app/compose/resource_folder.h"
#include "app/io/wires.h"
#include "app/log/run_log.h"
#include "core/pipeline/catalog.h"
#include "core/pipeline/engine.h"
#include "core/rt/deadline_stats.h"
#include "core/rt/realtime_thread.h"
#include "core/rt/wakeup.h"
#include "core/session/session_folder.h"
#include "generated/version.h"

namespace stillcut::app {
namespace {

constexpr Seconds kLook{0.05};

struct RunOptions {
  std::string profile, record, job, flights, operatorName, logLevel = "info";
  double seconds = 0.0;
};

// What a screen would show, as lines.
class Console {
 public:
  Console(Rig& rig, RunLog& log) : rig_(rig), log_(log) {}

  // Prints what has happened since the last look. Gives the length of the run so far.
  Seconds look() {
    const Snapshot* snapshot = rig_.read();
    log_.look(rig_, snapshot);
    if (snapshot == nullptr) return {};
    if (!begun_) {
      const double heard_s = static_cast<double>(snapshot->health.blocks) * snapshot->health.blockLength.value;
      begin_ = snapshot->time - toDuration(Seconds{heard_s});
    }
    begun_ = true;
    const std::uint64_t oldest = snapshot->eventCount > kEventsShown ? snapshot->eventCount - kEventsShown : 0;
    if (oldest > printed_)
      std::printf("%llu lines passed unseen\n", static_cast<unsigned long long>(oldest - printed_));
    for (printed_ = std::max(printed_, oldest); printed_ < snapshot->eventCount; ++printed_) {
      const Event& event = snapshot->events[printed_ % kEventsShown];
      std::printf("%10.3f  %s\n", secondsBetween(begin_, event.time).value, sentence(event.reason).c_str());
    }
    std::fflush(stdout);
    return secondsBetween(begin_, snapshot->time);
  }
  // Says once that nothing is recorded any more: it has to be known while the cut can still be repeated.
  void watchRecording() {
    if (recordingTold_ || rig_.recorder() == nullptr) return;
    const Message stopped = rig_.recorder()->status().fault;
    recordingTold_ = !stopped.empty();
    if (recordingTold_) fail(Error{{}, stopped, message("monitoring goes on")});
  }
  // The same of what a killed run has left in the machine; without a screen there is no button to bring it back.
  void watchLeft() {
    const auto left = rig_.leftInMachine();
    if (!left || std::exchange(leftTold_, true)) return;
    fail(Error{{}, leftSentence(*left)});
  }
  bool recordingTold() const { return recordingTold_; }

 private:
  Rig& rig_;
  RunLog& log_;
  std::uint64_t printed_ = 0;
  bool begun_ = false;
  Instant begin_{};  // of the first block, as a recording counts
  bool recordingTold_ = false, leftTold_ = false;
};

Status checkOptions(const RunOptions& options) {
  if (!(options.seconds >= 0.0 && std::isfinite(options.seconds))) {
    return Error{"--seconds", message("must be a number from 0 up"), message("0: to the end")};
  }
  std::error_code unknown;
  if (std::filesystem::is_directory(options.record, unknown)) return Done{};
  if (!options.record.empty() && !options.record.ends_with(".h5")) {
    return Error{options.record, message("is no name for a session"),
                 message("the suffix must be .h5, or it must be a folder")};
  }
  return checkOutPath(options.record);
}

// How long after a block's last sample everything that it asks for was decided.
void tellLateness(const pipeline::Engine& engine) {
  const rt::DeadlineStats& latency = engine.latency();
  if (latency.count() == 0) return;
  const auto ms = [](Seconds s) { return 1e3 * s.value; };
  std::printf(
      "%llu blocks decided, half within %.2f ms of their last sample, 99.9 %% within %.2f ms, the latest %.2f ms; "
      "%llu dropped\n",
      static_cast<unsigned long long>(latency.count()), ms(latency.quantile(0.5)),
      ms(std::min(latency.quantile(0.999), latency.worst())), ms(latency.worst()),
      static_cast<unsigned long long>(engine.droppedBlocks()));
  if (engine.leasesExpired() > 0)
    std::printf("%llu leases ran out\n", static_cast<unsigned long long>(engine.leasesExpired()));
}

// Until the source ends, the time is over or somebody interrupts.
// replayed: times are the recording's.
int watch(Rig& rig, const RunOptions& options, const ProgramLog& log, bool replayed) {
  FlightLog flights(rig.flights(),
                    options.flights.empty() ? defaultFlightsFolder() : std::filesystem::path(options.flights));
  flights.start();
  // A page that has to come back from the disk would keep the worker waiting.
  if (!rt::lockMemory())
    std::printf("memory is not locked: not permitted (the package's limits allow it to the group stillcut)\n");
  RunLog runLog(log);
  runLog.begin(rig, options.profile);
  rig.start({});
  if (rig.device().live() && rig.engine()->workerScheduling() != rt::Scheduling::Fifo) {
    std::puts("at ordinary priority: real-time priority is for members of the group stillcut");
  }
  Console console(rig, runLog);
  rt::Wakeup never;  // only its time-out is used
  while (!interrupted() && !rig.finished()) {
    never.waitFor(kLook);
    const Seconds length = console.look();
    console.watchRecording();
    console.watchLeft();
    if (options.seconds > 0.0 && length.value >= options.seconds) break;
  }
  const Status recorded = rig.stop();
  console.look();
  runLog.end(rig, recorded);
  if (!replayed) tellLateness(*rig.engine());
  for (const daq::AlignedClock& clock : rig.device().clocks()) {
    std::printf("device of %d more channels: %.3f Hz by this computer's clock, times steady within %.1f us\n",
                clock.channels, clock.rate.value, 1e6 * clock.residual.value);
  }
  if (const Message& doubt = rig.deviceFormat().doubt; !doubt.empty()) std::printf("device: %s\n", text(doubt).c_str());
  if (const Status written = flights.finish(); !written) fail(written.error());
  const Message fault = rig.device().fault();
  if (!fault.empty()) fail(Error{{}, fault});
  if (!recorded && !console.recordingTold()) fail(recorded.error());
  return fault.empty() && recorded ? kExitDone : kExitDevice;
}

// What is asked for here goes before what the profile says.
Status record(Rig& rig, const config::Profile& profile, const RunOptions& options) {
  const auto told = [](const record::Deleted& file) {
    if (file.problem.empty()) {
      std::printf("deleted %s (%s)\n", file.file.c_str(), file.why.c_str());
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
    std::printf("%s is there already: recording to %s\n", options.record.c_str(), path.c_str());
  return recording;
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
  (void)record(**rig, *profile, options).ok();  // the console says what is not recorded
  mindInterruption();
  std::printf("monitoring with %s; authority is off\n", profile->detector.c_str());
  return watch(**rig, options, into, profile->source.id == "replay");
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
  command->add_option("--log-level", o->logLevel, "What the log keeps")
      ->check(CLI::IsMember({"info", "warning", "error", "off"}))
      ->capture_default_str();
  command->add_option("--seconds", o->seconds, "Stop after so many seconds of samples");
  command->callback([o, &exitCode] {
    o->profile = foundFile(o->profile);
    exitCode = run(*o);
  });
}

}  // namespace stillcut::app
