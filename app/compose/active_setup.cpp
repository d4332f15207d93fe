#include "app/compose/active_setup.h"

#include <sstream>
#include <string>
#include <utility>

#include "app/io/alsa_duplex.h"
#include "core/active/active_params.h"
#include "core/active/pcm_duplex.h"
#include "core/config/component_settings.h"

namespace stillcut::app {
namespace {

std::vector<Hertz> linesFrom(config::ComponentSettings& settings) {
  std::vector<Hertz> lines;
  const std::string text = settings.text("quieten_hz", "");
  std::istringstream words(text);
  std::string word;
  while (std::getline(words, word, ',')) {
    char* end = nullptr;
    const double line = std::strtod(word.c_str(), &end);
    while (end != nullptr && *end == ' ') ++end;
    if (end == word.c_str() || *end != '\0' || !(line > 0.0) || lines.size() == kActiveLines) {
      settings.fault("quieten_hz", message("is '%1'", text),
                     message("at most %1 frequencies above 0, for example 339, 1024", std::to_string(kActiveLines)));
      return {};
    }
    lines.emplace_back(line);
  }
  return lines;
}

}  // namespace

active::ActiveEngineOptions activeOptions(const milling::WorkHolderSettings& holder, const config::ParamSet& params) {
  active::ActiveEngineOptions options;
  options.controller = active::fxlmsOptions(params);
  options.path = active::pathRequest(params);
  options.record = active::recordRequest(params);
  options.oldestModel = active::oldestModel(params);
  options.auxiliary = active::auxiliaryShare(params);
  options.lines = holder.quieten;
  for (safety::ActuatorLimits& limits : options.limits) {
    limits.amplitude = holder.stroke.value;
    limits.slew = holder.slew;
  }
  return options;
}

Result<ActiveParts> makeActiveParts(const config::Profile& profile) {
  constexpr double kMicrometre = 1e-6;
  constexpr int kMostChannel = 63;
  config::ComponentSettings settings(profile.active.settings, "active '" + profile.active.id + "'");
  active::PcmDuplexSettings pcm;
  pcm.request.device = settings.text("device", pcm.request.device);
  pcm.request.rate = Hertz(settings.number("rate_hz", pcm.request.rate.value, 1000.0, 192000.0));
  pcm.request.frames = settings.whole("block_frames", pcm.request.frames, 1, 4096);
  pcm.input = {settings.whole("input_x", 0, 0, kMostChannel), settings.whole("input_y", 1, 0, kMostChannel)};
  pcm.output = {settings.whole("output_x", 0, 0, kMostChannel), settings.whole("output_y", 1, 0, kMostChannel)};
  pcm.sensor = {settings.number("sensor_x", 1.0, -1e9, 1e9), settings.number("sensor_y", 1.0, -1e9, 1e9)};
  const double full = kMicrometre * settings.number("full_stroke_um", 3.0, 0.001, 1000.0);
  pcm.stroke = {full, full};
  milling::WorkHolderSettings holder;
  holder.stroke = Metres(kMicrometre * settings.number("stroke_um", 3.0, 0.001, 1000.0));
  holder.slew = settings.number("slew_m_per_s", holder.slew, 1e-6, 100.0);
  holder.quieten = linesFrom(settings);
  if (Status known = settings.finish(); !known) return known.error();
  if (pcm.input[0] == pcm.input[1] || pcm.output[0] == pcm.output[1]) {
    return Error{
        "active '" + profile.active.id + "'", message("x and y are on the same channel"),
        pcm.input[0] == pcm.input[1] ? message("'input_x' and 'input_y'") : message("'output_x' and 'output_y'")};
  }
  if (holder.stroke.value > full) {
    return Error{"active '" + profile.active.id + "'", message("'stroke_um' is more than the output can drive"),
                 message("'full_stroke_um' is less")};
  }
  auto driver = makeAlsaDuplexDriver();
  if (driver == nullptr) return Error{message("active 'alsa'"), message("this program was built without alsa-lib")};
  return ActiveParts{std::make_unique<active::PcmDuplex>(std::move(pcm), std::move(driver)),
                     activeOptions(holder, profile.params)};
}

}  // namespace stillcut::app
