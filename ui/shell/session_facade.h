// What the screens need of a running session. app/session implements it; the screens never touch a device.
// Every function is called on the GUI thread and returns at once.
#pragma once

#include <QString>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>

#include "core/model/operator_input.h"
#include "core/model/sample_block.h"
#include "core/model/snapshot.h"
#include "ui/facade/active_controller.h"
#include "ui/facade/file_controller.h"
#include "ui/facade/learned_lobes.h"
#include "ui/facade/lobe_entry.h"
#include "ui/facade/lobe_service.h"
#include "ui/facade/session_controller.h"
#include "ui/facade/session_info.h"
#include "ui/facade/setup_controller.h"
#include "ui/facade/tap_controller.h"
#include "ui/models/tune/tuning.h"

namespace stillcut::ui {

class SessionFacade {
 public:
  virtual ~SessionFacade() = default;

  // Of what the pages show: the cut, or a replay in its place. Constant while generation() is.
  virtual const SessionInfo& info() const = 0;
  // Counts what has been opened: another number means another cut, replay or machine, with another info(), whose
  // pictures have nothing to do with those before.
  virtual std::uint32_t generation() const { return 0; }
  // The newest snapshot of what the pages show, or null before the first. Immutable and valid until the next pull().
  virtual const Snapshot* pull() = 0;
  // While a replay is shown, the machine's own cut as of the last pull(): what commands shows it and acts on it.
  virtual bool replayShown() const { return false; }
  // It is paused, or at its end: nothing new comes until somebody plays it.
  virtual bool replayStands() const { return false; }
  virtual const SessionInfo& liveInfo() const { return info(); }
  virtual const Snapshot* live() { return pull(); }
  // The samples that came since the last call, in device units (info().setup.channels has the scales), in order. A
  // screen that is late loses some, which their stamps tell.
  virtual void readSignal(const std::function<void(const SampleBlock&)>& sink) { static_cast<void>(sink); }
  // Which channel the spectrogram of the snapshots is of, from the next block on.
  virtual void showChannel(int channel) { static_cast<void>(channel); }
  // Queued to the worker, acts at its next block; what came of it shows in the snapshot. BackToProgrammed lets the
  // active work-holder go as well. `seen`: the generation() that was on the screen when it was touched. Advice and
  // alarms are answered only of the machine's cut, and only of the one that was seen; anything else is let fall.
  virtual void send(const OperatorInput& input, std::uint32_t seen) = 0;
  virtual RecorderView recorder() const = 0;
  virtual LinkStatus link() const = 0;
  // Of what the pages show. Null: the modes of that cut are not known.
  virtual LobeService* lobes() { return nullptr; }
  // A cut entered by hand on the page of the lobes; null: none can be. As long-lived as the session.
  virtual LobeEntryController* lobeEntry() { return nullptr; }
  // Of a simulated cut: the vibration it would have at this time without Stillcut (Picture::vibrationWithout).
  virtual double vibrationWithout(Instant /*t*/) { return std::numeric_limits<double>::quiet_NaN(); }
  // Of the stable cut that runs (Picture::margin).
  virtual std::optional<DepthMargin> depthMargin() const { return std::nullopt; }
  // The cut of liveInfo() can be run once more when it is over; runAgain() does it.
  virtual bool mayRunAgain() const { return false; }
  virtual Status runAgain() { return Done{}; }
  // What the Tune page works on; null: nothing. As long-lived as the session.
  virtual Tuning* tuning() { return nullptr; }
  // Recordings and their replay; null: there are none here. As long-lived as the session.
  virtual SessionController* sessions() { return nullptr; }
  // One recording as a whole and its answer; null: none can be opened here. As long-lived as the session.
  virtual FileController* files() { return nullptr; }
  // Parts, profiles and tools; null: nothing can be set up here. As long-lived as the session.
  virtual SetupController* setup() { return nullptr; }
  // The tap test; null: nothing can be measured here. As long-lived as the session.
  virtual TapController* tap() { return nullptr; }
  // The active work-holder; null: the machine has none. Another one with another generation().
  virtual ActiveController* active() { return nullptr; }
  // Where window and pages keep what outlives a restart; empty: nothing is kept.
  virtual QString stateFolder() const { return {}; }
};

}  // namespace stillcut::ui
