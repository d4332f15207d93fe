#include "core/session/session_glance.h"

#include <algorithm>
#include <filesystem>

#include "core/session/file/marker_rows.h"
#include "core/session/file/session_layout.h"
#include "core/session/file/session_open.h"
#include "core/session/file/session_table.h"
#include "core/storage/journal.h"

namespace stillcut::record {
namespace {

// From the events that every alarm leaves. One that was open at the end lasted until then. False: damaged.
bool readAlarms(TableReader<EventRow>& events, Instant end, SessionGlance& glance) {
  bool damaged = false;
  std::optional<Instant> open;
  for (std::uint64_t k = 0; const EventRow* row = events.at(k, damaged); ++k) {
    Event event;
    fromRow(*row, event);
    switch (event.reason.code) {
      case ReasonCode::ChatterBegan:
        ++glance.alarms;
        open = event.time;
        break;
      case ReasonCode::ChatterEnded:
      case ReasonCode::ChatterLeftCut:
        if (event.reason.n[0] > 0.0) glance.alarmed += Seconds(event.reason.n[0]);
        open.reset();
        break;
      default:
        break;
    }
  }
  if (open) glance.alarmed += std::max(Seconds(), secondsBetween(*open, end));
  return !damaged;
}

}  // namespace

std::optional<SessionGlance> here::glanceAtSession(const std::string& path) {
  // With its journal beside it the file is being written, or was cut off and wants a repair.
  std::error_code ignored;
  if (std::filesystem::exists(journalPath(path), ignored)) return std::nullopt;
  const Result<OpenedSession> opened = openSessionFile(path, Repair::No);
  if (!opened) return std::nullopt;
  const auto format = readSessionFormat(*opened, path);
  if (!format) return std::nullopt;
  const hid_t file = opened->file.get();
  TableReader<BlockRow> blocks;
  TableReader<EventRow> events;
  const auto markers = readMarkerRows(file, path);
  if (!blocks.open(file, kBlocksPath) || !events.open(file, kEventsPath) || !markers) return std::nullopt;
  SessionGlance glance;
  glance.started_ns = format->started_ns;
  glance.featuresOnly = readInteger(file, kFeaturesOnly).value_or(0) != 0;
  bool damaged = false;
  if (const BlockRow* first = blocks.at(0, damaged)) {
    const std::int64_t begin_ns = first->firstSample;
    const BlockRow* last = blocks.at(blocks.rows() - 1, damaged);
    if (last == nullptr || !(last->rate > 0.0)) return std::nullopt;
    glance.length = Seconds(static_cast<double>(last->firstSample - begin_ns) * 1e-9 + last->frames / last->rate);
    if (!readAlarms(events, instantFromNs(begin_ns) + toDuration(glance.length), glance)) return std::nullopt;
  }
  if (damaged) return std::nullopt;
  glance.markers = static_cast<int>(
      std::count_if(markers->begin(), markers->end(), [](const auto& row) { return row.second.removed == 0; }));
  return glance;
}

}  // namespace stillcut::record
