// PartFile: the one way a file appears whole or not at all: written beside its name, synced, renamed to it when it is
// complete; gone otherwise. Thread: its owner's; not real-time.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace stillcut {

class PartFile {
 public:
  explicit PartFile(std::string path);
  ~PartFile();
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;

  bool opened() const { return file_ != nullptr; }
  std::FILE* stream() { return file_; }
  // Bytes at any place; what lies between becomes zeros. Errors are kept for finish().
  void writeAt(std::uint64_t position, std::string_view bytes);
  Status finish();
  const std::string& path() const { return path_; }
  Error failure() const;  // with the system's words

 private:
  std::string path_;
  std::string part_;
  std::FILE* file_ = nullptr;
  std::uint64_t position_ = 0;
  int problem_ = 0;
};

}  // namespace stillcut
