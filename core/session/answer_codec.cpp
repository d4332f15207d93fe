#include "core/session/answer_codec.h"

#include <cstring>
#include <stdexcept>
#include <type_traits>

namespace stillcut::record::codec {
namespace {

// As memory has it.
template <class T>
Json bytesOf(const std::vector<T>& values) {
  static_assert(std::is_trivially_copyable_v<T>);
  std::vector<std::uint8_t> bytes(values.size() * sizeof(T));
  if (!bytes.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  return Json::binary(std::move(bytes));
}

template <class T>
std::vector<T> valuesFrom(const Json& all) {
  static_assert(std::is_trivially_copyable_v<T>);
  const auto& bytes = all.get_binary();
  if (bytes.size() % sizeof(T) != 0) throw std::runtime_error("half a value");
  std::vector<T> values(bytes.size() / sizeof(T));
  if (!bytes.empty()) std::memcpy(static_cast<void*>(values.data()), bytes.data(), bytes.size());
  return values;
}

}  // namespace

Json pack(const Marker& m) {
  return {{"number", m.number}, {"begin", toNs(m.begin)}, {"end", toNs(m.end)},  {"label", m.label},
          {"author", m.author}, {"note", m.note},         {"made_ns", m.made_ns}};
}

Marker markerFrom(const Json& all) {
  return {all.at("number").get<std::uint64_t>(),
          instantFromNs(all.at("begin").get<std::int64_t>()),
          instantFromNs(all.at("end").get<std::int64_t>()),
          all.at("label").get<std::string>(),
          all.at("author").get<std::string>(),
          all.at("note").get<std::string>(),
          all.at("made_ns").get<std::int64_t>()};
}

Json pack(const std::vector<Marker>& markers) {
  Json all = Json::array();
  for (const Marker& marker : markers) all.push_back(pack(marker));
  return all;
}

std::vector<Marker> markersFrom(const Json& all) {
  std::vector<Marker> markers;
  for (const Json& one : all) markers.push_back(markerFrom(one));
  return markers;
}

Json pack(const SessionCounts& c) {
  Json truth = Json::array();
  for (const auto& [name, value] : c.truthValues) truth.push_back({name, value});
  return {{"steps", c.steps},
          {"gaps", c.gaps},
          {"inputs", c.inputs},
          {"verdicts", c.verdicts},
          {"commands", c.commands},
          {"events", c.events},
          {"begin", toNs(c.begin)},
          {"end", toNs(c.end)},
          {"markers", pack(c.markers)},
          {"truth", truth},
          {"first", bytesOf(c.firstEvents)}};
}

SessionCounts countsFrom(const Json& all) {
  SessionCounts c;
  c.steps = all.at("steps").get<std::uint64_t>();
  c.gaps = all.at("gaps").get<std::uint64_t>();
  c.inputs = all.at("inputs").get<std::uint64_t>();
  c.verdicts = all.at("verdicts").get<std::uint64_t>();
  c.commands = all.at("commands").get<std::uint64_t>();
  c.events = all.at("events").get<std::uint64_t>();
  c.begin = instantFromNs(all.at("begin").get<std::int64_t>());
  c.end = instantFromNs(all.at("end").get<std::int64_t>());
  c.markers = markersFrom(all.at("markers"));
  for (const Json& one : all.at("truth"))
    c.truthValues.emplace_back(one.at(0).get<std::string>(), one.at(1).get<double>());
  c.firstEvents = valuesFrom<Event>(all.at("first"));
  return c;
}

Json pack(const std::vector<RecordedTruthSample>& series) {
  Json all = Json::array();
  for (const RecordedTruthSample& s : series) all.push_back({s.name, toNs(s.time), s.value});
  return all;
}

std::vector<RecordedTruthSample> seriesFrom(const Json& all) {
  std::vector<RecordedTruthSample> series;
  for (const Json& one : all) {
    series.push_back(
        {one.at(0).get<std::string>(), instantFromNs(one.at(1).get<std::int64_t>()), one.at(2).get<double>()});
  }
  return series;
}

Json pack(const SessionGlance& glance) {
  return {{"length", glance.length.value}, {"markers", glance.markers},       {"featuresOnly", glance.featuresOnly},
          {"alarms", glance.alarms},       {"alarmed", glance.alarmed.value}, {"started", glance.started_ns}};
}

SessionGlance glanceFrom(const Json& all) {
  return {Seconds(all.at("length").get<double>()),  all.at("markers").get<int>(),
          all.at("featuresOnly").get<bool>(),       all.at("alarms").get<int>(),
          Seconds(all.at("alarmed").get<double>()), all.at("started").get<std::int64_t>()};
}

Json pack(const SessionSketch& sketch) {
  return {{"begin", toNs(sketch.begin)}, {"end", toNs(sketch.end)}, {"columns", bytesOf(sketch.columns)}};
}

SessionSketch sketchFrom(const Json& all) {
  return {instantFromNs(all.at("begin").get<std::int64_t>()), instantFromNs(all.at("end").get<std::int64_t>()),
          valuesFrom<MinMax>(all.at("columns"))};
}

}  // namespace stillcut::record::codec
