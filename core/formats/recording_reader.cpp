#include "core/formats/recording_reader.h"

#include <cmath>
#include <utility>

#include "core/units/unit_names.h"

namespace stillcut::record {

void leaveOut(RecordingFormat& format, std::string name, Message why) {
  format.skippedWhy.resize(format.skipped.size());
  format.skipped.push_back(std::move(name));
  format.skippedWhy.push_back(std::move(why));
}

Result<std::vector<RecordedChannel>> keepChannels(const std::vector<RecordedChannel>& all,
                                                  const std::vector<int>& wanted, const std::string& where) {
  if (wanted.empty()) return all;
  std::vector<RecordedChannel> kept;
  for (const int index : wanted) {
    if (index < 0 || index >= static_cast<int>(all.size())) {
      return Error{where, message("there is no channel %1", std::to_string(index)),
                   message("it has %1, counted from 0", std::to_string(all.size()))};
    }
    kept.push_back(all[static_cast<std::size_t>(index)]);
  }
  return kept;
}

Status applyOptions(std::vector<RecordedChannel>& channels, const ReadOptions& options) {
  if (options.scale && (!std::isfinite(*options.scale) || *options.scale == 0.0)) {
    return Error{"--scale", message("must be a number other than zero")};
  }
  for (RecordedChannel& channel : channels) {
    if (options.quantity) {
      const std::optional<UnitMeaning> unit = unitFromText(channel.unit);
      const bool unitFits = unit && unit->quantity == options.quantity;
      if (!unitFits) channel.info.scale = 1.0;
      channel.info.quantity = *options.quantity;
      channel.quantityKnown = true;
    }
    if (options.scale) channel.info.scale = *options.scale;
  }
  return Done{};
}

}  // namespace stillcut::record
