#include "core/session/marker_span.h"

#include <algorithm>
#include <set>

#include "core/session/file/session_markers.h"
#include "core/session/open_recording.h"

namespace stillcut::record {
namespace {

Result<Instant> firstSample(const std::string& session) {
  auto reader = openRecording(session);
  if (!reader) return reader.error();
  SampleBlock block;
  const RecordingFormat& format = (*reader)->format();
  if (!format.setup) return Error{session, message("is no session"), message("only sessions have markers")};
  block.allocate(static_cast<int>(format.channels.size()), std::max(1, format.blockFrames));
  const Result<bool> more = (*reader)->read(block);
  if (!more) return more.error();
  if (!*more) return Error{session, message("holds no samples")};
  return block.firstSample;
}

Message known(const std::vector<Marker>& markers) {
  std::set<std::string> labels;
  for (const Marker& m : markers) labels.insert(m.label);
  std::string all;
  for (const std::string& label : labels) all += (all.empty() ? "" : ", ") + label;
  return all.empty() ? message("it has no markers") : message("there are: %1", all);
}

}  // namespace

Result<TimeSpan> markerSpan(const std::string& session, const std::string& name) {
  const Result<Instant> first = firstSample(session);
  if (!first) return first.error();
  const Result<std::vector<Marker>> markers = readMarkers(session);
  if (!markers) return markers.error();
  const auto found = std::find_if(markers->begin(), markers->end(), [&name](const Marker& m) {
    return m.label == name || m.note == name || "#" + std::to_string(m.number) == name;
  });
  if (found == markers->end()) return Error{session, message("has no marker '%1'", name), known(*markers)};
  double from = secondsBetween(*first, found->begin).value;
  double to = secondsBetween(*first, found->end).value;
  if (found->end <= found->begin) {
    from -= kAroundMoment.value;
    to = from + 2.0 * kAroundMoment.value;
  }
  return TimeSpan{Seconds(std::max(0.0, from)), Seconds(to)};
}

}  // namespace stillcut::record
