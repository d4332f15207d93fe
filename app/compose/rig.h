// Rig: one run, wired. The only place where rooms meet: source, chain, gate, link, screen and recorder of a simulated
// machine, a recording, or a profile's real hardware are put together here and nowhere else.
// Thread: construction and destruction on one set-up thread. Live: start() and stop(). Deterministic: runToEnd().
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/cnc/override_memory.h"
#include "core/config/param_set.h"
#include "core/pipeline/engine.h"
#include "core/pipeline/serial_run.h"
#include "core/rt/boot_clock.h"
#include "core/session/recorder.h"
#include "core/session/session_folder.h"

namespace stillcut::app {

// Which methods run and who is in charge.
struct Methods {
  std::vector<std::string> detectors{"energy-ratio"};  // all that run; the first is in charge
  std::string fallback;                                // one of them, takes over when the first fails; empty: none
  std::string strategy = "stable-pocket";
};

struct RigSpec {
  std::shared_ptr<const Clock> clock;                  // kept for the lives of device and link; may be empty
  std::unique_ptr<daq::DaqSource> device;              // what the steps come from
  std::unique_ptr<pipeline::StepSource> steps;         // empty: `device`, live
  std::unique_ptr<pipeline::MachineStateSource> feed;  // empty: the link's mailbox and the operator's ring
  std::unique_ptr<cnc::CncLink> link;                  // empty: no machine
  std::shared_ptr<cnc::SentOverridesCell> left;        // what a killed run has left in it; empty: nothing can be
  Seconds linkEffect{};                                // from an order to its effect, as measured before; 0: never
  CutSetup setup;  // rate, channels and block size are overwritten by the source's format
  config::ParamSet params;
  bool autoAllowed = false;  // Auto may be chosen at all
  std::string operatorName;  // signs what is touched during the cut; empty: "operator"
  std::string job;           // what is being made, for recordings; empty: not given
  Methods methods;
  bool watched = false;        // a screen reads snapshots
  bool deterministic = false;  // advance() and runToEnd() instead of start()
};

// What kept a rig from being built.
enum class SetUpFault {
  Input,     // settings, methods, or parts that may not be wired together
  Hardware,  // device or machine cannot be opened
};

class Rig {
 public:
  // Opens source and link and prepares every part. One line on failure, and its kind in `fault` where given; nothing is
  // left open. A source that is not live is refused a machine that is not simulated.
  static Result<std::unique_ptr<Rig>> build(RigSpec spec, SetUpFault* fault = nullptr);
  ~Rig();

  const CutSetup& setup() const { return spec_.setup; }
  const config::ParamSet& params() const { return spec_.params; }
  const pipeline::Chain& chain() const { return *chain_; }
  // Any thread: overrides were released and the machine has not shown it yet; also after the samples have ended.
  bool releaseNotYetBack() const { return linkRunner_ != nullptr && linkRunner_->tally().notYetBack; }
  // Taken by one thread, not the worker.
  safety::FlightRecorder& flights() { return chain_->flights(); }
  const daq::DaqSource& device() const { return *spec_.device; }
  const daq::SourceFormat& deviceFormat() const { return format_; }
  cnc::LinkInfo linkInfo() const;
  bool hasLink() const { return spec_.link != nullptr; }
  // Any thread: what a run that was killed has left in the machine, and the operator's BACK TO 100 % brings back.
  std::optional<cnc::SentOverrides> leftInMachine() const { return spec_.left ? spec_.left->get() : std::nullopt; }

  // Before the first step: everything goes to the session file `path` as well, with the whole wiring of this run (see
  // run_text.h). `origin`: the scenario or profile it was made from, as text, kept for the reader.
  // An error, here and below: nothing will be recorded. The run may begin all the same; recorder() says then that it
  // has stopped, and why.
  Status recordTo(const std::string& path, const std::string& origin, const record::RecorderOptions& options = {});
  // The same under the first free name of "cut.h5", "cut-2.h5" ...: nothing that was recorded is replaced.
  Status recordToNew(const std::string& wanted, const std::string& origin);
  // The same below `folder`, in files named by job, tool and time, as the parameters record.* say; what they let go is
  // deleted first, and reported (on the thread that records, once it runs).
  Status recordInto(const std::string& folder, const std::string& origin,
                    std::function<void(const record::Deleted&)> told);
  // Null: nothing is recorded.
  record::Recorder* recorder() { return recorder_.get(); }

  // Live, threaded.
  void start(const pipeline::EngineOptions& options);
  // Threads off, the machine released, the recording closed. An error: the recording stopped before the run did.
  Status stop();
  // Once finished(): the recording is closed and whole, while link and screen go on.
  Status closeRecording() { return recorder_ && finished() ? recorder_->finish() : Status(Done{}); }
  bool finished() const { return engine_ && engine_->finished(); }
  // Its latencies and losses; null before start().
  const pipeline::Engine* engine() const { return engine_.get(); }
  // One thread only (the screen's).
  const Snapshot* read() { return publisher_.read(); }
  pipeline::SignalTap& signal() { return publisher_.signal(); }
  // Which channel the snapshots' spectrogram is of.
  void showChannel(int channel) { publisher_.showChannel(channel); }
  bool send(const OperatorInput& input);

  // Deterministic, in the caller's thread: one block. False: the source has ended.
  using After = std::function<void(const StepInput&, const StepOutput&)>;
  bool advance(const After& after = {});
  // Any thread: lets an advance() that waits for its block come back soon, with false.
  void interrupt() { spec_.steps->stop(); }
  // To the end; the machine is released.
  void runToEnd(const After& after);

 private:
  explicit Rig(RigSpec spec);
  Status prepare(SetUpFault& fault);
  Status open();
  void makeLoop();
  pipeline::EngineOptions liveOptions(pipeline::EngineOptions options) const;
  record::SessionHeader sessionHeader(const std::string& origin) const;
  void tapInto(std::unique_ptr<record::Recorder> recorder);
  Status tapIntoMade(const std::string& path, Result<std::unique_ptr<record::Recorder>> made);

  RigSpec spec_;
  daq::SourceFormat format_;
  rt::Mailbox<OverrideCommand> commands_;
  rt::Mailbox<MachineState> states_;
  rt::SpscRing<OperatorInput> inputs_{32};
  SteadyClock steadyClock_;
  rt::BootClock bootClock_;
  ManualClock manualClock_;
  std::unique_ptr<pipeline::Chain> chain_;
  pipeline::SnapshotPublisher publisher_;
  std::unique_ptr<record::Recorder> recorder_;
  std::unique_ptr<pipeline::StepTap> tap_;
  std::unique_ptr<pipeline::StepLoop> loop_;
  std::unique_ptr<pipeline::LinkRunner> linkRunner_;
  std::unique_ptr<pipeline::Engine> engine_;
  std::unique_ptr<pipeline::SerialRun> serial_;
};

}  // namespace stillcut::app
