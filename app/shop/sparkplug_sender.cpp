#include "app/shop/sparkplug_sender.h"

#include <array>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <utility>

namespace stillcut::shop {
namespace {

using nlohmann::json;
using sparkplug::DataType;
using sparkplug::Metric;
using sparkplug::Payload;

// Every metric: its name, the topic and field that it comes from, its type. An alias is the place in this table, from
// 1; new ones come last. A field "" is the whole message as JSON.
struct Row {
  const char* name;
  const char* topic;
  const char* field;
  DataType type;
};
constexpr std::array kRows{
    Row{"Meta/machine", "meta", "machine", DataType::String},
    Row{"Meta/tool", "meta", "tool", DataType::String},
    Row{"Meta/job", "meta", "job", DataType::String},
    Row{"Meta/version", "meta", "version", DataType::String},
    Row{"Meta/profile_hash", "meta", "profile_hash", DataType::String},
    Row{"State/state", "state", "state", DataType::String},
    Row{"State/reason", "state", "reason", DataType::String},
    Row{"State/mode", "state", "mode", DataType::String},
    Row{"State/kind", "state", "kind", DataType::String},
    Row{"State/frequency_hz", "state", "frequency_hz", DataType::Double},
    Row{"State/speed_rpm", "state", "speed_rpm", DataType::Double},
    Row{"Features/in_cut_s", "features", "in_cut_s", DataType::Double},
    Row{"Features/judged_s", "features", "judged_s", DataType::Double},
    Row{"Features/energy_ratio", "features", "energy_ratio", DataType::Double},
    Row{"Features/rms", "features", "rms", DataType::Double},
    Row{"Features/programmed_rpm", "features", "programmed_rpm", DataType::Double},
    Row{"Features/actual_rpm", "features", "actual_rpm", DataType::Double},
    Row{"Features/programmed_feed_mm_min", "features", "programmed_feed_mm_min", DataType::Double},
    Row{"Features/actual_feed_mm_min", "features", "actual_feed_mm_min", DataType::Double},
    Row{"Features/speed_override_percent", "features", "speed_override_percent", DataType::Double},
    Row{"Features/feed_override_percent", "features", "feed_override_percent", DataType::Double},
    Row{"Features/chatter_s", "features", "chatter_s", DataType::Double},
    Row{"Features/chatter_mm", "features", "chatter_mm", DataType::Double},
    Row{"Features/dropped_blocks", "features", "dropped_blocks", DataType::Double},
    Row{"Features/latency_ms", "features", "latency_ms", DataType::Double},
    Row{"Event/alarm", "event/alarm", "", DataType::String},
    Row{"Event/intervention", "event/intervention", "", DataType::String},
    Row{"Event/advice", "event/advice", "", DataType::String},
    Row{"Event/marker", "event/marker", "", DataType::String},
    Row{"Event/fault", "event/fault", "", DataType::String},
    Row{"Event/warning", "event/warning", "", DataType::String},
    Row{"Event/note", "event/note", "", DataType::String},
    Row{"Event/end", "event/end", "", DataType::String},
};
// Behind the table: of every message.
constexpr std::uint64_t kSequenceAlias = 1000, kSeriesAlias = 1001;

Metric counter(const char* name, std::uint64_t alias, std::uint64_t value, std::int64_t utcMs) {
  Metric m;
  m.name = name;
  m.alias = alias;
  m.hasAlias = true;
  m.type = DataType::UInt64;
  m.utcMs = utcMs;
  m.value = value;
  return m;
}

}  // namespace

Result<std::unique_ptr<SparkplugSender>> SparkplugSender::make(const BrokerOptions& options, const std::string& node,
                                                               std::string root, Outbox& outbox) {
  const auto slash = node.find('/');
  const bool two = slash != std::string::npos && slash > 0 && slash + 1 < node.size() &&
                   node.find('/', slash + 1) == std::string::npos && node.find_first_of("+#") == std::string::npos;
  if (!two) return Error{node, message("is no edge node"), message("GROUP/NODE, without + and #")};
  return std::unique_ptr<SparkplugSender>(
      new SparkplugSender(options, node.substr(0, slash), node.substr(slash + 1), std::move(root), outbox));
}

SparkplugSender::SparkplugSender(const BrokerOptions& options, std::string group, std::string node, std::string root,
                                 Outbox& outbox)
    : client_(options, *this),
      group_(std::move(group)),
      node_(std::move(node)),
      root_(std::move(root)),
      outbox_(outbox),
      births_(std::strtoull(outbox.note("births").c_str(), nullptr, 10)) {
  recall();
}

std::string SparkplugSender::topic(const char* type) const {
  return "spBv1.0/" + group_ + "/" + type + "/" + node_;
}

std::string SparkplugSender::death() const {
  Metric bdSeq;
  bdSeq.name = "bdSeq";
  bdSeq.type = DataType::UInt64;
  bdSeq.utcMs = utcNowMs();
  bdSeq.value = births_;
  return encode(Payload{utcNowMs(), -1, {bdSeq}});
}

void SparkplugSender::connecting() {
  births_ = (births_ + 1) % 256;
  outbox_.begin();
  outbox_.setNote("births", std::to_string(births_));
  kept_ = outbox_.commit();
  client_.setWill(topic("NDEATH"), death(), 1, false);
}

void SparkplugSender::connected(bool /*kept*/) {
  client_.subscribe(topic("NCMD"));
  bear_ = true;
}

void SparkplugSender::disconnected() {
  // What was under way may or may not have arrived: it goes once more.
  if (!batch_.empty()) newest_ = batch_.front() - 1;
  batch_.clear();
  barrier_.reset();
}

void SparkplugSender::received(std::string_view where, std::string_view payload) {
  if (where == topic("NCMD") && sparkplug::asksForRebirth(payload)) bear_ = true;
}

void SparkplugSender::bear() {
  bornUtcMs_ = utcNowMs();
  sequence_ = 0;
  Payload birth{bornUtcMs_, sequence_, {}};
  Metric bdSeq;
  bdSeq.name = "bdSeq";
  bdSeq.type = DataType::UInt64;
  bdSeq.utcMs = bornUtcMs_;
  bdSeq.value = births_;
  Metric rebirth;
  rebirth.name = sparkplug::kRebirth;
  rebirth.type = DataType::Boolean;
  rebirth.utcMs = bornUtcMs_;
  rebirth.value = false;
  birth.metrics = {bdSeq, rebirth};
  for (std::size_t k = 0; k < kRows.size(); ++k) {
    const auto known = known_.find(kRows[k].name);
    Metric m = known != known_.end() ? known->second : Metric{};
    m.name = kRows[k].name;
    m.alias = k + 1;
    m.hasAlias = true;
    m.type = kRows[k].type;
    m.historical = false;
    if (known == known_.end()) m.utcMs = bornUtcMs_;
    birth.metrics.push_back(std::move(m));
  }
  birth.metrics.push_back(counter("Stillcut/sequence", kSequenceAlias, newest_, bornUtcMs_));
  birth.metrics.push_back(
      counter("Stillcut/series", kSeriesAlias, static_cast<std::uint64_t>(outbox_.series()), bornUtcMs_));
  client_.publish(topic("NBIRTH"), encode(birth), 0, false);
}

// One metric of a message, under its alias.
Metric SparkplugSender::metricOf(std::size_t row, const json& message, const std::string& payload) const {
  Metric m;
  m.alias = row + 1;
  m.hasAlias = true;
  m.type = kRows[row].type;
  m.utcMs = message.is_object() ? message.value("utc_ms", std::int64_t{0}) : 0;
  m.historical = m.utcMs < bornUtcMs_ - 1000;
  const auto field = message.find(kRows[row].field);
  if (*kRows[row].field == '\0') {
    m.value = payload;
  } else if (field != message.end() && field->is_string()) {
    m.value = field->get<std::string>();
  } else if (field != message.end() && field->is_number()) {
    m.value = field->get<double>();
  }
  return m;
}

// A birth certificate tells every metric, also what was told before this program began again.
void SparkplugSender::recall() {
  for (std::size_t k = 0; k < kRows.size(); ++k) {
    const std::string payload = outbox_.newestOf(kRows[k].topic);
    if (!payload.empty()) known_[kRows[k].name] = metricOf(k, json::parse(payload, nullptr, false), payload);
  }
}

Payload SparkplugSender::dataOf(const Outbox::Kept& kept) {
  const json message = json::parse(kept.payload, nullptr, false);
  const std::int64_t utcMs = message.is_object() ? message.value("utc_ms", std::int64_t{0}) : 0;
  sequence_ = (sequence_ + 1) % 256;
  Payload data{utcNowMs(), sequence_, {}};
  for (std::size_t k = 0; k < kRows.size(); ++k) {
    if (kept.topic != kRows[k].topic) continue;
    data.metrics.push_back(known_[kRows[k].name] = metricOf(k, message, kept.payload));
  }
  Metric number = counter("", kSequenceAlias, kept.sequence, utcMs);
  number.historical = utcMs < bornUtcMs_ - 1000;
  data.metrics.push_back(std::move(number));
  return data;
}

void SparkplugSender::sendBatch() {
  const auto next = outbox_.after(newest_, kBatch);
  if (next.empty()) return;
  for (const Outbox::Kept& kept : next) {
    client_.publish(topic("NDATA"), encode(dataOf(kept)), 0, false);
    batch_.push_back(kept.sequence);
    newest_ = kept.sequence;
  }
  const json told{{"schema", kShopSchema}, {"utc_ms", utcNowMs()}, {"series", outbox_.series()}, {"sequence", newest_}};
  barrier_ = client_.publish(root_ + "/told", told.dump(), 1, false);
}

void SparkplugSender::delivered(int number) {
  if (number != barrier_) return;
  barrier_.reset();
  delivered_.insert(delivered_.end(), batch_.begin(), batch_.end());
  batch_.clear();
}

Status SparkplugSender::turn(std::int64_t nowMs) {
  client_.turn(nowMs);
  if (!kept_ || !client_.connected()) return kept_;
  if (std::exchange(bear_, false)) bear();
  if (!barrier_) sendBatch();
  return Done{};
}

void SparkplugSender::end() {
  if (!client_.connected()) return;
  client_.publish(topic("NDEATH"), death(), 1, false);
  client_.close();
}

}  // namespace stillcut::shop
