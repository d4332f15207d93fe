// What is asked of a session file, answered by a process of its own: a damaged file ends that one and is an error here.
#include <utility>

#include "core/formats/hdf5/isolated_process.h"
#include "core/session/answer_codec.h"
#include "core/session/file/session_markers.h"
#include "core/session/file/session_reader.h"
#include "core/session/session_folder.h"
#include "core/session/session_glance.h"
#include "core/session/session_kind.h"

namespace stillcut::record {
namespace {

using codec::Json;

// Of processor time. Each is many times what the longest sound session needs.
constexpr Seconds kGlance{0.1};  // while a list waits
constexpr Seconds kQuick{2.0};   // what does not go through all rows
constexpr Seconds kWhole{20.0};

Result<Json> ask(const std::string& path, const char* what, Seconds patience, const Json& arguments = {}) {
  IsolatedProcess process;
  const std::string words = arguments.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (const Status started = process.start(path, "", apart::toJson(apart::Ask{what, words, patience})); !started)
    return started.error();
  const auto heard = process.hear();
  if (!heard) return heard.error();
  if (heard->first == apart::MessageType::Refused) return apart::errorFrom(heard->second);
  if (heard->first != apart::MessageType::Answer) return process.died();
  try {
    return Json::from_cbor(heard->second);
  } catch (const Json::exception&) {
    return process.died();
  }
}

template <class T>
Result<T> unpacked(const Result<Json>& answer, T (*unpack)(const Json&), const std::string& path) {
  if (!answer) return answer.error();
  try {
    return unpack(*answer);
  } catch (const std::exception&) {
    return Error{path, message("the HDF5 library cannot read it"), message("a damaged file")};
  }
}

Status done(const Result<Json>& answer) {
  if (!answer) return answer.error();
  return Done{};
}

}  // namespace

std::optional<SessionGlance> glanceAtSession(const std::string& path) {
  const auto glance = unpacked(ask(path, "glance", kGlance), codec::glanceFrom, path);
  return glance ? std::optional(*glance) : std::nullopt;
}

Result<SessionSketch> sketchSession(const std::string& path, int columns) {
  return unpacked(ask(path, "sketch", kQuick, columns), codec::sketchFrom, path);
}

Result<std::vector<Marker>> readMarkers(const std::string& session) {
  return unpacked(ask(session, "markers", kQuick), codec::markersFrom, session);
}

Result<std::uint64_t> addMarker(const std::string& session, Marker marker) {
  return unpacked<std::uint64_t>(
      ask(session, "add marker", kWhole, codec::pack(marker)),
      [](const Json& number) { return number.get<std::uint64_t>(); }, session);
}

Status changeMarker(const std::string& session, const Marker& marker) {
  return done(ask(session, "change marker", kWhole, codec::pack(marker)));
}

Status removeMarker(const std::string& session, std::uint64_t number) {
  return done(ask(session, "remove marker", kWhole, number));
}

Result<SessionCounts> countSession(const std::string& path) {
  return unpacked(ask(path, "counts", kWhole), codec::countsFrom, path);
}

Result<std::vector<RecordedTruthSample>> readTruthSeries(const std::string& path) {
  return unpacked(ask(path, "truth", kWhole), codec::seriesFrom, path);
}

Result<bool> repairSession(const std::string& path) {
  return unpacked<bool>(
      ask(path, "repair", kWhole), [](const Json& repaired) { return repaired.get<bool>(); }, path);
}

std::string kindOfHdf5(const std::string& path) {
  const auto kind = unpacked<std::string>(
      ask(path, "kind", kQuick), [](const Json& word) { return word.get<std::string>(); }, path);
  return kind ? *kind : "damaged";
}

}  // namespace stillcut::record
