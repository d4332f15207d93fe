// RunWatch: follows a run from its start to its end and tells a reporter what happens. Whatever ends it, the machine
// has its programmed values back afterwards, also where a console holds up what is said.
// Thread: main.
#pragma once

#include <string>

#include "app/cli/run/run_reporter.h"
#include "app/cli/run/sample_watch.h"
#include "app/cli/run/service_notice.h"
#include "app/compose/learn/evidence_log.h"
#include "app/log/run_log.h"

namespace stillcut::app {

struct RunWatchOptions {
  Authority mode = Authority::Off;  // asked for once the machine has been read
  bool status = false;              // a line a second as well
  Seconds length{};                 // of samples, then it ends; 0: as long as they come
  Seconds giveUp{};                 // without samples; 0: never
  std::string flights{};            // folder; empty: the user's own
  EvidenceLog* cuts = nullptr;      // keeps what was judged; null: nothing does
};

class RunWatch {
 public:
  RunWatch(Rig& rig, const RunWatchOptions& options, const ProgramLog& log, RunReporter& reporter);

  // Gives the exit code.
  int run(const RunBegin& begin);

 private:
  void look();
  void tellEvents(const Snapshot& snapshot);
  void tellState(const Snapshot& snapshot);
  void tellSilence(const Snapshot* snapshot);
  void watchRecording();
  void watchLeft();
  void askMode(const Snapshot& snapshot);
  void keepCuts();
  // Empty: it goes on.
  RunEnd ending() const;
  int finish(RunEnd end);

  Rig& rig_;
  RunWatchOptions options_;
  RunReporter& reporter_;
  RunLog log_;
  RunTimes times_;
  SteadyClock clock_;
  SampleWatch samples_;
  ServiceNotice service_;
  const Snapshot* snapshot_ = nullptr;
  Instant nextStatus_{};
  std::uint64_t events_ = 0;  // reported
  struct Shown {
    std::string_view state;
    ReasonCode reason = ReasonCode::None;
    ChatterKind kind = ChatterKind::Unknown;
    double frequency_Hz = 0.0;
    Authority mode = Authority::Off;
    SpeedAdvice::Kind advice = SpeedAdvice::Kind::None;
    double advised_rpm = 0.0;
  } shown_;
  bool modeAsked_ = false, recordingTold_ = false, leftTold_ = false;
};

}  // namespace stillcut::app
