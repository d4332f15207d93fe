#include "app/compose/recording/recording_answer.h"

#include <algorithm>
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

Result<RecordingAnswer> answerRecording(const std::string& path, const RecordingOptions& options,
                                        const std::function<bool(double)>& goOn) {
  auto built = buildRecordingRig(path, options);
  if (!built) return built.error();
  Rig& rig = *built->rig;
  evaluate::RecordingJudge judge(rig.chain(), built->judged);
  const auto frames = std::max(1.0, static_cast<double>(built->format.frames));
  double done = 0.0;
  bool more = true;
  while (more) {
    more = rig.advance([&](const StepInput& input, const StepOutput& output) {
      judge.observe(input, output);
      done += input.block.frames;
    });
    if (goOn && !goOn(std::min(1.0, done / frames))) return Error{path, message("stopped")};
  }
  if (const Message fault = rig.device().fault(); !fault.empty()) return Error{path, fault};
  return judge.answer(0);
}

}  // namespace stillcut::app
