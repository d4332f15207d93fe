#include "core/milling/identify/import/file_bytes.h"

#include <filesystem>
#include <fstream>
#include <system_error>

namespace stillcut::identify {

namespace fs = std::filesystem;

Result<std::string> readFileBytes(const std::string& path, std::size_t limit) {
  std::error_code ec;
  const fs::file_status status = fs::status(path, ec);
  if (status.type() == fs::file_type::not_found) return Error{path, message("no such file")};
  if (ec) return Error{path, message("cannot be read"), foreign(ec.message())};
  if (!fs::is_regular_file(status)) return Error{path, message("is not a regular file")};
  const auto size = fs::file_size(path, ec);
  if (ec) return Error{path, message("cannot be read"), foreign(ec.message())};
  if (size == 0) return Error{path, message("the file is empty")};
  if (size > limit) {
    return Error{path, message("the file is too large"),
                 message("%1 bytes, at most %2 are read", std::to_string(size), std::to_string(limit))};
  }
  std::ifstream in(path, std::ios::binary);
  std::string bytes(static_cast<std::size_t>(size), '\0');
  if (!in || !in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) {
    return Error{path, message("cannot be read"), message("permission or device error")};
  }
  return bytes;
}

}  // namespace stillcut::identify
