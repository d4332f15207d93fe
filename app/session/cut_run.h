// CutRun: one run of the desktop and what belongs to it alone: the rig, its recording and flight log, the lobes of its
// cut, its active work-holder. Live on the rig's threads, or advanced block by block for a picture without waiting.
// Another run takes its place as a whole. Thread: GUI.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/compose/flight_log.h"
#include "app/compose/learn/evidence_log.h"
#include "app/compose/rig.h"
#include "app/log/run_log.h"
#include "app/session/active_loop_controller.h"
#include "app/session/deletions.h"
#include "app/session/demo/uncontrolled_cut.h"
#include "app/session/lobe_worker.h"
#include "app/session/lobes/margin_watch.h"
#include "app/session/machine_trial.h"
#include "app/session/session_view.h"
#include "core/config/profile.h"
#include "ui/facade/session_info.h"

namespace stillcut::app {

class CutRun {
 public:
  // `rig` built with spec.watched; `configuration` is what a recording keeps as the text in force.
  CutRun(std::unique_ptr<Rig> rig, ui::SessionInfo info, std::string configuration);
  ~CutRun() { (void)stop().ok(); }
  CutRun(const CutRun&) = delete;
  CutRun& operator=(const CutRun&) = delete;

  // Before start(), one of these. An error: nothing will be recorded; the run may start all the same, and recorder()
  // says why. Everything goes to the session file as well; or to a new one below a folder, as the
  // parameters record.* say; or to either, whichever `fileOrFolder` is; or as `profile`, of the file `path`, says.
  Status recordTo(const std::string& file) { return rig_->recordTo(file, configuration_); }
  Status recordInto(const std::string& folder);
  Status recordAt(const std::string& fileOrFolder);
  Status recordAsSaid(const config::Profile& profile, const std::string& path);
  // The profile file it was made from; its changed parameters are kept there.
  void madeFrom(std::string profile) { profile_ = origin_ = std::move(profile); }
  // The scenario file instead, for the log.
  void simulates(std::string scenario) { origin_ = std::move(scenario); }
  // Opens the same cut once more; not set: it cannot be.
  std::function<Result<std::unique_ptr<CutRun>>()> again;
  // The same cut without Stillcut, to be shown beside it.
  void compareWith(std::unique_ptr<UncontrolledCut> without) { without_ = std::move(without); }
  // Of that one at this moment; not a number: there is none.
  double vibrationWithout(Instant t) const;
  void setLobes(std::unique_ptr<LobeWorker> lobes) { lobes_ = std::move(lobes); }
  // Its judged cuts go into a store, from which the lobes are learned.
  void keepCuts(std::unique_ptr<EvidenceLog> cuts) { cuts_ = std::move(cuts); }
  // Before start(): how much deeper its stable cuts could go is told from their signal. The lobes learn from its cuts.
  void tellMargin();
  std::optional<ui::DepthMargin> margin() const { return margin_ ? margin_->margin() : std::nullopt; }
  void setActive(std::unique_ptr<ActiveLoopController> active) { active_ = std::move(active); }

  // Threads on; flight recordings go to `flights`, what happens into `log`, which outlives the run.
  void start(const std::filesystem::path& flights, const ProgramLog& log);
  // Threads off; the machine has its programmed values back, what was recorded is on the disk. An error: not all of it.
  Status stop();
  // The newest snapshot, or null before the first; valid until the next call.
  const Snapshot* read();
  // Everything that came since the last call, in order.
  void readSignal(const std::function<void(const SampleBlock&)>& sink);
  void send(const OperatorInput& input);

  Rig& rig() { return *rig_; }
  const Rig& rig() const { return *rig_; }
  const ui::SessionInfo& info() const { return info_; }
  // A limit that a screen draws has been given another value, which decides from the next block on.
  void noteTuned(const config::ParamDecl& decl, double value) { takeLimit(info_.limits, decl, value); }
  const std::string& profilePath() const { return profile_; }     // empty: made from none
  const QString& recordingFolder() const { return recordings_; }  // empty: not recorded into one
  LobeWorker* lobes() const { return lobes_.get(); }              // null: the modes of its cut are not known
  ActiveLoopController* active() const { return active_.get(); }  // null: the machine has none
  const Snapshot* live() const { return live_; }                  // as last read
  Seconds linkEffect() const { return effect_; }  // from an order to its effect, as last measured; 0: never
  // What it knows of its real machine now; nothing: it has none.
  std::optional<RunsLink> linkTold() const;
  // A real machine has been given into our authority, as last read or sent.
  bool commandsMachine() const;
  // All of the profile it was made from; of a scenario what a profile can say of it.
  config::Profile asProfile() const;

  ui::RecordingNow recordingNow() { return deletions_.told(rig_->recorder()); }
  ui::RecorderView recorder() const;
  ui::LinkStatus link() const;

 private:
  std::unique_ptr<Rig> rig_;
  ui::SessionInfo info_;
  std::string configuration_, profile_, origin_;
  QString recordings_;
  Deletions deletions_;
  std::unique_ptr<LobeWorker> lobes_;
  std::unique_ptr<MarginWatch> margin_;  // of what the lobes learn; null: nothing
  std::unique_ptr<ActiveLoopController> active_;
  std::unique_ptr<UncontrolledCut> without_;  // null: a real cut, or nobody compares
  std::optional<Instant> began_;              // stream time of the first sample
  const Snapshot* live_ = nullptr;
  Authority authority_ = Authority::Off;
  Seconds effect_{};
  std::unique_ptr<EvidenceLog> cuts_;   // null: the profile does not say what is cut
  std::optional<FlightLog> flightLog_;  // goes before the rig it takes from
  std::optional<RunLog> runLog_;        // while it runs
  bool recordingClosed_ = false;        // with the end of its samples
};

// On a scenario's simulated machine: live (paced to the clock, on threads) or for Rig::advance(). Auto is chosen at the
// start where the scenario grants it.
Result<std::unique_ptr<CutRun>> openScenarioRun(const std::string& path, bool live);
// The same, for whoever wants to see what Stillcut does: chatter is left alone until it has been seen and heard,
// and ends then.
Result<std::unique_ptr<CutRun>> openDemonstrationRun(const std::string& path, bool live);

// Live, on the device and the machine of a profile. Authority starts Off. It is recorded as the profile says, unless it
// is recorded otherwise.
enum class Recorded { AsProfileSays, Otherwise };
// All that can be told of a profile without opening a device or a machine: its file, parts, methods, limits, modes and
// work-holder. What runs meanwhile is not touched.
Status checkProfileRun(const std::string& path);
Result<std::unique_ptr<CutRun>> openProfileRun(const std::string& path, Recorded recorded = Recorded::AsProfileSays);

}  // namespace stillcut::app
