#include "app/compose/recording/recording_profile.h"

#include <utility>

#include "app/compose/known_lobes.h"
#include "app/compose/profile_rig.h"

namespace stillcut::app {

Status addProfile(const config::Profile& profile, const std::string& path, RecordingOptions& options) {
  if (options.teeth == 0) options.teeth = profile.cut.teeth;
  if (options.speed.value <= 0.0 && options.log.empty()) options.speed = profile.cut.nominalSpeed;
  config::Profile cut = profile;  // as it was cut
  cut.cut.teeth = options.teeth;
  if (options.speed.value > 0.0) cut.cut.nominalSpeed = options.speed;
  options.params = profile.params;
  const std::string model = modelFile(profile, path);
  auto known = stableSpeeds(cut, model);
  if (!known) return known.error();
  options.stableSpeeds = std::move(known).value();
  const auto depth = stableDepth(cut, model, cut.cut.nominalSpeed);
  if (!depth) return depth.error();
  options.depthLimit = *depth;
  const auto reach = speedsInReach(cut, path);
  if (!reach) return reach.error();
  options.reach = *reach;
  return Done{};
}

}  // namespace stillcut::app
