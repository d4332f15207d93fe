// Text of files as the program keeps it: UTF-8. MATLAB stores UTF-16, old universal files the bytes of whoever wrote
// them. Thread: any; values.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stillcut::record {

// What is no letter (half of a surrogate pair, broken bytes) becomes '?'.
std::string fromUtf16(std::span<const std::uint16_t> letters);
std::vector<std::uint16_t> toUtf16(std::string_view utf8);
// Bytes that are UTF-8 stay; others are taken as Latin-1, as instruments in Europe write them.
std::string utf8Of(std::string_view bytes);
// At most so many bytes, cut between two letters.
std::string_view cutUtf8(std::string_view utf8, std::size_t most);

}  // namespace stillcut::record
