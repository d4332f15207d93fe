// SetupController: what the Set up page needs: the parts a machine can be made of and their settings, profiles, the
// tools of the shop, trials of what was chosen, and putting a profile in force. app/session implements it; what takes
// time runs on a thread of its own and is taken over by poll(). GUI thread; every function returns at once.
#pragma once

#include <QString>
#include <QStringList>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/config/component_settings.h"
#include "core/config/profile.h"
#include "ui/facade/session_info.h"
#include "ui/facade/tool_entry.h"

namespace stillcut::ui {

struct ComponentOption {
  QString id, description;  // description in English; shown by sayCore()
};

// One step of a trial, in order; a later one is only tried when the ones before went well.
struct TrialStep {
  enum class State { Waits, Runs, Good, Bad };
  enum class What { Settings, Device, Samples, Link, Machine };
  What what = What::Settings;
  State state = State::Waits;
  QString detail;  // what was found, or what is wrong; in the language of the screen
};

// A device beside the first of several joined ones, by this computer's clock.
struct JoinedClock {
  int channels = 0;
  Hertz rate{};
  Seconds residual{};  // rms of what its stamps are off from a straight line: what "at the same time" means
};

// What a calibrator's tone, or knocks along an axis, say of the channels of the chosen device.
struct SensorTrial {
  enum class State { Off, Runs, Good, Bad };
  State state = State::Off;
  QString said;  // what was heard, or why nothing comes of it; in the language of the screen
  std::vector<std::pair<int, ChannelInfo>> found;  // Good: the channels that are not right as they are, set right
};

// What the chosen device delivers before any profile is in force.
struct DevicePreview {
  enum class State { Off, Opening, Running, Failed };
  State state = State::Off;
  const SessionInfo* info = nullptr;  // both null until samples come; valid until the next call
  const Snapshot* snapshot = nullptr;
  QString problem;                    // why it could not be opened, or why it has ended
  std::vector<JoinedClock> clocks{};  // Off: of what runs
};

// What is recorded of the present cut.
struct RecordingNow {
  QString path;  // the file, or the one before; empty: nothing is recorded
  enum class State { Off, Waits, Writes, Stopped };
  State state = State::Off;  // Waits: for an event
  int deleted = 0;           // older files that had to go
  QString lastDeleted;
  QStringList notDeleted{};  // "FILE (why)": should have gone by the same limits and are still there
};

// Ways to a machine, looked for when somebody asks and never before.
struct MachineSearch {
  struct Place {
    QString where, what;           // "mill:5007"; in English
    config::ComponentChoice link;  // what a profile would say of it; no id: it is no machine
  };
  bool runs = false, done = false;
  std::vector<Place> places;
  QString problem;  // why nothing was looked for; in the language of the screen
};

// A device that is plugged in here, ready to be chosen.
struct FoundDevice {
  QString label, range;            // as its maker calls it; "1 channel, 48000 Hz", in English
  config::ComponentChoice source;  // what a profile would say of it
  ChannelInfo channel;             // of its first input, as far as the kind of device tells
};

// The chosen link by itself, step by step as they are taken.
struct LinkTest {
  enum class State { Off, Runs, Good, Bad };
  struct Step {
    QString what;  // in English; shown by sayCore()
    QString said;  // in the language of the screen
    bool good = false;
  };
  State state = State::Off;
  std::vector<Step> steps;
};

class SetupController {
 public:
  virtual ~SetupController() = default;

  // Takes over what has been finished. True: something has changed. Every display tick.
  virtual bool poll() = 0;

  virtual std::vector<ComponentOption> sources() const = 0;
  virtual std::vector<ComponentOption> links() const = 0;
  virtual std::vector<ComponentOption> detectors() const = 0;
  virtual std::vector<ComponentOption> strategies() const = 0;
  // The settings that the chosen part asks for, given those it has already.
  virtual std::vector<config::SettingDecl> sourceSettings(const config::Profile& profile) const = 0;
  virtual std::vector<config::SettingDecl> linkSettings(const config::Profile& profile) const = 0;

  // How recordings are made, as declared; and where they go when nobody says otherwise.
  virtual config::ParamTable recordParams() const = 0;
  virtual QString usualRecordings() const = 0;
  virtual RecordingNow recordingNow() const = 0;

  // Files in the user's folder, by name, and the profile in force.
  virtual QStringList profiles() const = 0;
  // Examples that come with the program, for one of the kits each.
  virtual QStringList shippedProfiles() const = 0;
  virtual Result<config::Profile> loadShipped(const QString& name) const = 0;
  virtual QString profileInForce() const = 0;  // empty: a scenario, none
  virtual Result<config::Profile> load(const QString& name) const = 0;
  // Gives the file.
  virtual Result<QString> save(const config::Profile& profile, const QString& name) = 0;
  virtual config::Profile draft() const = 0;  // to begin with: of the run, as far as it is known
  // What is being put together outlives page and program until it is put in force. None: nothing was begun, or it
  // cannot be read any more.
  virtual void keepDraft(const config::Profile& profile) = 0;
  virtual std::optional<config::Profile> keptDraft() const = 0;

  // Looks at what is plugged in; what was found shows in devicesHere() some polls later. Nothing is opened for long.
  virtual void lookForDevices() = 0;
  virtual const std::vector<FoundDevice>& devicesHere() const = 0;

  // Runs the device of `profile` by itself: no machine, nobody in charge. The device of the present cut may refuse to
  // be opened twice.
  virtual void listen(const config::Profile& profile, const QString& name) = 0;
  virtual void stopPreview() = 0;
  virtual DevicePreview heard() = 0;

  // Hears the calibrator on `channel` for some seconds; whoever listens to the device stops. `level`: "94 dB", "1 g".
  virtual void calibrate(const config::Profile& profile, const QString& name, int channel, const QString& level,
                         Hertz frequency) = 0;
  // Hears knocks along the axis of `channel` for some seconds: is it this sensor that lies along it? The forces of a
  // cut turn with the tool and cannot tell.
  virtual void knock(const config::Profile& profile, const QString& name, int channel) = 0;
  virtual const SensorTrial& sensorTrial() const = 0;  // of whichever was asked last

  // Serial ports, this computer, and what was typed: hosts and subnets.
  virtual void findMachines(const QString& typed) = 0;
  virtual void stopFinding() = 0;  // what was found so far stays
  virtual const MachineSearch& search() const = 0;
  // Only reads; what it measures is saved with the profile.
  virtual void testLink(const config::Profile& profile, const QString& name) = 0;
  virtual void stopTest() = 0;  // after the step that is being taken
  virtual const LinkTest& linkTest() const = 0;

  virtual void tryOut(const config::Profile& profile, const QString& name) = 0;
  virtual const std::vector<TrialStep>& trial() const = 0;

  // Saves the profile under that name and begins with it, in the place of the present cut, whose machine gets its
  // programmed values back. An error leaves no cut running where the new one could not begin, and says so; nothing has
  // been saved then.
  virtual Status start(const config::Profile& profile, const QString& name) = 0;
  virtual Status startDemonstration() = 0;

  virtual Result<std::vector<ToolEntry>> tools() const = 0;
  // Whether a file holds what a tool wants of it: modes, as a tap test or `modal` writes them or in a whole cut, or a
  // frequency response. One line where it does not.
  enum class ToolFile { Modes, Response };
  // What a profile takes of a tool whose modes are known: its file where that is a whole cut; of modes alone one that
  // is written, at the tool's full width in its material.
  virtual Result<QString> cutFile(const ToolEntry& tool) = 0;
  virtual Status checkToolFile(const QString& file, ToolFile kind) const = 0;
  virtual Status saveTools(const std::vector<ToolEntry>& tools) = 0;
};

}  // namespace stillcut::ui
