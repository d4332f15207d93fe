// How the answers of stillcut-reader cross from its process to ours. Both are of one build on one machine. Numbers stay
// as they are, not-a-number too. Plain values: any thread.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "core/model/marker.h"
#include "core/session/file/session_reader.h"
#include "core/session/session_glance.h"

namespace stillcut::record::codec {

using Json = nlohmann::json;

Json pack(const Marker& marker);
Json pack(const std::vector<Marker>& markers);
Json pack(const SessionCounts& counts);
Json pack(const std::vector<RecordedTruthSample>& series);
Json pack(const SessionGlance& glance);
Json pack(const SessionSketch& sketch);
// Throw on what the other end never sends.
Marker markerFrom(const Json& all);
std::vector<Marker> markersFrom(const Json& all);
SessionCounts countsFrom(const Json& all);
std::vector<RecordedTruthSample> seriesFrom(const Json& all);
SessionGlance glanceFrom(const Json& all);
SessionSketch sketchFrom(const Json& all);

}  // namespace stillcut::record::codec
