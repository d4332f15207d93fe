// The link to a machine of this table, as a run has it. Thread: one.
#pragma once

#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

#include "app/io/kept_link.h"
#include "app/io/wires.h"

namespace stillcut::ends {

inline std::unique_ptr<cnc::CncLink> keptLink(std::string_view id, const std::map<std::string, std::string>& settings,
                                              const std::string& folder) {
  static const SteadyClock kClock;
  cnc::LinkRequest request;
  request.settings = settings;
  request.folder = folder;
  request.wires = app::makeWire;
  request.buses = app::busMaker();
  request.clock = &kClock;
  auto link = app::makeKeptLink(id, request, app::AnalogOutputs::Written, folder);
  if (!link) throw std::runtime_error(link.error().line());
  return std::move(link).value();
}

}  // namespace stillcut::ends
