// The markers of a session: set during the cut by the writer, and afterwards by whoever replays it.
// Thread: set-up; not real-time (file access). Adding and removing takes the file for itself: an error while it is
// still being recorded. The file goes from one state to the next as a whole, through its journal, whatever happens
// meanwhile; nothing but the markers' table changes. Who does the work, see session_reader.h.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/model/marker.h"
#include "core/session/file/session_rows.h"

namespace stillcut::record {

// In the order of their time.
Result<std::vector<Marker>> readMarkers(const std::string& session);
// Gives the number it has now. made_ns 0: now.
Result<std::uint64_t> addMarker(const std::string& session, Marker marker);
// Replaces the marker of this number.
Status changeMarker(const std::string& session, const Marker& marker);
Status removeMarker(const std::string& session, std::uint64_t number);

namespace here {

Result<std::vector<Marker>> readMarkers(const std::string& session);
Result<std::uint64_t> addMarker(const std::string& session, Marker marker);
Status changeMarker(const std::string& session, const Marker& marker);
Status removeMarker(const std::string& session, std::uint64_t number);

}  // namespace here

// An error where a text is too long for the file, or the span ends before it begins.
Result<MarkerRow> toRow(const Marker& marker);
Marker fromRow(const MarkerRow& row);
// Now, in ns since 1970 UTC.
std::int64_t nowUtc();

}  // namespace stillcut::record
