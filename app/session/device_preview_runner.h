// DevicePreviewRunner: runs the device that is being set up, without a machine and with nobody in charge, so that
// level, spectrum and rate can be seen before a profile is in force. Thread: GUI; opening the device runs apart.
#pragma once

#include <memory>
#include <string>

#include "app/compose/rig.h"
#include "app/session/background_task.h"
#include "ui/facade/setup_controller.h"

namespace stillcut::app {

class DevicePreviewRunner {
 public:
  ~DevicePreviewRunner() { free(); }

  // Files that the profile names are looked for beside `path`. What was listened to before ends.
  void listen(const config::Profile& profile, const std::string& path);
  // Returns at once: a device that is being opened is let go when it has answered, or has not. opening() has ended
  // then.
  void stop();
  BackgroundTask& opening() { return task_; }
  // The same, and waits: the device is free.
  void free();
  // True: it has been opened, or could not be.
  bool poll();
  ui::DevicePreview heard();

 private:
  ui::DevicePreview::State state_ = ui::DevicePreview::State::Off;
  std::unique_ptr<Rig> rig_;
  ui::SessionInfo info_;
  BackgroundTask task_;
};

// Thread: any, while the device is read.
std::vector<ui::JoinedClock> joinedClocks(const daq::DaqSource& device);

}  // namespace stillcut::app
