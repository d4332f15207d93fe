// A source on the wires and libraries of this computer.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "app/io/alsa_driver.h"
#include "app/io/wires.h"
#include "core/daq/registry.h"

namespace stillcut::daq {

inline SourceRequest requestOn(const Clock& clock, std::map<std::string, std::string> settings) {
  SourceRequest request;
  request.channels.resize(1);
  request.wires = app::makeWire;
  request.pcm = app::makeAlsaDriver;
  request.clock = &clock;
  request.settings = std::move(settings);
  return request;
}

}  // namespace stillcut::daq
