// stillcut-cli run --profile P.toml [--record FILE.h5] [--seconds N]: the monitor without a screen. Prints what
// happens, one line an event, until the source ends or somebody interrupts; then the machine has its programmed values
// back.

#include <cmath>
#include <csignal>
#include <cstdio>

#include "app/cli/command.h"
#include "app/cli/out_path.h"
#include "app/compose/catalog.h"
#include "app/compose/profile_rig.h"
#include "core/rt/wakeup.h"

namespace stillcut::app {
namespace {

constexpr Seconds kLook{0.05};

volatile std::sig_atomic_t interrupted = 0;
void onSignal(int /*number*/) {
  interrupted = 1;
}

struct RunOptions {
  std::string profile, record;
  double seconds = 0.0;
};

void printEvents(const Snapshot& snapshot, std::uint64_t& printed, Instant begin) {
  const std::uint64_t oldest = snapshot.eventCount > kEventsShown ? snapshot.eventCount - kEventsShown : 0;
  for (printed = std::max(printed, oldest); printed < snapshot.eventCount; ++printed) {
    const Event& event = snapshot.events[printed % kEventsShown];
    std::printf("%10.3f  %s\n", secondsBetween(begin, event.time).value, sentence(event.reason).c_str());
  }
  std::fflush(stdout);
}

Status checkOptions(const RunOptions& options) {
  if (!(options.seconds >= 0.0 && std::isfinite(options.seconds))) {
    return Error{"--seconds", "must be a number from 0 up", "0: to the end"};
  }
  if (!options.record.empty() && !options.record.ends_with(".h5")) {
    return Error{options.record, "is no name for a session", "the suffix must be .h5"};
  }
  return checkOutPath(options.record);
}

int run(const RunOptions& options) {
  if (const Status usable = checkOptions(options); !usable) return fail(usable.error());
  const config::ParamCatalog catalog = fullCatalog();
  const auto profile = config::loadProfile(options.profile, catalog, knownIds());
  if (!profile) return fail(profile.error());
  auto rig = buildProfileRig(*profile, options.profile);
  if (!rig) return fail(rig.error());
  if (!options.record.empty()) {
    const Status recording = (*rig)->recordTo(options.record, config::profileText(*profile, catalog));
    if (!recording) return fail(recording.error());
  }
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
  std::printf("monitoring with %s; authority is off\n", profile->detector.c_str());
  (*rig)->start({});
  rt::Wakeup never;  // only its time-out is used
  std::uint64_t printed = 0;
  std::optional<Instant> begin;
  while (interrupted == 0 && !(*rig)->finished()) {
    never.waitFor(kLook);
    const Snapshot* snapshot = (*rig)->read();
    if (snapshot == nullptr) continue;
    if (!begin) begin = snapshot->time;
    printEvents(*snapshot, printed, *begin);
    if (options.seconds > 0.0 && secondsBetween(*begin, snapshot->time).value >= options.seconds) break;
  }
  (*rig)->stop();
  if (const std::string fault = (*rig)->device().fault(); !fault.empty()) return fail({fault, "", ""}, kExitDevice);
  return kExitDone;
}

}  // namespace

void addRun(CLI::App& app, int& exitCode) {
  auto o = std::make_shared<RunOptions>();
  CLI::App* command = app.add_subcommand("run", "Monitor a machine without a screen");
  command->add_option("--profile", o->profile, "Profile of the machine (.toml)")->required();
  command->add_option("--record", o->record, "Record the session to FILE.h5");
  command->add_option("--seconds", o->seconds, "Stop after so many seconds of samples");
  command->callback([o, &exitCode] { exitCode = run(*o); });
}

}  // namespace stillcut::app
