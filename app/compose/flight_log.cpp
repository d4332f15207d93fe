#include "app/compose/flight_log.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include "core/base/atomic_file.h"

namespace stillcut::app {
namespace {

namespace fs = std::filesystem;

// "2026-05-04T13-58-07.123-gate-stale-machine.txt": sorted by name is sorted by time.
std::string fileName(const Reason& cause) {
  const auto now = std::chrono::system_clock::now();
  const std::time_t seconds = std::chrono::system_clock::to_time_t(now);
  const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(now.time_since_epoch()).count() % 1000;
  std::tm local{};
  ::localtime_r(&seconds, &local);
  char stamp[40];
  std::strftime(stamp, sizeof stamp, "%Y-%m-%dT%H-%M-%S", &local);
  char name[64];
  std::snprintf(name, sizeof name, "%s.%03d-", stamp, static_cast<int>(ms));
  return name + std::string(identifier(cause.code)) + ".txt";
}

}  // namespace

Status FlightLog::poll(safety::FlightRecorder& recorder) {
  while (recorder.take(recording_)) {
    std::error_code failed;
    fs::create_directories(folder_, failed);
    if (failed) return Error{folder_.string(), "cannot be made", failed.message()};
    const Status written = writeFileAtomically(folder_ / fileName(recording_.cause), safety::render(recording_));
    if (!written) return written;
    removeOldest();
  }
  return Done{};
}

void FlightLog::removeOldest() const {
  std::vector<fs::path> files;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder_, ignored)) {
    if (entry.path().extension() == ".txt") files.push_back(entry.path());
  }
  if (files.size() <= static_cast<std::size_t>(keep_)) return;
  std::sort(files.begin(), files.end());
  files.resize(files.size() - static_cast<std::size_t>(keep_));
  for (const fs::path& file : files) fs::remove(file, ignored);
}

}  // namespace stillcut::app
