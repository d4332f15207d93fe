// One process of stillcut-reader or stillcut-decoder, which holds a file that may kill whoever reads it, and what is
// heard from it. Thread: its owner's; waits, but never for longer than the process gives itself (isolated_server.h).
#pragma once

#include <sys/types.h>

#include <string>
#include <utility>

#include "core/base/result.h"
#include "core/formats/hdf5/isolated_messages.h"

namespace stillcut::record {

// Which program reads the file, and what is said where it cannot.
struct IsolatedProgram {
  std::string name = "stillcut-reader";
  Message died = message("the HDF5 library cannot read it");
  Message missing = message("cannot be tried");
  Message remedy = message("the program stillcut-reader is missing beside this one");
};

class IsolatedProcess {
 public:
  IsolatedProcess() = default;
  explicit IsolatedProcess(IsolatedProgram program) : program_(std::move(program)) {}
  ~IsolatedProcess();  // the process has ended then
  IsolatedProcess(const IsolatedProcess&) = delete;
  IsolatedProcess& operator=(const IsolatedProcess&) = delete;

  // `options`: JSON as isolated_messages.h has it. What is no regular file (a pipe, a device, a folder) is refused.
  Status start(const std::string& path, const std::string& inner, const std::string& options);
  // Messages go to and come from it over this socket.
  int peer() const { return peer_; }
  // The next message. An error: the process has died of the file, or was ended because it took too long.
  Result<std::pair<apart::MessageType, std::string>> hear() const;
  // What is said of a file that nobody could read to the end.
  Error died() const;

 private:
  std::string path_;
  IsolatedProgram program_;
  int peer_ = -1;
  pid_t child_ = -1;
};

}  // namespace stillcut::record
