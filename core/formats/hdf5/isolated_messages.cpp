#include "core/formats/hdf5/isolated_messages.h"

#include <sys/socket.h>

#include <cerrno>
#include <nlohmann/json.hpp>

namespace stillcut::record::apart {
namespace {

using Json = nlohmann::json;

std::string text(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

bool send(int peer, std::span<const std::byte> bytes) noexcept {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(peer, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(sent));
  }
  return true;
}

bool receive(int peer, std::span<std::byte> bytes) noexcept {
  while (!bytes.empty()) {
    const ssize_t got = ::recv(peer, bytes.data(), bytes.size(), 0);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(got));
  }
  return true;
}

std::string toJson(const ReadOptions& options) {
  Json json = Json::object();
  if (options.rate) json["rate"] = options.rate->value;
  if (options.quantity) json["quantity"] = static_cast<int>(*options.quantity);
  if (options.scale) json["scale"] = *options.scale;
  json["channels"] = options.channels;
  return text(json);
}

ReadOptions optionsFrom(const std::string& json) {
  const Json all = Json::parse(json);
  ReadOptions options;
  if (all.contains("rate")) options.rate = Hertz(all["rate"].get<double>());
  if (all.contains("quantity")) options.quantity = static_cast<SensorQuantity>(all["quantity"].get<int>());
  if (all.contains("scale")) options.scale = all["scale"].get<double>();
  options.channels = all["channels"].get<std::vector<int>>();
  return options;
}

std::string toJson(const RecordingFormat& format) {
  Json channels = Json::array();
  for (const RecordedChannel& c : format.channels) {
    channels.push_back({{"name", c.info.name},
                        {"quantity", static_cast<int>(c.info.quantity)},
                        {"known", c.quantityKnown},
                        {"scale", c.info.scale},
                        {"axis", c.info.axis},
                        {"unit", c.unit},
                        {"sensitivity", c.info.sensitivity},
                        {"volts", c.info.volts},
                        {"coupling", c.info.coupling},
                        {"place", c.info.place}});
  }
  return text({{"kind", format.kind},
               {"rate", format.rate.value},
               {"frames", format.frames},
               {"skipped", format.skipped},
               {"channels", channels}});
}

RecordingFormat formatFrom(const std::string& json) {
  const Json all = Json::parse(json);
  RecordingFormat format;
  format.kind = all["kind"].get<std::string>();
  format.rate = Hertz(all["rate"].get<double>());
  format.frames = all["frames"].get<std::int64_t>();
  format.skipped = all["skipped"].get<std::vector<std::string>>();
  for (const Json& one : all["channels"]) {
    RecordedChannel c;
    c.info.name = one["name"].get<std::string>();
    c.info.quantity = static_cast<SensorQuantity>(one["quantity"].get<int>());
    c.quantityKnown = one["known"].get<bool>();
    c.info.scale = one["scale"].get<double>();
    c.info.axis = one["axis"].get<std::string>();
    c.unit = one["unit"].get<std::string>();
    c.info.sensitivity = one["sensitivity"].get<double>();
    c.info.volts = one["volts"].get<double>();
    c.info.coupling = one["coupling"].get<std::string>();
    c.info.place = one["place"].get<std::string>();
    format.channels.push_back(std::move(c));
  }
  return format;
}

namespace {

Json json(const Message& message);
Json json(const Message::Argument& argument) {
  Json messages = Json::array();
  for (const Message& message : argument.messages) messages.push_back(json(message));
  return {{"verbatim", argument.verbatim}, {"messages", messages}};
}
Json json(const Message& message) {
  Json arguments = Json::array();
  for (const Message::Argument& argument : message.arguments) arguments.push_back(json(argument));
  return {{"form", message.form}, {"arguments", arguments}};
}

Message messageFrom(const Json& all);
Message::Argument argumentFrom(const Json& all) {
  Message::Argument argument(all["verbatim"].get<std::string>());
  for (const Json& one : all["messages"]) argument.messages.push_back(messageFrom(one));
  return argument;
}
Message messageFrom(const Json& all) {
  Message message;
  message.form = all["form"].get<std::string>();
  for (const Json& one : all["arguments"]) message.arguments.push_back(argumentFrom(one));
  return message;
}

}  // namespace

std::string toJson(const Error& error) {
  return text(Json{{"where", json(error.where)}, {"what", json(error.what)}, {"why", json(error.why)}});
}

Error errorFrom(const std::string& json) {
  const Json all = Json::parse(json);
  return {argumentFrom(all["where"]), messageFrom(all["what"]), messageFrom(all["why"])};
}

}  // namespace stillcut::record::apart
