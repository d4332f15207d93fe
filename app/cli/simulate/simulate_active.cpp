#include "app/cli/simulate/simulate_active.h"

#include <cstdio>
#include <fstream>
#include <iomanip>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/json_line.h"
#include "app/compose/active_run.h"
#include "core/base/json_schema.h"
#include "core/formats/sound/wav_reader.h"

namespace stillcut::app {
namespace {

using nlohmann::json;

json toJson(const ActiveResult& result, const milling::Scenario& scenario) {
  json axes = json::array();
  for (const AxisResult& axis : result.axes) {
    json told = {
        {"axis", axis.axis},
        {"released", axis.released == ActuatorRelease::None ? json(nullptr) : json(actuatorReleaseText(axis.released))},
        {"released_at_s", axis.released == ActuatorRelease::None ? json(nullptr) : json(axis.releasedAt)},
        {"stroke_used", axis.strokeUsed},
        {"limited_share", axis.limitedFraction}};
    if (const active::PathReport& path = axis.path.report; !path.frequency.empty()) {
      told["path_residual"] = path.residual;
      told["loop_delay_ms"] = 1e3 * axis.margin.delay.value;
      told["delay_left_ms"] = 1e3 * axis.margin.delayMargin.value;
      told["promises_stable"] = axis.margin.predictedStable;
      told["path_phase_left_deg"] = axis.margin.phaseMargin * 360.0 / kTwoPi;
    }
    axes.push_back(std::move(told));
  }
  json lines = json::array();
  for (const Attenuation& a : result.attenuation) {
    lines.push_back({{"axis", a.axis}, {"frequency_hz", a.frequency}, {"db", a.db}});
  }
  // Speeds and feeds stay as programmed; nothing is detected or commanded on the way to the machine.
  return {{"schema", kJsonSchema},
          {"command", "simulate"},
          {"type", "answer"},
          {"scenario", scenario.name},
          {"strategy", "active"},
          {"outcome", result.chatterControlled ? "chatter" : "stable"},
          {"chatter_alone", result.chatterAlone},
          {"chatter_hz", result.chatterHz},
          {"growth_per_s", result.growth ? json(*result.growth) : json(nullptr)},
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
    if (axis.path.report.frequency.empty()) {
      std::printf("%s: path known at the spindle's line, %.0f %% of the stroke used", axis.axis.c_str(),
                  100.0 * axis.strokeUsed);
    } else {
      std::printf("%s: path known to %.1f %%, %.1f ms late, %.0f of 90 degrees left, %.0f %% of the stroke used",
                  axis.axis.c_str(), 100.0 * axis.path.report.residual, 1e3 * axis.margin.delay.value,
                  axis.margin.phaseMargin * 360.0 / kTwoPi, 100.0 * axis.strokeUsed);
    }
    if (axis.released != ActuatorRelease::None) {
      std::printf(", let go at %.3f s: %s", axis.releasedAt, actuatorReleaseText(axis.released).data());
    }
    std::printf("\n");
  }
  for (const Attenuation& a : result.attenuation) {
    std::printf("%s %7.1f Hz: %+6.1f dB\n", a.axis.c_str(), a.frequency, -a.db);
  }
  std::printf("%s over the last second: %.3f of the cut left alone\n", result.growth ? "vibration" : "dynamic force",
              result.finalRatio);
}

Status keepRecord(const std::string& path, const active::PathRecorder& record, Hertz rate) {
  std::ofstream file(path);
  file << "t,output_x,reading_x,output_y,reading_y\n" << std::setprecision(9);
  // Of a sweep each axis has its own half.
  const std::size_t frames = std::min(record.output(0).size(), record.output(1).size());
  for (std::size_t n = 0; n < frames; ++n) {
    file << static_cast<double>(n) / rate.value;
    for (std::size_t a = 0; a < kActiveAxes; ++a) file << ',' << record.output(a)[n] << ',' << -record.reading(a)[n];
    file << '\n';
  }
  return file.good() ? Status{Done{}} : Status{Error{path, message("cannot be written")}};
}

}  // namespace

int simulateActive(const milling::Scenario& scenario, const config::ParamSet& params, std::uint64_t seed,
                   const ActiveFiles& files, bool asJson) {
  const std::string& out = files.cut;
  ActiveOptions options;
  options.params = params;
  options.seed = seed;
  std::unique_ptr<record::WavWriter> wav;
  Status written{Done{}};
  std::vector<double> scale;
  if (!out.empty()) {
    if (!out.ends_with(".wav"))
      return fail(Error{out, message("cannot be written"), message("an active cut is recorded as .wav")});
    auto made = record::WavWriter::create(out, static_cast<int>(scenario.sensors.size()), scenario.rate);
    if (!made) return fail(made.error());
    wav = std::move(made).value();
    for (const milling::SensorSettings& s : scenario.sensors) scale.push_back(1.0 / s.gain);
    options.observe = [&](const SampleBlock& block, const milling::SimulatedCut&) {
      if (written) written = wav->write(block, scale);
    };
  }
  if (!files.pathRecord.empty()) {
    options.recorded = [&](const active::PathRecorder& record) {
      if (written) written = keepRecord(files.pathRecord, record, scenario.rate);
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
    printJsonLine(toJson(*result, scenario));
  } else {
    print(*result, scenario);
  }
  return kExitDone;
}

}  // namespace stillcut::app
