#include "core/session/isolated_answers.h"

#include <array>
#include <string_view>
#include <utility>

#include "core/session/answer_codec.h"
#include "core/session/file/marker_rows.h"
#include "core/session/file/session_layout.h"
#include "core/session/file/session_markers.h"
#include "core/session/file/session_open.h"
#include "core/session/session_overview.h"

namespace stillcut::record {
namespace {

using codec::Json;

std::string cbor(const Json& json) {
  std::string bytes;
  Json::to_cbor(json, bytes);
  return bytes;
}

template <class T>
Result<std::string> packed(const Result<T>& result) {
  if (!result) return result.error();
  return cbor(codec::pack(result.value()));
}

Result<std::string> glance(const std::string& path, const Json& /*arguments*/) {
  const auto seen = here::glanceAtSession(path);
  if (!seen) return Error{path, message("is no session that can be looked into")};
  return cbor(codec::pack(*seen));
}

Result<std::string> markers(const std::string& path, const Json& /*arguments*/) {
  return packed(here::readMarkers(path));
}

Result<std::string> counts(const std::string& path, const Json& /*arguments*/) {
  return packed(here::countSession(path));
}

Result<std::string> truth(const std::string& path, const Json& /*arguments*/) {
  return packed(here::readTruthSeries(path));
}

Result<std::string> repair(const std::string& path, const Json& /*arguments*/) {
  const auto repaired = here::repairSession(path);
  if (!repaired) return repaired.error();
  return cbor(*repaired);
}

Result<std::string> addMarker(const std::string& path, const Json& arguments) {
  const auto number = here::addMarker(path, codec::markerFrom(arguments));
  if (!number) return number.error();
  return cbor(*number);
}

Result<std::string> changeMarker(const std::string& path, const Json& arguments) {
  const Status changed = here::changeMarker(path, codec::markerFrom(arguments));
  if (!changed) return changed.error();
  return cbor(true);
}

Result<std::string> removeMarker(const std::string& path, const Json& arguments) {
  const Status removed = here::removeMarker(path, arguments.get<std::uint64_t>());
  if (!removed) return removed.error();
  return cbor(true);
}

Result<std::string> sketch(const std::string& path, const Json& arguments) {
  const auto overview = SessionOverview::open(path);
  if (!overview) return overview.error();
  SessionSketch made{(*overview)->begin(), (*overview)->end(), {}};
  const int columns = arguments.get<int>();
  if (columns > 0 && made.end > made.begin) {
    auto drawn = (*overview)->overview(0, made.begin, made.end, columns);
    if (!drawn) return drawn.error();
    made.columns = std::move(drawn).value();
  }
  return cbor(codec::pack(made));
}

// "damaged", "other", "session", or "simulated": one without markers that can be run again.
Result<std::string> kind(const std::string& path, const Json& /*arguments*/) {
  const Result<OpenedSession> opened = openSessionFile(path, Repair::No);
  if (!opened) return cbor("damaged");
  const hid_t file = opened->file.get();
  if (readText(file, "format") != kSessionFormat) return cbor("other");
  if (readInteger(file, "simulated").value_or(0) == 0) return cbor("session");
  const auto marked = readMarkerRows(file, path);
  return cbor(marked && marked->empty() ? "simulated" : "session");
}

struct Answerer {
  std::string_view what;
  Result<std::string> (*answer)(const std::string& path, const Json& arguments);
};
constexpr std::array<Answerer, 10> kAnswers{{{"glance", glance},
                                             {"markers", markers},
                                             {"counts", counts},
                                             {"truth", truth},
                                             {"repair", repair},
                                             {"add marker", addMarker},
                                             {"change marker", changeMarker},
                                             {"remove marker", removeMarker},
                                             {"sketch", sketch},
                                             {"kind", kind}}};

}  // namespace

Result<std::string> answerTo(const std::string& path, const std::string& what, const std::string& arguments) {
  for (const Answerer& known : kAnswers) {
    if (known.what == what) return known.answer(path, arguments.empty() ? Json() : Json::parse(arguments));
  }
  return Error{path, message("cannot be tried"), message("'%1' is no question to a session", what)};
}

}  // namespace stillcut::record
