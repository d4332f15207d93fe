#include "core/evaluate/answer_json.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "core/evaluate/answer_text.h"
#include "core/evaluate/judged_time.h"

namespace stillcut::evaluate {
namespace {

using nlohmann::json;

json orNull(double value, bool known) {
  return known && std::isfinite(value) ? json(value) : json();
}

json toJson(const std::vector<UnjudgedTime>& times) {
  json array = json::array();
  for (const UnjudgedTime& t : times) {
    const int channel = channelOf(t.reason);
    array.push_back({{"code", std::string(identifier(t.reason.code))},
                     {"reason", sentence(t.reason)},
                     {"channel", channel >= 0 ? json(channel) : json()},
                     {"time_s", t.time.value}});
  }
  return array;
}

json textOrNull(const Message& message) {
  return message.empty() ? json() : json(text(message));
}

}  // namespace

json toJson(const SpeedAnswer& a) {
  json speeds = json::array();
  for (const SpeedChoice& c : a.choices) {
    const bool range = c.to > c.from;
    speeds.push_back({{"speed_rpm", c.speed.value},
                      {"waves", c.waves},
                      {"basis", std::string(name(c.basis))},
                      {"from_rpm", orNull(c.from.value, range)},
                      {"to_rpm", orNull(c.to.value, range)}});
  }
  return {{"sentence", textOrNull(adviceSentence(a, englishWriting()))},
          {"chatter_hz", orNull(a.chatter.value, a.chatter.value > 0.0)},
          {"teeth", a.teeth > 0 ? json(a.teeth) : json()},
          {"present_rpm", orNull(a.present.value, a.present.value > 0.0)},
          {"waves", orNull(a.waves, a.waves > 0.0)},
          {"speeds", speeds},
          {"less_depth_than_mm", orNull(1e3 * a.depthLimit.value, a.depthLimit.value > 0.0)},
          {"reason", textOrNull(a.why)}};
}

void addJudged(json& row, const RecordingAnswer& a) {
  row["finding"] = std::string(name(a.finding));
  row["judged_s"] = a.judged.value;
  row["air_s"] = a.air.value;
  row["not_judged"] = toJson(a.notJudged);
  row["hears_to_hz"] = a.hearsTo.value;
  if (a.finding == Finding::NotJudged) row["alarms"] = nullptr;
}

json toJson(const RecordingAnswer& a) {
  const AnswerWriting writing = englishWriting();
  const bool chatter = a.finding == Finding::Chatter;
  json object{{"detector", a.detector},
              {"sentence", text(findingSentence(a, writing))},
              {"judged_sentence", text(judgedSentence(a, writing))},
              {"length_s", a.length.value},
              {"alarms", a.alarms},
              {"first_alarm_s", orNull(a.firstAlarm.value, chatter)},
              {"frequency_hz", orNull(a.chatter.value, a.chatter.value > 0.0)},
              {"severity", orNull(a.severity, chatter)},
              {"advice", chatter ? toJson(a.advice) : json()},
              {"channels", json::array()},
              {"left_out", json::array()}};
  addJudged(object, a);
  for (const ChannelAnswer& c : a.channels) {
    object["channels"].push_back({{"channel", c.index},
                                  {"name", c.name},
                                  {"quantity", std::string(name(c.quantity))},
                                  {"faults", toJson(c.faults)}});
  }
  for (const LeftOutChannel& c : a.leftOut) {
    object["left_out"].push_back({{"channel", c.index}, {"name", c.name}, {"reason", text(c.why)}});
  }
  return object;
}

}  // namespace stillcut::evaluate
