// The lines of a run as `stillcut-cli run --json` prints them, made of what a test wants to say.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

namespace stillcut::shop::testing {

using nlohmann::json;

inline constexpr std::int64_t kBegan = 1'795'000'000'000;  // UTC ms, November 2026

class RunLines {
 public:
  explicit RunLines(std::int64_t began = kBegan) : began_(began) {}

  json start(const std::string& tool = "T12", const std::string& job = "Housing 7") {
    json l = line("start", 0.0);
    l["t"] = nullptr;
    l["version"] = "0.1.0";
    l["machine_name"] = "Mill 3";
    l["tool"] = tool;
    l["job"] = job;
    l["teeth"] = 4;
    l["profile"] = "mill3.toml";
    l["profile_hash"] = "0123456789abcdef";
    l["channels"] = {{{"name", "x"}, {"quantity", "acceleration"}, {"unit", "m/s^2"}, {"axis", "x"}}};
    return l;
  }
  json state(const char* type, double t, const std::string& state, double frequency = 0.0) {
    json l = line(type, t);
    l["state"] = state;
    l["phase"] = state == "air" ? "air" : "steady";
    l["valid"] = state != "not-judged";
    l["reason"] = state == "not-judged" ? json("input-clipped") : json();
    l["sentence"] = state == "not-judged" ? json("the sensor is at its limit") : json();
    l["frequency_hz"] = frequency > 0.0 ? json(frequency) : json();
    l["kind"] = frequency > 0.0 ? "hopf" : "unknown";
    l["energy_ratio"] = state == "chatter" ? 0.6 : 0.02;
    l["detector"] = "energy-ratio";
    l["mode"] = "advise";
    l["speed_rpm"] = 8500.0;
    l["rms"] = 3.5;
    l["rms_unit"] = "m/s^2";
    l["advice"] = {{"kind", "none"}, {"sentence", nullptr}, {"speed_rpm", nullptr}};
    l["machine"] = {{"programmed_rpm", 8500.0},         {"actual_rpm", 8498.0},
                    {"programmed_feed_mm_min", 2720.0}, {"actual_feed_mm_min", 2700.0},
                    {"operator_speed_percent", 100.0},  {"operator_feed_percent", 90.0},
                    {"speed_override_percent", 100.0},  {"feed_override_percent", 90.0}};
    l["overrides"] = {{"in_force", false}, {"speed_percent", 100.0}, {"feed_percent", 100.0}};
    l["in_cut_s"] = t;
    l["judged_s"] = t;
    l["chatter_s"] = state == "chatter" ? t : 0.0;
    l["chatter_mm"] = 0.0;
    l["dropped_blocks"] = 0;
    l["latency_ms"] = 1.5;
    return l;
  }
  json event(double t, const std::string& level, const std::string& reason) {
    json l = line("event", t);
    l["number"] = lines_;
    l["level"] = level;
    l["reason"] = reason;
    l["sentence"] = "what " + reason + " says";
    l["values"] = {8800.0, 2900.0, 0.0, 0.0};
    return l;
  }
  json line(const char* type, double t) {
    return {{"schema", "stillcut-cli/1"},
            {"command", "run"},
            {"type", type},
            {"sequence", ++lines_},
            {"utc_ms", began_ + static_cast<std::int64_t>(1000.0 * t)},
            {"t", t}};
  }

 private:
  std::int64_t began_;
  std::uint64_t lines_ = 0;
};

}  // namespace stillcut::shop::testing
