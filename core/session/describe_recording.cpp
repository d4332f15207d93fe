#include "core/session/describe_recording.h"

#include <unistd.h>

#include <cstdio>
#include <ctime>
#include <nlohmann/json.hpp>

#include "core/base/json_schema.h"
#include "core/formats/sensor_notes.h"
#include "core/session/open_recording.h"

namespace stillcut::record {
namespace {

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

// What is not told is null and never 0.
nlohmann::ordered_json known(double value) {
  return value > 0.0 ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
}

std::string channelLine(std::size_t index, const RecordedChannel& channel) {
  const ChannelInfo& info = channel.info;
  std::string line = "channel " + std::to_string(index) + "    " + info.name + ", " + std::string(name(info.quantity));
  if (!channel.quantityKnown) line += channel.unit.empty() ? " (assumed)" : " (assumed; its unit is not known)";
  if (!channel.unit.empty()) line += ", in " + channel.unit;
  if (info.scale != 1.0) line += ", times " + number(info.scale) + " makes " + std::string(siUnit(info.quantity));
  if (const std::string sensor = sensorText(info); !sensor.empty()) line += "; " + sensor;
  return line + "\n";
}

// "2026-11-21T19:02:45Z"
std::string utcText(std::int64_t sinceEpoch_ns) {
  const std::time_t seconds = sinceEpoch_ns / 1'000'000'000;
  std::tm parts{};
  char text[40] = "";
  if (gmtime_r(&seconds, &parts) != nullptr) std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

std::string markerLine(const Marker& m, Instant begin) {
  std::string text = "marker       #" + std::to_string(m.number) + " " + number(secondsBetween(begin, m.begin).value);
  if (m.end > m.begin) text += " to " + number(secondsBetween(begin, m.end).value);
  text += " s: " + m.label + " (" + m.author + ", " + utcText(m.made_ns) + ")";
  return text + (m.note.empty() ? "" : " " + m.note) + "\n";
}

std::string unclosedText(const std::string& path) {
  const std::string text = "not closed: still being written, or cut off by a crash";
  return access(path.c_str(), W_OK) == 0 ? text : text + "; read as it is, for it cannot be written to";
}

std::string sessionText(const std::string& path, const RecordingFormat& format, const SessionCounts& counts) {
  std::string text;
  if (format.setup) {
    text += "machine      " + format.setup->machine + "\ntool         " + format.setup->tool + "\n";
    text += "programmed   " + number(format.setup->nominalSpeed.value) + " rpm, " +
            number(toMmPerMin(format.setup->nominalFeed)) + " mm/min, " + std::to_string(format.setup->teeth) +
            " teeth\n";
  }
  if (format.started_ns > 0) text += "recorded     " + utcText(format.started_ns) + "\n";
  if (!format.operatorName.empty()) text += "operator     " + format.operatorName + "\n";
  if (!format.job.empty()) text += "job          " + format.job + "\n";
  text += "program      " + format.programVersion + (format.simulated ? ", simulated machine" : "") + "\n";
  if (format.frames == 0 && counts.steps > 0) text += "samples      none: a history of features\n";
  text += "steps        " + std::to_string(counts.steps) + ", with " + std::to_string(counts.gaps) + " gaps\n";
  text += "holds        " + std::to_string(counts.verdicts) + " verdicts, " + std::to_string(counts.commands) +
          " commands, " + std::to_string(counts.events) + " events, " + std::to_string(counts.inputs) +
          " operator inputs\n";
  if (!format.closedCleanly) text += "state        " + unclosedText(path) + "\n";
  for (const Event& event : counts.firstEvents) {
    text += "event        " + number(secondsBetween(counts.begin, event.time).value) + " s: " + sentence(event.reason) +
            "\n";
  }
  for (const Marker& marker : counts.markers) text += markerLine(marker, counts.begin);
  for (const auto& [key, value] : counts.truthValues) text += "truth        " + key + " = " + number(value) + "\n";
  return text;
}

nlohmann::ordered_json sessionJson(const RecordingFormat& format, const SessionCounts& counts) {
  nlohmann::ordered_json session;
  session["closed_cleanly"] = format.closedCleanly;
  session["simulated"] = format.simulated;
  session["program_version"] = format.programVersion;
  session["started_utc"] = format.started_ns > 0 ? utcText(format.started_ns) : "";
  session["operator"] = format.operatorName;
  session["job"] = format.job;
  if (format.setup) {
    session["machine"] = format.setup->machine;
    session["tool"] = format.setup->tool;
    session["teeth"] = format.setup->teeth;
    session["nominal_speed_rpm"] = format.setup->nominalSpeed.value;
    session["nominal_feed_mm_min"] = toMmPerMin(format.setup->nominalFeed);
  }
  session["steps"] = counts.steps;
  session["gaps"] = counts.gaps;
  session["verdicts"] = counts.verdicts;
  session["commands"] = counts.commands;
  session["events"] = counts.events;
  session["operator_inputs"] = counts.inputs;
  session["first_events"] = nlohmann::ordered_json::array();
  for (const Event& event : counts.firstEvents) {
    session["first_events"].push_back(
        {{"t_s", secondsBetween(counts.begin, event.time).value}, {"text", sentence(event.reason)}});
  }
  session["markers"] = nlohmann::ordered_json::array();
  for (const Marker& m : counts.markers) {
    session["markers"].push_back({{"number", m.number},
                                  {"t0_s", secondsBetween(counts.begin, m.begin).value},
                                  {"t1_s", secondsBetween(counts.begin, m.end).value},
                                  {"label", m.label},
                                  {"author", m.author},
                                  {"note", m.note},
                                  {"made_utc", utcText(m.made_ns)}});
  }
  for (const auto& [key, value] : counts.truthValues) session["truth"][key] = value;
  session["configuration"] = format.configuration;
  return session;
}

}  // namespace

namespace {

// A history of features has no samples to count.
Seconds lengthOf(const RecordingDescription& description) {
  const bool history = description.format.frames == 0 && description.session;
  return history ? secondsBetween(description.session->begin, description.session->end) : description.format.length();
}

}  // namespace

Result<RecordingDescription> describeRecording(const std::string& path, const ReadOptions& options) {
  RecordingDescription description;
  description.path = path;
  {
    const Result<std::unique_ptr<RecordingReader>> reader = openRecording(path, options);
    if (!reader) return reader.error();
    description.format = reader.value()->format();
  }
  if (description.format.setup) {
    Result<SessionCounts> counts = countSession(path);
    if (!counts) return counts.error();
    description.session = std::move(*counts);
  }
  return description;
}

std::string toText(const RecordingDescription& description) {
  const RecordingFormat& format = description.format;
  std::string text = "file         " + description.path + "\nformat       " + format.kind + "\n";
  text += "rate         " + number(format.rate.value) + " Hz\n";
  text += "length       " + number(lengthOf(description).value) + " s, " + std::to_string(format.frames) + " frames\n";
  constexpr Hertz kSlowest{10.0};
  if (format.rate < kSlowest) {
    text +=
        "doubt        too slow for vibration: is the first column no time in seconds? --time-unit or --rate says so\n";
  }
  for (std::size_t c = 0; c < format.channels.size(); ++c) text += channelLine(c, format.channels[c]);
  if (format.started_ns > 0 && !description.session) text += "recorded     " + utcText(format.started_ns) + "\n";
  for (const std::string& skipped : format.skipped) text += "no channel   " + skipped + "\n";
  for (const Message& note : format.notes) text += "note         " + stillcut::text(note) + "\n";
  if (description.session) text += sessionText(description.path, format, *description.session);
  return text;
}

std::string toJson(const RecordingDescription& description) {
  const RecordingFormat& format = description.format;
  nlohmann::ordered_json json{{"schema", kJsonSchema}, {"command", "info"}, {"type", "answer"}};
  json["file"] = description.path;
  json["format"] = format.kind;
  json["rate_hz"] = format.rate.value;
  json["frames"] = format.frames;
  json["length_s"] = lengthOf(description).value;
  json["started_utc_ms"] =
      format.started_ns > 0 ? nlohmann::ordered_json(format.started_ns / 1'000'000) : nlohmann::ordered_json();
  json["channels"] = nlohmann::ordered_json::array();
  for (const RecordedChannel& channel : format.channels) {
    json["channels"].push_back({{"name", channel.info.name},
                                {"quantity", name(channel.info.quantity)},
                                {"quantity_known", channel.quantityKnown},
                                {"unit", channel.unit},
                                {"scale", channel.info.scale},
                                {"axis", channel.info.axis},
                                {"sensitivity_mv", known(channel.info.sensitivity)},
                                {"volts", known(channel.info.volts)},
                                {"coupling", channel.info.coupling},
                                {"place", channel.info.place}});
  }
  json["skipped"] = format.skipped;
  json["notes"] = nlohmann::json::array();
  for (const Message& note : format.notes) json["notes"].push_back(stillcut::text(note));
  if (description.session) json["session"] = sessionJson(format, *description.session);
  // A file may hold bytes that are no UTF-8 in a name: shown as a replacement sign, never an exception.
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace stillcut::record
