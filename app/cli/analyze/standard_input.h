// A recording from a pipe: it is kept in a file of its own while it is looked at, since formats are told by their
// content and read more than once. Gone with the object, and with the program however it ends.
// Thread: main; waits for the pipe to end.
#pragma once

#include <string>

#include "core/base/result.h"

namespace stillcut::app {

class StandardInput {
 public:
  // Error: nothing came, or the disk is full.
  static Result<StandardInput> keep();
  ~StandardInput();
  StandardInput(StandardInput&& other) noexcept;
  StandardInput& operator=(StandardInput&&) = delete;
  StandardInput(const StandardInput&) = delete;
  StandardInput& operator=(const StandardInput&) = delete;

  const std::string& path() const { return path_; }

 private:
  StandardInput(std::string path, int file) : path_(std::move(path)), file_(file) {}

  std::string path_;
  int file_ = -1;
};

}  // namespace stillcut::app
