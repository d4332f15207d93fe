// The JSON lines of `run`; every field is in resources/manual/scripts.md.
#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "app/cli/json_line.h"
#include "app/cli/run/run_reporter.h"
#include "core/model/judged_cut.h"
#include "core/rt/deadline_stats.h"
#include "generated/version.h"

namespace stillcut::app {
namespace {

using nlohmann::json;

std::string_view name(SpeedAdvice::Kind kind) {
  constexpr std::array<std::string_view, 5> kNames{"none", "speed", "out-of-reach", "less-depth", "to-programmed"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::string_view name(EventLevel level) {
  constexpr std::array<std::string_view, 3> kNames{"info", "warning", "fault"};
  return kNames[static_cast<std::size_t>(level)];
}

std::string_view name(MoveOutcome outcome) {
  constexpr std::array<std::string_view, 4> kNames{"none", "helped", "not-helped", "louder"};
  return kNames[static_cast<std::size_t>(outcome)];
}

json textOrNull(const std::string& words) {
  return words.empty() ? json() : json(words);
}
json positive(double value) {
  return orNull(value, value > 0.0);
}
json feed(MetresPerSecond value) {
  return orNull(toMmPerMin(value), value.value > 0.0);
}
void addReason(json& object, const Reason& reason) {
  const bool none = reason.code == ReasonCode::None;
  object["reason"] = none ? json() : json(std::string(identifier(reason.code)));
  object["sentence"] = none ? json() : textOrNull(sentence(reason));
}

// FNV-1a, to tell one text of a profile from another.
std::string hashOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::uint64_t hash = 14695981039346656037ULL;
  for (auto c = std::istreambuf_iterator<char>(file); c != std::istreambuf_iterator<char>(); ++c) {
    hash = (hash ^ static_cast<unsigned char>(*c)) * 1099511628211ULL;
  }
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

json adviceJson(const Snapshot& s) {
  const SpeedAdvice& a = s.advice;
  json object{{"kind", std::string(name(a.kind))},
              {"speed_rpm", positive(a.speed.value)},
              {"feed_mm_min", feed(a.feed)},
              {"present_rpm", positive(a.base.value)},
              {"present_feed_mm_min", feed(a.baseFeed)},
              {"chatter_hz", positive(a.chatter.value)},
              {"depth_mm", positive(1e3 * a.depth.value)},
              {"open", s.adviceOpen}};
  addReason(object, a.reason);
  if (const std::string words = adviceWords(a); !words.empty()) object["sentence"] = words;
  return object;
}

json machineJson(const Snapshot& s) {
  const MachineState& m = s.machine;
  return {{"link_up", m.linkUp},
          {"valid", m.valid},
          {"program_running", m.programRunning},
          {"feed_hold", m.feedHold},
          {"inhibit", std::string(stillcut::name(m.block))},
          {"programmed_rpm", m.programmedSpeed.value},
          {"actual_rpm", m.actualSpeed.value},
          {"programmed_feed_mm_min", toMmPerMin(m.programmedFeed)},
          {"actual_feed_mm_min", toMmPerMin(m.actualFeed)},
          {"operator_speed_percent", 100.0 * m.operatorSpeed.value},
          {"operator_feed_percent", 100.0 * m.operatorFeed.value},
          {"speed_override_percent", 100.0 * m.speedOverride.value},
          {"feed_override_percent", 100.0 * m.feedOverride.value},
          {"age_s", orNull(secondsBetween(m.time, s.time).value, m.time != Instant{})}};
}

json commandJson(const Snapshot& s) {
  json object{{"in_force", s.commanding},
              {"speed_percent", s.commanding ? 100.0 * s.command.speed.value : 100.0},
              {"feed_percent", s.commanding ? 100.0 * s.command.feed.value : 100.0}};
  addReason(object, s.command.reason);
  return object;
}

json interventionJson(const Intervention& card, const RunTimes& times) {
  const auto at = [&times](Instant t) {
    const auto since = t != Instant{} ? times.sinceBegin(t) : std::nullopt;
    return since ? json(since->value) : json();
  };
  return {{"began_t", at(card.began)},
          {"commanded_t", at(card.commanded)},
          {"quiet", card.quiet},
          {"outcome", std::string(name(card.outcome))},
          {"time_to_stable_s", card.timeToStable.value},
          {"frequency_hz", positive(card.frequency.value)},
          {"speed_before_rpm", positive(card.speedBefore.value)},
          {"speed_after_rpm", positive(card.speedAfter.value)},
          {"feed_before_mm_min", feed(card.feedBefore)},
          {"feed_after_mm_min", feed(card.feedAfter)},
          {"energy_ratio_before", card.severityBefore.value},
          {"energy_ratio_after", card.severityAfter.value},
          {"rms_before", orNull(card.vibrationBefore)},
          {"rms_after", orNull(card.vibrationAfter)},
          {"marked_mm", 1e3 * card.marked.value}};
}

class JsonReporter final : public RunReporter {
 public:
  explicit JsonReporter(Rig& rig) : rig_(rig) {}

  void start(const RunBegin& begin) override {
    json line = lineOf("start", utcNowMs(), std::nullopt);
    const CutSetup& setup = rig_.setup();
    const daq::SourceFormat& format = rig_.deviceFormat();
    line["version"] = STILLCUT_VERSION;
    line["profile"] = begin.profilePath;
    line["profile_hash"] = hashOf(begin.profilePath);
    line["machine_name"] = setup.machine;
    line["tool"] = textOrNull(setup.tool);
    line["job"] = textOrNull(begin.profile.recording.job);
    line["operator"] = textOrNull(begin.profile.operatorName);
    line["teeth"] = setup.teeth > 0 ? json(setup.teeth) : json();
    line["source"] = begin.profile.source.id;
    line["link"] = textOrNull(begin.profile.link.id);
    line["live"] = rig_.device().live();
    line["detector"] = begin.profile.detector;
    line["strategy"] = begin.profile.strategy;
    line["mode"] = std::string(stillcut::name(begin.mode));
    line["auto_allowed"] = begin.profile.allowAuto;
    line["rate_hz"] = format.rate.value;
    line["block_s"] = format.blockFrames / format.rate.value;
    line["channels"] = json::array();
    for (const ChannelInfo& c : setup.channels) {
      line["channels"].push_back({{"name", c.name},
                                  {"quantity", std::string(stillcut::name(c.quantity))},
                                  {"unit", std::string(siUnit(c.quantity))},
                                  {"axis", textOrNull(c.axis)},
                                  {"place", textOrNull(c.place)}});
    }
    addRecording(line);
    printJsonLine(line);
  }
  void change(const RunLook& look) override { printState("change", look); }
  void status(const RunLook& look) override { printState("status", look); }
  void event(const RunLook& look, const Event& event, const Intervention* closed) override {
    json line = lineOf("event", look.times.utcMs(event.time), look.times.sinceBegin(event.time));
    line["number"] = event.number;
    line["level"] = std::string(name(event.level));
    addReason(line, event.reason);
    line["values"] = json::array();
    for (const double n : event.reason.n) line["values"].push_back(orNull(n));
    if (closed != nullptr) line["intervention"] = interventionJson(*closed, look.times);
    printJsonLine(line);
  }
  void note(const std::string& sentence) override {
    json line = lineOf("note", utcNowMs(), std::nullopt);
    line["sentence"] = sentence;
    printJsonLine(line);
  }
  void stopped(Seconds silent, const std::string& why) override {
    json line = lineOf("stopped", utcNowMs(), std::nullopt);
    line["sentence"] = why.empty() ? "samples stopped" : "samples stopped: " + why;
    line["silent_s"] = silent.value;
    printJsonLine(line);
  }
  void resumed(Seconds silent) override {
    json line = lineOf("resumed", utcNowMs(), std::nullopt);
    line["sentence"] = "samples come again";
    line["silent_s"] = silent.value;
    printJsonLine(line);
  }
  void end(const RunEnd& end, const RunLook* last) override {
    const auto length = last != nullptr ? last->times.sinceBegin(last->now.time) : std::nullopt;
    json line = lineOf("end", utcNowMs(), length);
    line["exit_code"] = end.exitCode;
    line["sentence"] = end.why;
    line["length_s"] = length ? length->value : 0.0;
    line["in_cut_s"] = last != nullptr ? last->now.cutTime.value : 0.0;
    line["judged_s"] = last != nullptr ? last->now.judgedTime.value : 0.0;
    line["chatter_s"] = last != nullptr ? last->now.chatterTime.value : 0.0;
    line["alarms"] = last != nullptr ? last->now.interventionCount : 0;
    const pipeline::Engine* engine = rig_.engine();
    const bool decided = engine != nullptr && engine->latency().count() > 0;
    line["dropped_blocks"] = engine != nullptr ? engine->droppedBlocks() : 0;
    line["latency_ms"] = decided ? json(1e3 * engine->latency().quantile(0.5).value) : json();
    line["worst_latency_ms"] = decided ? json(1e3 * engine->latency().worst().value) : json();
    printJsonLine(line);
  }

 private:
  json lineOf(std::string_view type, std::int64_t utcMs, std::optional<Seconds> t) {
    json line = jsonObject("run", type);
    line["sequence"] = ++lines_;
    line["utc_ms"] = utcMs;
    line["t"] = t ? json(t->value) : json();
    return line;
  }
  void addRecording(json& line) const {
    const record::Recorder* recorder = rig_.recorder();
    const record::RecorderStatus status = recorder != nullptr ? recorder->status() : record::RecorderStatus{};
    line["recording"] = textOrNull(status.path);
    line["recording_fault"] = status.fault.empty() ? json() : json(text(status.fault));
  }
  void printState(std::string_view type, const RunLook& look) {
    const Snapshot& s = look.now;
    const Verdict& v = inCharge(s);
    json line = lineOf(type, look.times.utcMs(s.time), look.times.sinceBegin(s.time));
    line["state"] = std::string(shownState(v));
    line["phase"] = std::string(stillcut::name(v.phase));
    const bool judged = hasState(v);
    line["valid"] = judged;
    addReason(line, judged ? v.reason : whyNotJudged(v));
    line["frequency_hz"] = positive(v.frequency.value);
    line["frequency_sd_hz"] = orNull(v.frequencySd.value, v.frequency.value > 0.0);
    line["kind"] = std::string(stillcut::name(v.kind));
    line["early_warning"] = v.earlyWarning;
    line["energy_ratio"] = orNull(v.severity.value, judged);
    line["detector"] = rig_.chain().parts().detectors[static_cast<std::size_t>(s.inCharge)]->describe().id;
    line["mode"] = std::string(stillcut::name(s.authority));
    line["operator_hold"] = s.operatorHold;
    line["speed_rpm"] = positive(toRpm(v.spindle).value);
    line["rms"] = orNull(s.vibrationRms);
    line["rms_unit"] =
        rig_.setup().channels.empty() ? json() : json(std::string(siUnit(rig_.setup().channels[0].quantity)));
    line["advice"] = adviceJson(s);
    line["machine"] = rig_.hasLink() ? machineJson(s) : json();
    line["overrides"] = commandJson(s);
    line["in_cut_s"] = s.cutTime.value;
    line["judged_s"] = s.judgedTime.value;
    line["chatter_s"] = s.chatterTime.value;
    line["chatter_mm"] = 1e3 * s.chatterLength.value;
    line["blocks"] = s.health.blocks;
    line["dropped_blocks"] = s.health.droppedBlocks;
    line["gaps"] = s.health.gaps;
    line["lost_frames"] = s.sensors.lostFrames;
    line["overruns"] = s.health.overruns;
    line["latency_ms"] = 1e3 * s.health.blockAge.value;
    line["worst_latency_ms"] = 1e3 * s.health.worstBlockAge.value;
    addRecording(line);
    printJsonLine(line);
  }

  Rig& rig_;
  std::uint64_t lines_ = 0;
};

}  // namespace

std::unique_ptr<RunReporter> makeJsonReporter(Rig& rig) {
  return std::make_unique<JsonReporter>(rig);
}

}  // namespace stillcut::app
