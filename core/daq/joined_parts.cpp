#include "core/daq/joined_parts.h"

#include <string>
#include <utility>
#include <vector>

#include "core/daq/joined_source.h"
#include "core/model/sensor_status.h"

namespace stillcut::daq {
namespace {

constexpr const char* kWhere = "source 'joined'";
constexpr int kMostDevices = 8;
Message two() {
  return message("two devices or more are joined: 1_id, 2_id ...");
}

using Settings = std::map<std::string, std::string>;

// What begins with `prefix`, without it; it is taken out of `all`.
Settings takePart(Settings& all, const std::string& prefix) {
  Settings part;
  for (auto it = all.lower_bound(prefix); it != all.end() && it->first.starts_with(prefix);) {
    part.emplace(it->first.substr(prefix.size()), it->second);
    it = all.erase(it);
  }
  return part;
}

// The settings that joining adds to a device's own; they are taken out of `part`.
struct Joining {
  std::string id;
  int channels = 1;
  double delay_ms = 0.0;
};

Result<Joining> takeJoining(Settings& part, const std::string& prefix) {
  const std::string id = prefix + "id";
  const std::string channels = prefix + "channels";
  const std::string delay = prefix + "delay_ms";
  Settings ours;
  for (const std::string& key : {id, channels, delay}) {
    if (auto node = part.extract(key.substr(prefix.size()))) ours.emplace(key, node.mapped());
  }
  config::ComponentSettings settings(ours, kWhere);
  Joining joining;
  if (!settings.has(id)) settings.fault(id, message("is missing"), two());
  joining.id = settings.text(id, "");
  if (joining.id == "joined" || joining.id == "simulated")
    settings.fault(id, message("is '%1'", joining.id), message("a device"));
  joining.channels = settings.whole(channels, 1, 1, kMaxChannels);
  joining.delay_ms = settings.number(delay, 0.0, -1000.0, 1000.0);
  if (Status known = settings.finish(); !known) return known.error();
  return joining;
}

}  // namespace

Result<std::unique_ptr<DaqSource>> makeJoined(const SourceRequest& request) {
  Settings left = request.settings;
  std::vector<JoinedPart> parts;
  std::size_t taken = 0;
  for (int number = 1; number <= kMostDevices; ++number) {
    const std::string prefix = std::to_string(number) + "_";
    SourceRequest one = request;
    one.asked = nullptr;
    one.settings = takePart(left, prefix);
    if (one.settings.empty() && number > 2) break;
    const auto joining = takeJoining(one.settings, prefix);
    if (!joining) return joining.error();
    const auto channels = static_cast<std::size_t>(joining->channels);
    if (channels > request.channels.size() - taken) {
      return Error{kWhere, message("'%1channels' is %2", prefix, std::to_string(channels)),
                   message("the [[channels]] are %1 in all, and %2 of them are taken",
                           std::to_string(request.channels.size()), std::to_string(taken))};
    }
    const auto from = request.channels.begin() + static_cast<std::ptrdiff_t>(taken);
    one.channels.assign(from, from + joining->channels);
    taken += channels;
    auto device = makeSource(joining->id, one);
    if (!device) {
      const Error& e = device.error();
      return Error{message("%1, device %2: %3", kWhere, number, e.where), e.what, e.why};
    }
    parts.push_back({std::move(device).value(), Seconds(joining->delay_ms * 1e-3)});
  }
  if (!left.empty()) {
    return Error{kWhere, message("'%1' is not known", left.begin()->first),
                 message("1_id, 1_channels, 1_delay_ms and 1_ with the device's own settings, then 2_")};
  }
  if (taken != request.channels.size()) {
    return Error{kWhere, message("%1 [[channels]] in the profile", std::to_string(request.channels.size())),
                 message("the devices have %1: N_channels says how many are theirs", std::to_string(taken))};
  }
  if (request.clock == nullptr) return Error{kWhere, message("there is no clock here")};
  return std::unique_ptr<DaqSource>(std::make_unique<JoinedSource>(std::move(parts), *request.clock));
}

}  // namespace stillcut::daq
