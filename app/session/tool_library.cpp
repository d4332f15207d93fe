#include "app/session/tool_library.h"

#include <filesystem>

#include "core/config/toml_reader.h"
#include "core/config/toml_writer.h"
#include "core/milling/identify/modal_measurement.h"
#include "core/milling/identify/model_files.h"
#include "core/milling/stability/lobe_case.h"
#include "core/session/open_recording.h"

namespace stillcut::app {
namespace {

constexpr int kVersion = 1;
constexpr int kMostTeeth = 64;

void optional(config::TomlWriter& out, std::string_view key, const QString& value) {
  if (!value.isEmpty()) out.text(key, value.toStdString());
}

QString read(const config::TomlTable& table, std::string_view key) {
  return QString::fromStdString(table.textOr(key, ""));
}

}  // namespace

Result<std::vector<ui::ToolEntry>> loadTools(const std::string& path) {
  std::vector<ui::ToolEntry> tools;
  if (!std::filesystem::exists(path)) return tools;
  const config::TomlReader in = config::TomlReader::file(path);
  if (const auto unreadable = in.error()) return *unreadable;
  (void)in.root().integer("version", kVersion, kVersion);
  for (const config::TomlTable& table : in.root().tablesOr("tool")) {
    ui::ToolEntry tool;
    tool.name = QString::fromStdString(table.text("name"));
    tool.holder = read(table, "holder");
    tool.teeth = table.integer("teeth", 1, kMostTeeth);
    tool.diameter_mm = table.number("diameter_mm", 0.05, 1000.0);
    tool.pitch = read(table, "pitch");
    tool.modes = read(table, "modes");
    tool.highestSpeed_rpm = table.numberOr("highest_speed_rpm", 0.0, 0.0, 200000.0);
    tool.lowestSpeed_rpm = table.numberOr("lowest_speed_rpm", 0.0, 0.0, 200000.0);
    tool.stickOut_mm = table.numberOr("stick_out_mm", 0.0, 0.0, 10000.0);
    tool.deepest_mm = table.numberOr("deepest_mm", 0.0, 0.0, 1000.0);
    tool.material = read(table, "material");
    tool.response = read(table, "response");
    tool.notes = read(table, "notes");
    for (const config::TomlTable& note : table.tablesOr("chattered")) {
      tool.chattered.push_back({note.numberOr("speed_rpm", 0.0, 0.0, 200000.0),
                                note.numberOr("depth_mm", 0.0, 0.0, 1000.0),
                                note.numberOr("frequency_hz", 0.0, 0.0, 100000.0), read(note, "note")});
    }
    for (const config::TomlTable& event : table.tablesOr("history")) {
      tool.history.push_back({read(event, "day"), read(event, "what")});
    }
    tools.push_back(std::move(tool));
  }
  if (const Status finished = in.finish(); !finished) return finished.error();
  return tools;
}

Status saveTools(const std::vector<ui::ToolEntry>& tools, const std::string& path) {
  config::TomlWriter out;
  out.comment("The tools of this shop; the Set up page writes this file.");
  out.integer("version", kVersion);
  for (const ui::ToolEntry& tool : tools) {
    out.arrayElement("tool");
    out.text("name", tool.name.toStdString());
    optional(out, "holder", tool.holder);
    out.integer("teeth", tool.teeth);
    out.number("diameter_mm", tool.diameter_mm);
    optional(out, "pitch", tool.pitch);
    optional(out, "modes", tool.modes);
    if (tool.highestSpeed_rpm > 0.0) out.number("highest_speed_rpm", tool.highestSpeed_rpm);
    if (tool.lowestSpeed_rpm > 0.0) out.number("lowest_speed_rpm", tool.lowestSpeed_rpm);
    if (tool.stickOut_mm > 0.0) out.number("stick_out_mm", tool.stickOut_mm);
    if (tool.deepest_mm > 0.0) out.number("deepest_mm", tool.deepest_mm);
    optional(out, "material", tool.material);
    optional(out, "response", tool.response);
    optional(out, "notes", tool.notes);
    for (const ui::ChatterNote& note : tool.chattered) {
      out.arrayElement("tool.chattered");
      if (note.speed_rpm > 0.0) out.number("speed_rpm", note.speed_rpm);
      if (note.depth_mm > 0.0) out.number("depth_mm", note.depth_mm);
      if (note.frequency_hz > 0.0) out.number("frequency_hz", note.frequency_hz);
      optional(out, "note", note.note);
    }
    for (const ui::ToolEvent& event : tool.history) {
      out.arrayElement("tool.history");
      out.text("day", event.day.toStdString());
      out.text("what", event.what.toStdString());
    }
  }
  std::error_code problem;
  std::filesystem::create_directories(std::filesystem::path(path).parent_path(), problem);
  return out.save(path);
}

Status checkModesFile(const std::string& path) {
  const auto cut = milling::loadLobeCase(path);
  if (cut) return Done{};
  const auto modes = identify::loadModes(path);
  if (modes) return Done{};
  // Of a whole cut its own fault is told, of anything else that it holds no modes.
  const bool whole =
      path.ends_with(".json") || (std::filesystem::exists(path) && config::TomlReader::file(path).root().has("tool"));
  return whole ? cut.error() : modes.error();
}

Status checkResponseFile(const std::string& path) {
  identify::ModalRequest request;
  request.import.open = [](const std::string& file, const record::ReadOptions& options) {
    return record::openRecording(file, options);
  };
  const auto measured = identify::measureResponses({path}, request);
  if (!measured) return measured.error();
  return Done{};
}

}  // namespace stillcut::app
