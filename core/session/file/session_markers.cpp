#include "core/session/file/session_markers.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <map>

#include "core/session/file/marker_rows.h"
#include "core/session/file/session_layout.h"
#include "core/session/file/session_open.h"
#include "core/session/file/session_table.h"
#include "core/storage/journal.h"
#include "core/storage/journaled_driver.h"

namespace stillcut::record {
namespace {

template <std::size_t N>
bool store(const std::string& text, std::array<char, N>& out) {
  if (text.size() >= N || text.find('\0') != std::string::npos) return false;
  std::copy(text.begin(), text.end(), out.begin());
  return true;
}

template <std::size_t N>
std::string textOf(const std::array<char, N>& text) {
  return {text.data(), strnlen(text.data(), N)};
}

// Calls `make` with what there is; the row it gives is appended, and the file is whole before and after.
template <class Make>
Status appendRow(const std::string& path, Make make) {
  {  // a session that was cut off is made whole first
    const Result<OpenedSession> opened = openSessionFile(path);
    if (!opened) return opened.error();
  }
  std::error_code unknown;
  if (std::filesystem::exists(journalPath(path), unknown)) {
    return Error{path, message("cannot be marked: the journal beside it belongs to another recording, or is in use"),
                 message("move %1 away", journalPath(path))};
  }
  Result<std::unique_ptr<JournaledFile>> journaled = JournaledFile::open(path, JournaledFile::Access::Write);
  if (!journaled) return journaled.error();
  Hdf5Id file(H5Fopen(path.c_str(), H5F_ACC_RDWR, journaledAccess(**journaled).get()));
  Status outcome = Done{};
  {
    Result<std::map<std::uint64_t, MarkerRow>> rows =
        file ? readMarkerRows(file.get(), path)
             : Error{path, message("the session file cannot be opened"), hdf5Cause()};
    Result<MarkerRow> row = rows ? make(*rows) : Result<MarkerRow>(rows.error());
    SessionTable table;
    if (!row) {
      outcome = row.error();
    } else if (!table.open(file.get(), kMarkersPath, columnsOf<MarkerRow>(), sizeof(MarkerRow)) ||
               !table.append(&*row, 1)) {
      outcome = Error{path, message("the marker cannot be written"), hdf5Cause()};
    }
  }
  if (!outcome) (*journaled)->abandon();
  if (!file.reset() && outcome) outcome = Error{path, message("the marker cannot be written"), hdf5Cause()};
  if (outcome) outcome = (*journaled)->commit(true);
  if (outcome) (*journaled)->removeJournal();
  return outcome;
}

}  // namespace

Result<std::map<std::uint64_t, MarkerRow>> readMarkerRows(hid_t file, const std::string& path) {
  std::map<std::uint64_t, MarkerRow> rows;
  if (H5Lexists(file, kMarkersPath, H5P_DEFAULT) <= 0) return rows;
  TableReader<MarkerRow> table;
  if (!table.open(file, kMarkersPath)) return Error{path, message("the markers cannot be read"), hdf5Cause()};
  bool damaged = false;
  for (std::uint64_t i = 0; const MarkerRow* row = table.at(i, damaged); ++i) rows[row->number] = *row;
  if (damaged) return Error{path, message("the markers cannot be read"), hdf5Cause()};
  return rows;
}

Result<MarkerRow> toRow(const Marker& marker) {
  MarkerRow row;
  row.number = marker.number;
  row.begin = toNs(marker.begin);
  row.end = toNs(marker.end);
  row.made = marker.made_ns;
  if (marker.label.empty()) return Error{message("marker"), message("needs a label")};
  if (marker.end < marker.begin) return Error{"marker '" + marker.label + "'", message("ends before it begins")};
  if (!store(marker.label, row.label) || !store(marker.author, row.author) || !store(marker.note, row.note)) {
    return Error{"marker '" + marker.label.substr(0, kMarkerLabelSize) + "'",
                 message("label, author or note is too long"), message("at most 31, 63 and 511 bytes")};
  }
  return row;
}

Marker fromRow(const MarkerRow& row) {
  return {row.number,        instantFromNs(row.begin), instantFromNs(row.end),
          textOf(row.label), textOf(row.author),       textOf(row.note),
          row.made};
}

std::int64_t nowUtc() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::system_clock::now().time_since_epoch())
      .count();
}

Result<std::vector<Marker>> here::readMarkers(const std::string& session) {
  const Result<OpenedSession> opened = openSessionFile(session);
  if (!opened) return opened.error();
  const Result<std::map<std::uint64_t, MarkerRow>> rows = readMarkerRows(opened.value().file.get(), session);
  if (!rows) return rows.error();
  std::vector<Marker> markers;
  for (const auto& [number, row] : rows.value()) {
    if (row.removed == 0) markers.push_back(fromRow(row));
  }
  std::stable_sort(markers.begin(), markers.end(), [](const Marker& a, const Marker& b) { return a.begin < b.begin; });
  return markers;
}

Result<std::uint64_t> here::addMarker(const std::string& session, Marker marker) {
  const Status added = appendRow(session, [&](const auto& rows) {
    marker.number = rows.empty() ? 0 : rows.rbegin()->first + 1;
    if (marker.made_ns == 0) marker.made_ns = nowUtc();
    return toRow(marker);
  });
  if (!added) return added.error();
  return marker.number;
}

Status here::changeMarker(const std::string& session, const Marker& marker) {
  return appendRow(session, [&](const auto& rows) -> Result<MarkerRow> {
    const auto found = rows.find(marker.number);
    if (found == rows.end() || found->second.removed != 0) {
      return Error{session, message("has no marker %1", std::to_string(marker.number))};
    }
    return toRow(marker);
  });
}

Status here::removeMarker(const std::string& session, std::uint64_t number) {
  return appendRow(session, [&](const auto& rows) -> Result<MarkerRow> {
    const auto found = rows.find(number);
    if (found == rows.end() || found->second.removed != 0) {
      return Error{session, message("has no marker %1", std::to_string(number))};
    }
    MarkerRow row = found->second;
    row.removed = 1;
    return row;
  });
}

}  // namespace stillcut::record
