#include "core/formats/channel_notes.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/formats/variable_channels.h"

namespace stillcut::record {
namespace {

constexpr const char* kKey = "stillcut_channels";

std::string textIn(const nlohmann::json& object, const char* key) {
  const auto it = object.find(key);
  return it != object.end() && it->is_string() ? cleanName(it->get<std::string>()) : "";
}

double numberIn(const nlohmann::json& object, const char* key) {
  const auto it = object.find(key);
  return it != object.end() && it->is_number() ? it->get<double>() : 0.0;
}

}  // namespace

std::string channelNotes(const ExportPlan& plan, const std::vector<double>& fullScale) {
  nlohmann::ordered_json notes;
  notes["rate_hz"] = plan.rate.value;
  for (std::size_t c = 0; c < plan.channels.size(); ++c) {
    const RecordedChannel& channel = plan.channels[c];
    nlohmann::ordered_json one{{"name", channel.info.name}, {"full_scale", fullScale[c]}};
    if (channel.quantityKnown) one["quantity"] = name(channel.info.quantity);
    if (const std::string unit = exportUnit(channel); !unit.empty()) one["unit"] = unit;
    if (!channel.info.axis.empty()) one["axis"] = channel.info.axis;
    if (channel.info.sensitivity > 0.0) one["sensitivity_mv"] = channel.info.sensitivity;
    if (channel.info.volts > 0.0) one["volts"] = channel.info.volts;
    if (!channel.info.coupling.empty()) one["coupling"] = channel.info.coupling;
    if (!channel.info.place.empty()) one["place"] = channel.info.place;
    notes[kKey].push_back(std::move(one));
  }
  return notes.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void applyChannelNotes(std::string_view comment, std::vector<RecordedChannel>& channels, Hertz& rate) {
  const nlohmann::json notes = nlohmann::json::parse(comment, nullptr, false);
  if (!notes.is_object() || !notes.contains(kKey)) return;
  const nlohmann::json& all = notes[kKey];
  if (!all.is_array() || all.size() != channels.size()) return;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    if (!all[c].is_object()) return;
    RecordedChannel& channel = channels[c];
    if (const std::string name = textIn(all[c], "name"); !name.empty()) channel.info.name = name;
    channel.unit = textIn(all[c], "unit");
    channel.info.axis = textIn(all[c], "axis");
    channel.info.sensitivity = numberIn(all[c], "sensitivity_mv");
    channel.info.volts = numberIn(all[c], "volts");
    channel.info.coupling = textIn(all[c], "coupling");
    channel.info.place = textIn(all[c], "place");
    if (const auto quantity = sensorQuantityFromName(textIn(all[c], "quantity"))) {
      channel.info.quantity = *quantity;
      channel.quantityKnown = true;
    }
    const double scale = numberIn(all[c], "full_scale");
    if (std::isfinite(scale) && scale != 0.0) channel.info.scale = scale;
  }
  // The header of a sound file knows whole hertz only.
  const double exact = numberIn(notes, "rate_hz");
  if (std::abs(exact - rate.value) <= 0.5 && exact > 0.0) rate = Hertz(exact);
}

}  // namespace stillcut::record
