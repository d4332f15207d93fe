#include "app/shop/sparkplug_payload.h"

#include <bit>
#include <optional>

namespace stillcut::shop::sparkplug {
namespace {

// Protocol Buffers: each field begins with its number and how its bytes are to be taken.
enum Wire : std::uint32_t { kVarint = 0, kFixed64 = 1, kBytes = 2, kFixed32 = 5 };

void putVarint(std::string& out, std::uint64_t n) {
  for (; n >= 0x80U; n >>= 7U) out.push_back(static_cast<char>((n & 0x7FU) | 0x80U));
  out.push_back(static_cast<char>(n));
}
void putKey(std::string& out, std::uint32_t field, Wire wire) {
  putVarint(out, (field << 3U) | wire);
}
void putNumber(std::string& out, std::uint32_t field, std::uint64_t n) {
  putKey(out, field, kVarint);
  putVarint(out, n);
}
void putBytes(std::string& out, std::uint32_t field, std::string_view bytes) {
  putKey(out, field, kBytes);
  putVarint(out, bytes.size());
  out.append(bytes);
}

// Fields of the message Metric.
enum Field : std::uint32_t {
  kName = 1,
  kAlias = 2,
  kTimestamp = 3,
  kDataType = 4,
  kIsHistorical = 5,
  kIsNull = 7,
  kLong = 11,
  kDouble = 13,
  kBoolean = 14,
  kString = 15
};

std::string encode(const Metric& metric) {
  std::string out;
  if (!metric.name.empty()) putBytes(out, kName, metric.name);
  if (metric.hasAlias) putNumber(out, kAlias, metric.alias);
  putNumber(out, kTimestamp, static_cast<std::uint64_t>(metric.utcMs));
  putNumber(out, kDataType, static_cast<std::uint32_t>(metric.type));
  if (metric.historical) putNumber(out, kIsHistorical, 1);
  if (std::holds_alternative<std::monostate>(metric.value)) putNumber(out, kIsNull, 1);
  if (const auto* n = std::get_if<std::uint64_t>(&metric.value)) putNumber(out, kLong, *n);
  if (const auto* b = std::get_if<bool>(&metric.value)) putNumber(out, kBoolean, *b ? 1 : 0);
  if (const auto* s = std::get_if<std::string>(&metric.value)) putBytes(out, kString, *s);
  if (const auto* d = std::get_if<double>(&metric.value)) {
    putKey(out, kDouble, kFixed64);
    const auto bits = std::bit_cast<std::uint64_t>(*d);
    for (unsigned k = 0; k < 8; ++k) out.push_back(static_cast<char>((bits >> (8U * k)) & 0xFFU));
  }
  return out;
}

// Reads one message field by field.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : left_(bytes) {}
  struct Found {
    std::uint32_t field = 0;
    std::uint64_t number = 0;
    std::string_view bytes;
  };
  // Nothing: the end, or what is no message.
  std::optional<Found> next() {
    const auto key = varint();
    if (!key) return std::nullopt;
    Found found{static_cast<std::uint32_t>(*key >> 3U), 0, {}};
    switch (static_cast<Wire>(*key & 7U)) {
      case kVarint: {
        const auto n = varint();
        if (!n) return std::nullopt;
        found.number = *n;
        return found;
      }
      case kFixed64:
        return take(8, found);
      case kFixed32:
        return take(4, found);
      case kBytes: {
        const auto size = varint();
        if (!size) return std::nullopt;
        return take(*size, found);
      }
    }
    return std::nullopt;
  }

 private:
  std::optional<std::uint64_t> varint() {
    std::uint64_t n = 0;
    for (unsigned shift = 0; shift < 64 && !left_.empty(); shift += 7) {
      const auto byte = static_cast<unsigned char>(left_.front());
      left_.remove_prefix(1);
      n |= static_cast<std::uint64_t>(byte & 0x7FU) << shift;
      if (byte < 0x80U) return n;
    }
    return std::nullopt;
  }
  std::optional<Found> take(std::uint64_t size, Found found) {
    if (size > left_.size()) return std::nullopt;
    found.bytes = left_.substr(0, size);
    left_.remove_prefix(size);
    return found;
  }
  std::string_view left_;
};

}  // namespace

std::string encode(const Payload& payload) {
  std::string out;
  putNumber(out, 1, static_cast<std::uint64_t>(payload.utcMs));
  for (const Metric& metric : payload.metrics) putBytes(out, 2, encode(metric));
  if (payload.sequence >= 0) putNumber(out, 3, static_cast<std::uint64_t>(payload.sequence));
  return out;
}

bool asksForRebirth(std::string_view bytes) {
  Reader payload(bytes);
  while (const auto field = payload.next()) {
    if (field->field != 2) continue;
    Reader metric(field->bytes);
    bool named = false, yes = false;
    while (const auto inner = metric.next()) {
      named = named || (inner->field == kName && inner->bytes == kRebirth);
      yes = yes || (inner->field == kBoolean && inner->number != 0);
    }
    if (named && yes) return true;
  }
  return false;
}

}  // namespace stillcut::shop::sparkplug
