// A device of two accelerometers under the whole pipeline; heardDevice(): what a null sink of PulseAudio plays.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>

#include "app/compose/rig.h"
#include "app/io/alsa_driver.h"
#include "app/io/iio_driver.h"
#include "app/io/wires.h"
#include "core/base/time.h"
#include "core/daq/registry.h"
#include "core/pipeline/catalog.h"

namespace stillcut::app {

inline Result<std::unique_ptr<daq::DaqSource>> deviceOf(const std::string& source,
                                                        std::map<std::string, std::string> settings,
                                                        const Clock& clock) {
  daq::SourceRequest request;
  request.settings = std::move(settings);
  request.channels = {{.name = "x", .scale = 100.0, .axis = "x"}, {.name = "y", .scale = 100.0, .axis = "y"}};
  request.pcm = makeAlsaDriver;
  request.iio = makeIioDriver;
  request.wires = makeWire;
  request.clock = &clock;
  return daq::makeSource(source, request);
}

inline Result<std::unique_ptr<daq::DaqSource>> heardDevice(int rate, const Clock& clock) {
  return deviceOf("alsa", {{"device", "heard"}, {"rate_hz", std::to_string(rate)}}, clock);
}

inline Result<std::unique_ptr<Rig>> rigOn(std::unique_ptr<daq::DaqSource> device, std::shared_ptr<const Clock> clock) {
  RigSpec spec;
  spec.clock = std::move(clock);
  spec.device = std::move(device);
  spec.setup.teeth = 4;
  spec.setup.nominalSpeed = Rpm(8500.0);
  spec.watched = true;
  return Rig::build(std::move(spec));
}

}  // namespace stillcut::app
