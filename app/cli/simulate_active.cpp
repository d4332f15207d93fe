#include "app/cli/simulate_active.h"

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "app/cli/command.h"
#include "app/compose/active_run.h"
#include "core/record/wav_reader.h"

namespace stillcut::app {
namespace {

using nlohmann::json;

json toJson(const ActiveResult& result, const milling::Scenario& scenario) {
  json axes = json::array();
  for (const AxisResult& axis : result.axes) {
    const active::PathReport& path = axis.path.report;
    axes.push_back({{"axis", axis.axis},
                    {"released",
                     axis.released == ActuatorRelease::None ? json(nullptr) : json(actuatorReleaseText(axis.released))},
                    {"released_at_s", axis.released == ActuatorRelease::None ? json(nullptr) : json(axis.releasedAt)},
                    {"stroke_used", axis.strokeUsed},
                    {"limited_share", axis.limitedShare},
                    {"path_residual", path.residual},
                    {"loop_delay_ms", 1e3 * axis.promise.delay.value},
                    {"delay_left_ms", 1e3 * axis.promise.delayLeft.value},
                    {"promises_stable", axis.promise.promisesStable},
                    {"path_phase_left_deg", path.phaseLeft * 360.0 / kTwoPi}});
  }
  json lines = json::array();
  for (const Attenuation& a : result.attenuation) {
    lines.push_back({{"axis", a.axis}, {"frequency_hz", a.frequency}, {"db", a.db}});
  }
  // Speeds and feeds stay as programmed; nothing is detected or commanded on the way to the machine.
  return {{"scenario", scenario.name},
          {"strategy", "active"},
          {"outcome", result.chatterControlled ? "chatter" : "stable"},
          {"chatter_alone", result.chatterAlone},
          {"chatter_hz", result.chatterHz},
          {"alarm_delay_s", nullptr},
          {"command_delay_s", nullptr},
          {"quiet_delay_s", nullptr},
          {"marked_mm", nullptr},
          {"peak_ratio", nullptr},
          {"final_ratio", result.finalRatio},
          {"final_speed_rpm", scenario.programme.speed.value},
          {"final_feed_mm_min", 6e4 * scenario.programmedFeed(scenario.programme.speed).value},
          {"mrr_ratio", 1.0},
          {"speed_changes", 0},
          {"axes", std::move(axes)},
          {"attenuation_db", std::move(lines)}};
}

void print(const ActiveResult& result, const milling::Scenario& scenario) {
  std::printf("%s: %s without control, %s with the active work-holder\n", scenario.name.c_str(),
              result.chatterAlone ? "chatter" : "stable", result.chatterControlled ? "chatter" : "stable");
  for (const AxisResult& axis : result.axes) {
    std::printf("%s: path known to %.1f %%, %.1f ms late, %.0f of 90 degrees left, %.0f %% of the stroke used",
                axis.axis.c_str(), 100.0 * axis.path.report.residual, 1e3 * axis.promise.delay.value,
                axis.path.report.phaseLeft * 360.0 / kTwoPi, 100.0 * axis.strokeUsed);
    if (axis.released != ActuatorRelease::None) {
      std::printf(", let go at %.3f s: %s", axis.releasedAt, actuatorReleaseText(axis.released).data());
    }
    std::printf("\n");
  }
  for (const Attenuation& a : result.attenuation) {
    std::printf("%s %7.1f Hz: %+6.1f dB\n", a.axis.c_str(), a.frequency, -a.db);
  }
  std::printf("vibration over the last second: %.3f of the cut left alone\n", result.finalRatio);
}

}  // namespace

int simulateActive(const milling::Scenario& scenario, const config::ParamSet& params, std::uint64_t seed,
                   const std::string& out, bool asJson) {
  ActiveOptions options;
  options.params = params;
  options.seed = seed;
  std::unique_ptr<record::WavWriter> wav;
  Status written{Done{}};
  std::vector<double> scale;
  if (!out.empty()) {
    if (!out.ends_with(".wav")) return fail(Error{out, "cannot be written", "an active cut is recorded as .wav"});
    auto made = record::WavWriter::create(out, static_cast<int>(scenario.sensors.size()), scenario.rate);
    if (!made) return fail(made.error());
    wav = std::move(made).value();
    for (const milling::SensorSettings& s : scenario.sensors) scale.push_back(1.0 / s.gain);
    options.observe = [&](const SampleBlock& block, const milling::SimulatedCut&) {
      if (written) written = wav->write(block, scale);
    };
  }
  const auto result = runActive(scenario, options);
  if (wav && written) written = wav->finish();
  if (!result || !written) {
    wav.reset();
    if (!out.empty()) std::remove(out.c_str());
    return fail(result ? written.error() : result.error());
  }
  if (asJson) {
    std::printf("%s\n", toJson(*result, scenario).dump(2).c_str());
  } else {
    print(*result, scenario);
  }
  return kExitDone;
}

}  // namespace stillcut::app
