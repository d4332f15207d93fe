// ZIP archives that tests make for themselves, byte by byte.
#pragma once

#include <gtest/gtest.h>
#include <zlib.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace stillcut::record {

// Little-endian.
inline std::string word(std::uint64_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i) & 0xffU);
  return text;
}

// A ZIP archive of `files`, each deflated or as it is.
inline std::string zip(const std::vector<std::pair<std::string, std::string>>& files, bool deflated) {
  std::string body;
  std::string directory;
  for (const auto& [name, content] : files) {
    std::string packed = content;
    if (deflated) {
      z_stream stream{};
      deflateInit2(&stream, 9, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
      packed.resize(deflateBound(&stream, content.size()));
      stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));
      stream.avail_in = static_cast<uInt>(content.size());
      stream.next_out = reinterpret_cast<Bytef*>(packed.data());
      stream.avail_out = static_cast<uInt>(packed.size());
      EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
      packed.resize(stream.total_out);
      deflateEnd(&stream);
    }
    const std::string common = word(deflated ? 8 : 0, 2) + word(0, 4) + word(0, 4) + word(packed.size(), 4) +
                               word(content.size(), 4) + word(name.size(), 2) + word(0, 2);
    directory.append("PK\x01\x02").append(word(20, 2)).append(word(20, 2)).append(word(0, 2)).append(common);
    directory.append(std::string(10, '\0')).append(word(body.size(), 4)).append(name);
    body.append("PK\x03\x04").append(word(20, 2)).append(word(0, 2)).append(common).append(name).append(packed);
  }
  return body + directory + "PK\x05\x06" + word(0, 4) + word(files.size(), 2) + word(files.size(), 2) +
         word(directory.size(), 4) + word(body.size(), 4) + word(0, 2);
}

}  // namespace stillcut::record
