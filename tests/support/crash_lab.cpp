#include "tests/support/crash_lab.h"

#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <memory>
#include <new>

#include "core/session/open_recording.h"
#include "core/storage/journal.h"
#include "tests/support/step_samples.h"

namespace stillcut::record {
namespace {

constexpr std::uint64_t kPage = 4096;

}  // namespace

SessionHeader exampleHeader(const std::string& configuration) {
  SessionHeader header;
  header.setup = exampleSetup();
  header.configuration = configuration;
  header.programVersion = "0.1.0";
  header.simulated = true;
  return header;
}

int recordUntilKilled(const std::string& path, int after) {
  void* page = mmap(nullptr, kPage, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  auto* added = ::new (page) std::atomic<int>(0);
  int progress[2];
  if (page == MAP_FAILED || pipe(progress) != 0) return -1;
  const pid_t child = fork();
  if (child == 0) {
    auto writer = SessionWriter::create(path, exampleHeader());
    const char sign = '.';
    for (int i = 0; writer.ok(); ++i) {
      const StepRecord step = exampleStep(i);
      added->store(i + 1);
      if (!(*writer)->add(step.input, step.output)) break;
      if (i <= after) (void)!write(progress[1], &sign, 1);
    }
    _exit(1);
  }
  close(progress[1]);
  char sign = 0;
  for (int i = 0; i <= after && read(progress[0], &sign, 1) == 1; ++i) {
  }
  kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  close(progress[0]);
  const int steps = WIFSIGNALED(status) ? added->load() : -1;
  munmap(page, kPage);
  return steps;
}

int asAnybody(const std::function<int()>& act) {
  const pid_t child = fork();
  if (child == 0) {
    constexpr uid_t kNobody = 65534;
    const bool mayNot = geteuid() != 0 || (setgid(kNobody) == 0 && setuid(kNobody) == 0);
    _exit(mayNot ? act() : 99);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

WhatIsLeft look(const std::string& path) {
  WhatIsLeft left;
  const auto reader = openRecording(path);
  left.opens = reader.ok();
  if (!reader) {
    left.error = reader.error().line();
    return left;
  }
  SampleBlock block;
  block.allocate(static_cast<int>((*reader)->format().channels.size()), (*reader)->format().blockFrames);
  while (true) {
    const Result<bool> more = (*reader)->read(block);
    if (more && !*more) return left;
    left.damaged = true;
    if (!more) {
      left.error = more.error().line();
      return left;
    }
    const StepRecord expected = exampleStep(left.steps);
    const StepRecord* got = (*reader)->recordedStep();
    if (bitsOf(got->input) != bitsOf(expected.input) || bitsOf(got->output) != bitsOf(expected.output)) {
      left.error = "step " + std::to_string(left.steps) + " is another";
      return left;
    }
    left.damaged = false;
    ++left.steps;
  }
}

int RememberingDisk::numberOf(int file) {
  const auto found = std::find(files_.begin(), files_.end(), file);
  if (found == files_.end()) {
    files_.push_back(file);
    return static_cast<int>(files_.size()) - 1;
  }
  return static_cast<int>(found - files_.begin());
}

bool RememberingDisk::write(int file, std::uint64_t offset, std::span<const std::byte> bytes) {
  operations_.push_back({numberOf(file), false, offset, {bytes.begin(), bytes.end()}});
  return Disk::write(file, offset, bytes);
}

bool RememberingDisk::sync(int file) {
  operations_.push_back({numberOf(file), true, 0, {}});
  return Disk::sync(file);
}

void RememberingDisk::powerLoss(std::size_t at, std::mt19937& random, const std::string& session) const {
  std::vector<std::byte> images[2];
  std::size_t synced[2] = {0, 0};
  for (std::size_t i = 0; i < at; ++i) {
    if (operations_[i].sync) synced[operations_[i].file] = i;
  }
  // Sometimes all, sometimes none, mostly some of the pages came through.
  const int chance = std::uniform_int_distribution<int>(0, 4)(random) * 25;
  std::uniform_int_distribution<int> percent(0, 99);
  for (std::size_t i = 0; i < at; ++i) {
    const Operation& o = operations_[i];
    std::vector<std::byte>& image = images[o.file];
    for (std::uint64_t from = o.offset, end = o.offset + o.bytes.size(); from < end;) {
      const std::uint64_t to = std::min(end, (from / kPage + 1) * kPage);
      if (i < synced[o.file] || percent(random) < chance) {
        if (image.size() < to) image.resize(to);
        std::copy(o.bytes.begin() + static_cast<std::ptrdiff_t>(from - o.offset),
                  o.bytes.begin() + static_cast<std::ptrdiff_t>(to - o.offset),
                  image.begin() + static_cast<std::ptrdiff_t>(from));
      }
      from = to;
    }
  }
  const std::string paths[2] = {session, journalPath(session)};
  for (int f = 0; f < 2; ++f) {
    std::ofstream out(paths[f], std::ios::binary | std::ios::trunc);
    out.write(reinterpret_cast<const char*>(images[f].data()), static_cast<std::streamsize>(images[f].size()));
  }
}

}  // namespace stillcut::record
