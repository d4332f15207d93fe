#include "app/shop/run_translator.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <initializer_list>
#include <string>
#include <utility>

namespace stillcut::shop {
namespace {

using nlohmann::json;

// Absent is as unknown as null.
const json& at(const json& object, const char* key) {
  static const json kNothing;
  if (!object.is_object()) return kNothing;
  const auto found = object.find(key);
  return found != object.end() ? *found : kNothing;
}
std::string words(const json& object, const char* key) {
  const json& value = at(object, key);
  return value.is_string() ? value.get<std::string>() : std::string();
}
double number(const json& object, const char* key) {
  const json& value = at(object, key);
  return value.is_number() ? value.get<double>() : 0.0;
}
std::int64_t whole(const json& object, const char* key) {
  const json& value = at(object, key);
  return value.is_number() ? value.get<std::int64_t>() : 0;
}
void carry(json& to, const json& from, std::initializer_list<const char*> keys) {
  for (const char* key : keys) to[key] = at(from, key);
}

bool alarming(const std::string& state) {
  return state == "onset" || state == "chatter";
}

// A change of what a screen would show: the line's own rule for the frequency, 2 %.
bool sameState(const json& a, const json& b) {
  for (const char* key : {"state", "reason", "kind", "mode", "run"}) {
    if (at(a, key) != at(b, key)) return false;
  }
  const double was = number(a, "frequency_hz");
  return std::abs(number(b, "frequency_hz") - was) <= 0.02 * was;
}

}  // namespace

std::int64_t utcNowMs() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::milliseconds>(now).count();
}

RunTranslator::RunTranslator() = default;

std::vector<ShopMessage> RunTranslator::take(const json& line) {
  told_.clear();
  const std::string type = words(line, "type");
  if (type == "start") {
    start(line);
  } else {
    lost(line);
  }
  newestUtcMs_ = std::max(newestUtcMs_, whole(line, "utc_ms"));
  if (type == "change" || type == "status") state(line, type == "status");
  if (type == "event" || type == "marker") event(line);
  if (type == "stopped") silent(line, "samples-stopped");
  if (type == "end") {
    silent(line, "run-ended");
    json payload = about(line);
    carry(payload, line,
          {"exit_code", "sentence", "length_s", "in_cut_s", "judged_s", "chatter_s", "alarms", "dropped_blocks",
           "worst_latency_ms"});
    tell("event/end", std::move(payload));
  }
  if (type == "note" || type == "resumed") {
    json payload = about(line);
    carry(payload, line, {"sentence"});
    payload["reason"] = type == "note" ? json() : json("samples-resumed");
    tell("event/note", std::move(payload));
  }
  return std::exchange(told_, {});
}

void RunTranslator::start(const json& line) {
  // The run before it has ended without saying so: killed, or the power went, at its newest line or soon after.
  if (!alarm_.is_null()) endAlarm(newestUtcMs_, line, "run-ended");
  run_ = {{"run", whole(line, "utc_ms")},
          {"machine", at(line, "machine_name")},
          {"job", at(line, "job")},
          {"tool", at(line, "tool")}};
  state_ = json();
  featuresUtcMs_ = newestUtcMs_ = 0;
  statusComes_ = false;
  lines_ = static_cast<std::uint64_t>(whole(line, "sequence"));
  json meta = about(line);
  carry(meta, line,
        {"version", "profile", "profile_hash", "operator", "teeth", "source", "link", "live", "detector", "strategy",
         "mode", "auto_allowed", "rate_hz", "block_s", "channels"});
  meta["program"] = "stillcut";
  tell("meta", std::move(meta), true);
}

// The run counts its lines without a gap: what is missing never came here.
void RunTranslator::lost(const json& line) {
  const auto here = static_cast<std::uint64_t>(whole(line, "sequence"));
  if (lines_ > 0 && here > lines_ + 1) {
    json payload = about(line);
    payload["reason"] = "lines-lost";
    payload["sentence"] = std::to_string(here - lines_ - 1) + " lines of the run did not come here";
    payload["lines"] = here - lines_ - 1;
    tell("event/fault", std::move(payload));
  }
  lines_ = here;
}

void RunTranslator::state(const json& line, bool status) {
  const json& machine = at(line, "machine");
  const json& ours = at(line, "overrides");
  json now = about(line);
  carry(now, line,
        {"state", "phase", "reason", "sentence", "frequency_hz", "frequency_sd_hz", "kind", "early_warning",
         "energy_ratio", "speed_rpm", "mode", "operator_hold", "detector"});
  now["advice"] = at(at(line, "advice"), "sentence");
  now["advised_rpm"] = at(at(line, "advice"), "speed_rpm");
  alarm(line);
  if (!sameState(state_, now)) {
    state_ = now;
    tell("state", std::move(now), true);
  }
  statusComes_ = statusComes_ || status;
  const std::int64_t utcMs = whole(line, "utc_ms"), since = utcMs - featuresUtcMs_;
  // Less than nothing: the clock was set back.
  if (!status && (statusComes_ || (since >= 0 && since < 1000))) return;
  featuresUtcMs_ = utcMs;
  json features = about(line);
  carry(
      features, line,
      {"state", "in_cut_s", "judged_s", "energy_ratio", "frequency_hz", "rms", "rms_unit", "speed_rpm", "chatter_s",
       "chatter_mm", "blocks", "dropped_blocks", "gaps", "lost_frames", "overruns", "latency_ms", "worst_latency_ms"});
  carry(features, machine,
        {"programmed_rpm", "actual_rpm", "programmed_feed_mm_min", "actual_feed_mm_min", "operator_speed_percent",
         "operator_feed_percent", "speed_override_percent", "feed_override_percent"});
  features["our_speed_percent"] = at(ours, "speed_percent");
  features["our_feed_percent"] = at(ours, "feed_percent");
  features["in_force"] = at(ours, "in_force");
  tell("features", std::move(features));
}

// It begins with onset or chatter and ends when the cut is stable or over: a moment that was not judged ends nothing.
void RunTranslator::alarm(const json& line) {
  const std::string state = words(line, "state");
  if (alarm_.is_null() && alarming(state)) {
    alarm_ = about(line);
    carry(
        alarm_, line,
        {"state", "frequency_hz", "kind", "energy_ratio", "speed_rpm", "mode", "detector", "chatter_s", "chatter_mm"});
    carry(alarm_, at(line, "machine"), {"programmed_rpm", "actual_feed_mm_min"});
    json payload = alarm_;
    payload.erase("chatter_s");
    payload.erase("chatter_mm");
    payload["edge"] = "begin";
    tell("event/alarm", std::move(payload));
  } else if (!alarm_.is_null() && (state == "stable" || state == "air")) {
    endAlarm(whole(line, "utc_ms"), line, state == "stable" ? "stable" : "left-cut");
  }
}

void RunTranslator::endAlarm(std::int64_t utcMs, const json& line, const char* how) {
  json payload = about(line);
  carry(payload, alarm_, {"frequency_hz", "kind", "speed_rpm", "mode", "detector"});
  payload["utc_ms"] = utcMs;
  payload["edge"] = "end";
  payload["how"] = how;
  payload["began_utc_ms"] = at(alarm_, "utc_ms");
  payload["duration_s"] = 1e-3 * static_cast<double>(utcMs - whole(alarm_, "utc_ms"));
  const bool counted = at(line, "chatter_s").is_number() && at(alarm_, "chatter_s").is_number();
  payload["chatter_s"] = counted ? json(number(line, "chatter_s") - number(alarm_, "chatter_s")) : json();
  payload["chatter_mm"] = at(line, "chatter_mm").is_number() && at(alarm_, "chatter_mm").is_number()
                              ? json(number(line, "chatter_mm") - number(alarm_, "chatter_mm"))
                              : json();
  alarm_ = json();
  tell("event/alarm", std::move(payload));
}

void RunTranslator::event(const json& line) {
  if (const json& card = at(line, "intervention"); card.is_object()) {
    json payload = about(line);
    payload["before"] = {{"speed_rpm", at(card, "speed_before_rpm")},
                         {"feed_mm_min", at(card, "feed_before_mm_min")},
                         {"energy_ratio", at(card, "energy_ratio_before")},
                         {"rms", at(card, "rms_before")}};
    payload["after"] = {{"speed_rpm", at(card, "speed_after_rpm")},
                        {"feed_mm_min", at(card, "feed_after_mm_min")},
                        {"energy_ratio", at(card, "energy_ratio_after")},
                        {"rms", at(card, "rms_after")}};
    carry(payload, card, {"quiet", "outcome", "time_to_stable_s", "frequency_hz", "marked_mm"});
    tell("event/intervention", std::move(payload));
  }
  json payload = about(line);
  carry(payload, line, {"reason", "sentence", "values", "level"});
  const std::string reason = words(line, "reason");
  std::string topic = "event/note";
  if (words(line, "type") == "marker") {
    topic = "event/marker";
    carry(payload, line, {"label", "author", "note", "begin_utc_ms", "end_utc_ms", "number", "removed"});
  } else if (words(line, "level") == "fault") {
    topic = "event/fault";
  } else if (words(line, "level") == "warning" && reason != "chatter-began") {
    topic = "event/warning";
  } else if (reason == "advice-refused" || reason == "advice-accepted") {
    topic = "event/advice";
    payload["answer"] = reason == "advice-refused" ? "refused" : "accepted";
    const json& values = at(line, "values");
    payload["advised_rpm"] = values.is_array() && !values.empty() ? values[0] : json();
    payload["frequency_hz"] = at(state_, "frequency_hz");
    payload["speed_rpm"] = at(state_, "speed_rpm");
  }
  tell(std::move(topic), std::move(payload));
}

void RunTranslator::silent(const json& line, const char* reason) {
  if (!alarm_.is_null()) endAlarm(whole(line, "utc_ms"), line, reason);
  json now = about(line);
  now["state"] = "not-judged";
  now["reason"] = reason;
  carry(now, line, {"sentence"});
  now["mode"] = at(state_, "mode");
  state_ = now;
  if (words(line, "type") == "stopped") {
    json fault = now;
    fault["silent_s"] = at(line, "silent_s");
    tell("event/fault", std::move(fault));
  }
  tell("state", std::move(now), true);
}

json RunTranslator::about(const json& line) const {
  json payload = run_.is_object() ? run_ : json{{"run", 0}};
  payload["utc_ms"] = whole(line, "utc_ms");
  payload["t"] = at(line, "t");
  return payload;
}

void RunTranslator::tell(std::string topic, json payload, bool retained) {
  told_.push_back({std::move(topic), std::move(payload), retained});
}

json RunTranslator::memory() const {
  return {{"run", run_},
          {"state", state_},
          {"alarm", alarm_},
          {"features_utc_ms", featuresUtcMs_},
          {"newest_utc_ms", newestUtcMs_},
          {"lines", lines_},
          {"status", statusComes_}};
}

void RunTranslator::recall(const json& memory) {
  run_ = at(memory, "run");
  state_ = at(memory, "state");
  alarm_ = at(memory, "alarm");
  featuresUtcMs_ = whole(memory, "features_utc_ms");
  newestUtcMs_ = whole(memory, "newest_utc_ms");
  lines_ = static_cast<std::uint64_t>(whole(memory, "lines"));
  statusComes_ = at(memory, "status") == json(true);
}

}  // namespace stillcut::shop
