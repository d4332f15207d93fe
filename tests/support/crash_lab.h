// What tests and the long run share: steps recorded by a child that is killed, a disk that remembers what it was told
// and what has reached its platters, and the look at what is left.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "core/session/file/session_writer.h"
#include "core/storage/disk.h"

namespace stillcut::record {

SessionHeader exampleHeader(const std::string& configuration = "[gate]\nmax = 1.2\n");

// A child writes exampleStep(0), (1), ... until it is killed, somewhere after its step `after`. Returns how many steps
// it had handed to the writer; -1: it ended in another way.
int recordUntilKilled(const std::string& path, int after);

struct WhatIsLeft {
  bool opens = false;
  int steps = 0;         // read, each equal to what was recorded
  bool damaged = false;  // a step that is not what was recorded, or cannot be read
  std::string error;     // one line: why not
};
// Reads `path` to its end and compares bit by bit.
WhatIsLeft look(const std::string& path);

// Does it in a child without root's leave to write everywhere; gives what the child gives.
int asAnybody(const std::function<int()>& act);

// Passes everything on, and remembers it: what a power loss leaves can be made up for every moment.
class RememberingDisk final : public Disk {
 public:
  bool write(int file, std::uint64_t offset, std::span<const std::byte> bytes) override;
  bool sync(int file) override;
  std::size_t operations() const { return operations_.size(); }

  // The session and its journal as they may be found after the power went at operation `at`: all that was synced
  // before, and of each later write any of the 4 KiB pages it touches.
  void powerLoss(std::size_t at, std::mt19937& random, const std::string& session) const;

 private:
  struct Operation {
    int file;  // 0: the session, 1: its journal
    bool sync;
    std::uint64_t offset;
    std::vector<std::byte> bytes;
  };
  int numberOf(int file);

  std::vector<int> files_;
  std::vector<Operation> operations_;
};

}  // namespace stillcut::record
