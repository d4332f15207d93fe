// TextBytes: a table's text as UTF-8, front to back, whatever the file keeps it in: the file's own bytes, UTF-16, or
// a sheet of a spreadsheet (XLSX). Thread: its owner's; not real-time.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "core/base/result.h"

namespace stillcut::record {

class TextBytes {
 public:
  virtual ~TextBytes() = default;
  // At most so many bytes; 0: the end. Error: unreadable or damaged.
  virtual Result<std::size_t> read(char* into, std::size_t most) = 0;
};

// Of a spreadsheet its first sheet, or by "FILE:/NAME" the one of that name.
Result<std::unique_ptr<TextBytes>> openText(const std::string& path);

}  // namespace stillcut::record
