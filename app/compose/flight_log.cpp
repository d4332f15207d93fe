#include "app/compose/flight_log.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include "app/compose/resource_folder.h"
#include "core/storage/atomic_file.h"

namespace stillcut::app {
namespace {

namespace fs = std::filesystem;

constexpr Seconds kLook{0.25};  // how often the disk's thread looks for new faults

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

fs::path defaultFlightsFolder() {
  return userFolder("XDG_DATA_HOME", ".local/share") / "flights";
}

void FlightLog::start() {
  if (!thread_) thread_.emplace(rt::ThreadRequest{"flights"}, [this](const std::stop_token& stop) { run(stop); });
}

void FlightLog::run(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    if (!poll()) wakeup_.waitFor(kLook);
  }
}

Status FlightLog::finish() {
  if (thread_) {
    thread_->requestStop();
    wakeup_.notify();
    thread_.reset();
  }
  recorder_.finish();
  while (poll()) {
  }
  const Message left = problem();
  return left.empty() ? Status(Done{}) : Status(Error{{}, left});
}

Message FlightLog::problem() const {
  const std::scoped_lock lock(problemLock_);
  return problem_;
}

bool FlightLog::poll() {
  if (!waiting_) waiting_ = recorder_.take(recording_);
  if (!waiting_) return false;
  const Status written = write();
  if (written) waiting_ = false;
  const std::scoped_lock lock(problemLock_);
  problem_ = written ? Message() : written.error().asMessage();
  return written.ok();
}

Status FlightLog::write() const {
  std::error_code failed;
  fs::create_directories(folder_, failed);
  if (failed) return Error{folder_.string(), message("cannot be made"), foreign(failed.message())};
  Status written = writeFileAtomically(folder_ / fileName(recording_.cause), safety::render(recording_));
  if (written) removeOldest();
  return written;
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
