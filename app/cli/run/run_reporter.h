// RunReporter: how `stillcut-cli run` says what happens: in lines for people or as JSON lines for programs.
// Thread: the one that looks at the run.
#pragma once

#include <memory>
#include <string>

#include "app/cli/run/run_times.h"
#include "app/compose/rig.h"
#include "core/config/profile.h"

namespace stillcut::app {

struct RunBegin {
  const config::Profile& profile;
  std::string profilePath;
  Authority mode = Authority::Off;
};

struct RunLook {
  const Snapshot& now;
  const RunTimes& times;
};

struct RunEnd {
  int exitCode = 0;
  std::string why;
};

class RunReporter {
 public:
  virtual ~RunReporter() = default;
  virtual void start(const RunBegin& begin) = 0;
  // The state or the advice has changed; or a second has gone by.
  virtual void change(const RunLook& look) = 0;
  virtual void status(const RunLook& look) = 0;
  // Of the newest kInterventionsShown the card that the event closes; null: it closes none.
  virtual void event(const RunLook& look, const Event& event, const Intervention* closed) = 0;
  virtual void note(const std::string& sentence) = 0;
  virtual void stopped(Seconds silent, const std::string& why) = 0;
  virtual void resumed(Seconds silent) = 0;
  // `last`: null where no sample ever came.
  virtual void end(const RunEnd& end, const RunLook* last) = 0;
};

// `rig` outlives them.
std::unique_ptr<RunReporter> makeTextReporter(Rig& rig);
std::unique_ptr<RunReporter> makeJsonReporter(Rig& rig);

// "go to 9010 rev/min"; empty: nothing is advised.
std::string adviceWords(const SpeedAdvice& advice);
// "air", "stable", "onset", "chatter", "not-judged".
std::string_view shownState(const Verdict& verdict);
// Of the detector in charge.
const Verdict& inCharge(const Snapshot& snapshot);

}  // namespace stillcut::app
