// RunLog: what of a run goes into the program's log: device and machine at the start, every event, the link when it
// comes and goes, the recording when it stops, the end. Thread: the one that reads the rig's snapshots.
#pragma once

#include <string>

#include "app/compose/rig.h"
#include "app/log/program_log.h"

namespace stillcut::app {

class RunLog {
 public:
  explicit RunLog(const ProgramLog& log) : log_(log) {}

  // `origin`: the file of the scenario or profile.
  void begin(Rig& rig, const std::string& origin);
  // What is new in the newest snapshot; null: none yet.
  void look(Rig& rig, const Snapshot* snapshot);
  // After Rig::stop(), which gave `recorded`.
  void end(Rig& rig, const Status& recorded);

 private:
  void events(const Snapshot& snapshot);
  void link(const MachineState& machine);

  const ProgramLog& log_;
  std::uint64_t written_ = 0;  // events
  bool linkUp_ = false;
  OverrideInhibit inhibit_ = OverrideInhibit::None;
  std::string trouble_;  // of the device, as last written
  bool recorderFault_ = false, leftTold_ = false;
};

}  // namespace stillcut::app
