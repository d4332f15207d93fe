#include "core/formats/hdf5/isolated_messages.h"

#include <sys/socket.h>

#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>
#include <type_traits>

namespace stillcut::record::apart {
namespace {

using Json = nlohmann::json;

std::string text(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// Numbers as they are, not-a-number too, and texts whatever bytes they hold.
std::string cbor(const Json& json) {
  std::string bytes;
  Json::to_cbor(json, bytes);
  return bytes;
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
  if (options.secondsPerTime) json["seconds_per_time"] = *options.secondsPerTime;
  if (options.quantity) json["quantity"] = static_cast<int>(*options.quantity);
  if (options.scale) json["scale"] = *options.scale;
  json["channels"] = options.channels;
  return text(json);
}

ReadOptions optionsFrom(const std::string& json) {
  const Json all = Json::parse(json);
  ReadOptions options;
  if (all.contains("rate")) options.rate = Hertz(all["rate"].get<double>());
  if (all.contains("seconds_per_time")) options.secondsPerTime = all["seconds_per_time"].get<double>();
  if (all.contains("quantity")) options.quantity = static_cast<SensorQuantity>(all["quantity"].get<int>());
  if (all.contains("scale")) options.scale = all["scale"].get<double>();
  options.channels = all["channels"].get<std::vector<int>>();
  return options;
}

namespace {

Json packed(const RecordedChannel& c) {
  return {{"name", c.info.name},
          {"quantity", static_cast<int>(c.info.quantity)},
          {"known", c.quantityKnown},
          {"scale", c.info.scale},
          {"axis", c.info.axis},
          {"unit", c.unit},
          {"sensitivity", c.info.sensitivity},
          {"volts", c.info.volts},
          {"coupling", c.info.coupling},
          {"place", c.info.place}};
}

RecordedChannel channelFrom(const Json& one) {
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
  return c;
}

// As a session has it; the channels' own lines say the rest.
Json packed(const CutSetup& setup) {
  Json channels = Json::array();
  for (const ChannelInfo& info : setup.channels) channels.push_back(packed(RecordedChannel{info, "", true}));
  return {{"machine", setup.machine},
          {"tool", setup.tool},
          {"teeth", setup.teeth},
          {"diameter", setup.toolDiameter.value},
          {"speed", setup.nominalSpeed.value},
          {"feed", setup.nominalFeed.value},
          {"rate", setup.rate.value},
          {"blockFrames", setup.blockFrames},
          {"channels", channels}};
}

CutSetup setupFrom(const Json& all) {
  CutSetup setup;
  setup.machine = all["machine"].get<std::string>();
  setup.tool = all["tool"].get<std::string>();
  setup.teeth = all["teeth"].get<int>();
  setup.toolDiameter = Metres(all["diameter"].get<double>());
  setup.nominalSpeed = Rpm(all["speed"].get<double>());
  setup.nominalFeed = MetresPerSecond(all["feed"].get<double>());
  setup.rate = Hertz(all["rate"].get<double>());
  setup.blockFrames = all["blockFrames"].get<int>();
  for (const Json& one : all["channels"]) setup.channels.push_back(channelFrom(one).info);
  return setup;
}

}  // namespace

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

std::string toCbor(const RecordingFormat& format) {
  Json channels = Json::array();
  for (const RecordedChannel& c : format.channels) channels.push_back(packed(c));
  Json all{{"kind", format.kind},
           {"rate", format.rate.value},
           {"frames", format.frames},
           {"blocks", format.blocks},
           {"blockFrames", format.blockFrames},
           {"skipped", format.skipped},
           {"channels", channels},
           {"configuration", format.configuration},
           {"program", format.programVersion},
           {"operator", format.operatorName},
           {"job", format.job},
           {"started", format.started_ns},
           {"simulated", format.simulated},
           {"closed", format.closedCleanly}};
  for (const Message& note : format.notes) all["notes"].push_back(json(note));
  for (const Message& why : format.skippedWhy) all["skipped_why"].push_back(json(why));
  if (format.setup) all["setup"] = packed(*format.setup);
  return cbor(all);
}

RecordingFormat formatFrom(const std::string& packed) {
  const Json all = Json::from_cbor(packed);
  RecordingFormat format;
  format.kind = all["kind"].get<std::string>();
  format.rate = Hertz(all["rate"].get<double>());
  format.frames = all["frames"].get<std::int64_t>();
  format.blocks = all["blocks"].get<std::int64_t>();
  format.blockFrames = all["blockFrames"].get<int>();
  format.skipped = all["skipped"].get<std::vector<std::string>>();
  for (const Json& one : all["channels"]) format.channels.push_back(channelFrom(one));
  format.configuration = all["configuration"].get<std::string>();
  format.programVersion = all["program"].get<std::string>();
  format.operatorName = all["operator"].get<std::string>();
  format.job = all["job"].get<std::string>();
  format.started_ns = all["started"].get<std::int64_t>();
  format.simulated = all["simulated"].get<bool>();
  format.closedCleanly = all["closed"].get<bool>();
  if (all.contains("skipped_why")) {
    for (const Json& why : all["skipped_why"]) format.skippedWhy.push_back(messageFrom(why));
  }
  if (all.contains("notes")) {
    for (const Json& note : all["notes"]) format.notes.push_back(messageFrom(note));
  }
  if (all.contains("setup")) format.setup = setupFrom(all["setup"]);
  return format;
}

std::string toJson(const Ask& ask) {
  return text({{"ask", ask.what}, {"arguments", ask.arguments}, {"patience", ask.patience.value}});
}

std::optional<Ask> askFrom(const std::string& json) {
  const Json all = Json::parse(json);
  if (!all.contains("ask")) return std::nullopt;
  return Ask{all["ask"].get<std::string>(), all["arguments"].get<std::string>(),
             Seconds(all["patience"].get<double>())};
}

// As memory has them: both ends are of one build.
static_assert(std::is_trivially_copyable_v<MachineState> && std::is_trivially_copyable_v<StepOutput> &&
              std::is_trivially_copyable_v<OperatorInput>);

void packStep(const StepRecord& step, std::span<std::byte, kStepBytes> out) {
  std::byte* to = out.data();
  const auto put = [&to](const auto& value) {
    std::memcpy(to, &value, sizeof value);
    to += sizeof value;
  };
  put(step.input.machine);
  put(step.input.inputCount);
  put(step.input.inputs);
  put(step.output);
}

void unpackStep(std::string_view bytes, StepRecord& step) {
  const char* from = bytes.data();
  const auto take = [&from](auto& value) {
    std::memcpy(static_cast<void*>(&value), from, sizeof value);
    from += sizeof value;
  };
  take(step.input.machine);
  take(step.input.inputCount);
  take(step.input.inputs);
  take(step.output);
}

std::string toJson(const Error& error) {
  return text(Json{{"where", json(error.where)}, {"what", json(error.what)}, {"why", json(error.why)}});
}

Error errorFrom(const std::string& json) {
  const Json all = Json::parse(json);
  return {argumentFrom(all["where"]), messageFrom(all["what"]), messageFrom(all["why"])};
}

}  // namespace stillcut::record::apart
