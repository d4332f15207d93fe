#include "app/session/device_preview_runner.h"

#include <utility>

#include "app/compose/profile_rig.h"
#include "app/session/session_view.h"
#include "core/pipeline/catalog.h"
#include "ui/base/say.h"

namespace stillcut::app {

void DevicePreviewRunner::listen(const config::Profile& profile, const std::string& path) {
  stop();
  state_ = ui::DevicePreview::State::Opening;
  config::Profile alone = profile;
  alone.link = {};
  alone.strategy = "monitor";
  alone.allowAuto = false;
  task_.start(ui::TaskState::What::None, {},
              [this, alone, path](BackgroundTask::Progress&) -> Result<BackgroundTask::Apply> {
                const config::ParamCatalog catalog = pipeline::fullCatalog();
                const auto sound = config::parseProfile(config::profileText(alone, catalog), path, catalog, knownIds());
                if (!sound) return sound.error();
                auto built = buildProfileRig(*sound, path);
                if (!built) return built.error();
                auto rig = std::make_shared<std::unique_ptr<Rig>>(std::move(built).value());
                return BackgroundTask::Apply([this, rig] {
                  rig_ = std::move(*rig);
                  info_ = sessionInfo(*rig_);
                  rig_->start({});
                });
              });
}

void DevicePreviewRunner::stop() {
  task_.leave();
  rig_.reset();
  state_ = ui::DevicePreview::State::Off;
}

void DevicePreviewRunner::free() {
  stop();
  task_.cancel();
}

bool DevicePreviewRunner::poll() {
  if (!task_.collect()) return false;
  state_ = rig_ ? ui::DevicePreview::State::Running : ui::DevicePreview::State::Failed;
  return true;
}

ui::DevicePreview DevicePreviewRunner::heard() {
  ui::DevicePreview heard;
  heard.state = state_;
  if (state_ == ui::DevicePreview::State::Failed) heard.problem = task_.state().problem;
  if (!rig_) return heard;
  heard.info = &info_;
  heard.snapshot = rig_->read();
  heard.clocks = joinedClocks(rig_->device());
  heard.problem = ui::sayCore(rig_->device().trouble());
  if (rig_->finished()) heard.problem = ui::sayCore(rig_->device().fault());
  return heard;
}

std::vector<ui::JoinedClock> joinedClocks(const daq::DaqSource& device) {
  std::vector<ui::JoinedClock> clocks;
  for (const daq::AlignedClock& clock : device.clocks()) clocks.push_back({clock.channels, clock.rate, clock.residual});
  return clocks;
}

}  // namespace stillcut::app
