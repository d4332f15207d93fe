#include "core/milling/identify/import/time_channels.h"

#include <algorithm>
#include <cctype>

#include "core/milling/identify/import/unit_label.h"
#include "core/units/unit_names.h"

namespace stillcut::identify {
namespace {

std::string lower(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

// "AccX", "acc_x", "+X", "Point 1 -X": the axis at the end of the name, and the sign before it.
void readAxis(TimeChannel& channel) {
  const std::string_view text = record::trimmed(channel.name);
  if (text.empty() || channel.axis != Axis::Unknown) return;
  const Axis axis = axisFromLetter(text.back());
  if (axis == Axis::Unknown) return;
  const char before = text.size() > 1 ? text[text.size() - 2] : ' ';
  const bool upper = text.back() >= 'X' && text.back() <= 'Z' && before >= 'a' && before <= 'z';
  const bool apart = std::isalnum(static_cast<unsigned char>(before)) == 0;
  const bool symbol = text.size() == 2 && std::string_view("afvdAFVD").find(before) != std::string_view::npos;
  if (!upper && !apart && !symbol) return;
  channel.axis = axis;
  if (before == '-') channel.sign = -1.0;
}

std::optional<FrfQuantity> quantityOf(SensorQuantity quantity) {
  if (quantity == SensorQuantity::Displacement) return FrfQuantity::Compliance;
  if (quantity == SensorQuantity::Velocity) return FrfQuantity::Mobility;
  if (quantity == SensorQuantity::Acceleration) return FrfQuantity::Accelerance;
  return std::nullopt;
}

void readName(TimeChannel& channel) {
  const std::string n = lower(channel.name);
  const auto has = [&n](auto... parts) { return ((n.find(parts) != std::string::npos) || ...); };
  channel.force = channel.force || (!channel.response && (has("force", "hammer", "kraft", "impact", "impuls") ||
                                                          n == "f" || n == "fx" || n == "fy" || n == "fz"));
  if (channel.force || channel.response) return;
  if (has("acc", "beschl", "vib")) channel.response = FrfQuantity::Accelerance;
  if (has("vel", "laser", "geschw")) channel.response = FrfQuantity::Mobility;
  if (has("disp", "weg", "gap")) channel.response = FrfQuantity::Compliance;
}

// "Hammer (2.25 mV/N)", "Accel 10.2 mV/g": out of the name or the unit into a place of its own.
void takeSensitivity(TimeChannel& channel) {
  if (sensitivityFromText(channel.unit)) {
    channel.sensitivity = channel.unit;
    channel.unit.clear();
  } else {
    const std::size_t volts = channel.name.find("V/");
    if (volts == std::string::npos) return;
    std::size_t begin = channel.name.find_last_of("0123456789", volts);
    if (begin == std::string::npos) return;
    begin = channel.name.find_last_not_of("0123456789.", begin) + 1;
    if (!sensitivityFromText(std::string_view(channel.name).substr(begin))) return;
    channel.sensitivity = channel.name.substr(begin);
    const std::size_t last = channel.name.find_last_not_of(" ([,:=", begin == 0 ? 0 : begin - 1);
    channel.name = last == std::string::npos ? "" : channel.name.substr(0, begin == 0 ? 0 : last + 1);
  }
  const auto response = sensitivityFromText(channel.sensitivity)->response;
  channel.force = !response.has_value();
  channel.response = response;
}

TimeChannel channelOf(const record::RecordedChannel& from) {
  TimeChannel channel;
  channel.name = from.info.name;
  channel.unit = from.unit;
  if (!from.info.axis.empty()) channel.axis = axisFromLetter(from.info.axis[0]);
  const auto known = record::unitFromText(from.unit);
  const bool sensor = known && known->quantity;
  if (from.quantityKnown && (sensor || from.info.scale != 1.0)) channel.toSi = from.info.scale;
  const auto asResponse = responseUnit(from.unit);
  if (sensor || from.quantityKnown) {
    channel.force = from.info.quantity == SensorQuantity::Force;
    channel.response = quantityOf(from.info.quantity);
  }
  if (forceUnit(from.unit)) {
    channel.force = true;
    channel.response.reset();
  } else if (asResponse) {
    channel.response = asResponse->quantity;
  }
  takeSensitivity(channel);
  readName(channel);
  readAxis(channel);
  return channel;
}

}  // namespace

Result<TimeChannels> readTimeChannels(record::RecordingReader& reader, const std::string& where) {
  const record::RecordingFormat& format = reader.format();
  TimeChannels out;
  out.source = where;
  out.rate = format.rate.value;
  const auto count = static_cast<std::int64_t>(format.channels.size());
  if (count == 0 || format.frames > kMostSamples / count) {
    return Error{where, message("is too long for a tap test"), message("cut the hits out with convert --from, --to")};
  }
  for (const record::RecordedChannel& channel : format.channels) out.channels.push_back(channelOf(channel));
  SampleBlock block;
  block.allocate(static_cast<int>(count), std::max(format.blockFrames, 65536));
  bool any = false;
  while (true) {
    const Result<bool> more = reader.read(block);
    if (!more) return more.error();
    if (!*more) break;
    if (any && block.has(kBlockGap))
      return Error{where, message("samples are missing"), message("a tap test needs all of them")};
    any = true;
    for (int c = 0; c < block.channels; ++c) {
      auto& samples = out.channels[static_cast<std::size_t>(c)].samples;
      const auto now = std::as_const(block).channel(c);
      samples.insert(samples.end(), now.begin(), now.end());
    }
    if (block.has(kBlockEnd)) break;
  }
  return out;
}

}  // namespace stillcut::identify
