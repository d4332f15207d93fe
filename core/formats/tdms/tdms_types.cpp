#include <bit>
#include <cmath>

#include "core/formats/tdms/tdms_index.h"

namespace stillcut::record {

std::size_t sizeOf(TdmsType type) {
  switch (type) {
    case TdmsType::I8:
    case TdmsType::U8:
    case TdmsType::Boolean:
      return 1;
    case TdmsType::I16:
    case TdmsType::U16:
      return 2;
    case TdmsType::I32:
    case TdmsType::U32:
    case TdmsType::Single:
    case TdmsType::SingleWithUnit:
      return 4;
    case TdmsType::I64:
    case TdmsType::U64:
    case TdmsType::Double:
    case TdmsType::DoubleWithUnit:
      return 8;
    case TdmsType::TimeStamp:
      return 16;
    case TdmsType::Text:
      break;
  }
  return 0;
}

std::optional<std::int64_t> tdmsTime(std::int64_t seconds, std::uint64_t fraction) {
  constexpr std::int64_t k1904 = -2'082'844'800;  // [s] the format's epoch, since 1970
  constexpr std::int64_t kFar = 9'000'000'000;    // [s] some 285 years
  if (seconds < -kFar || seconds > kFar) return std::nullopt;
  return (seconds + k1904) * 1'000'000'000 +
         static_cast<std::int64_t>(std::ldexp(static_cast<double>(fraction), -64) * 1e9);
}

double tdmsNumber(std::uint64_t bits, TdmsType type) {
  switch (type) {
    case TdmsType::I8:
      return static_cast<double>(static_cast<std::int8_t>(bits));
    case TdmsType::I16:
      return static_cast<double>(static_cast<std::int16_t>(bits));
    case TdmsType::I32:
      return static_cast<double>(static_cast<std::int32_t>(bits));
    case TdmsType::I64:
      return static_cast<double>(static_cast<std::int64_t>(bits));
    case TdmsType::Single:
    case TdmsType::SingleWithUnit:
      return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    case TdmsType::Double:
    case TdmsType::DoubleWithUnit:
      return std::bit_cast<double>(bits);
    default:
      return static_cast<double>(bits);
  }
}

}  // namespace stillcut::record
