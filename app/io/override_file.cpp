#include "app/io/override_file.h"

#include <array>
#include <cctype>
#include <fstream>
#include <system_error>

#include "core/storage/atomic_file.h"

namespace stillcut::app {
namespace {

constexpr Seconds kPollEvery{0.02};  // half of what a record may be late, with room for the disk
constexpr Seconds kRetryEvery{0.5};
constexpr int kMost = 1000;  // percent; no machine has more

std::string fileName(const std::string& machine) {
  std::string name;
  for (const char c : machine) name += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' ? c : '-';
  constexpr std::size_t kLongest = 120;
  return name.substr(0, kLongest) + ".override";
}

std::optional<cnc::SentOverrides> readLeft(const std::filesystem::path& file) {
  std::error_code problem;
  if (!std::filesystem::is_regular_file(file, problem)) return std::nullopt;
  std::ifstream in(file);
  std::array<int, 4> percent{};
  for (int& p : percent) {
    if (!(in >> p) || p < 0 || p > kMost) return std::nullopt;
  }
  return cnc::SentOverrides{{percent[0], percent[1]}, {percent[2], percent[3]}};
}

}  // namespace

OverrideFile::OverrideFile(const std::filesystem::path& folder, const std::string& machine)
    : file_(folder / fileName(machine)), machine_(machine), left_(readLeft(file_)) {
  wanted_.set(left_);
  written_ = left_;
  thread_.emplace(rt::ThreadRequest{"override-record"}, [this](const std::stop_token& stop) { run(stop); });
}

OverrideFile::~OverrideFile() {
  thread_->requestStop();
  wakeup_.notify();
  thread_.reset();
  nextTry_ = {};  // the last one waits for nothing
  write();
}

void OverrideFile::run(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    wakeup_.waitFor(kPollEvery);
    write();
  }
}

void OverrideFile::write() {
  const std::optional<cnc::SentOverrides> wanted = wanted_.get();
  if (wanted == written_ || SteadyClock().now() < nextTry_) return;
  std::error_code problem;
  if (!wanted) {
    written_ = wanted;
    std::filesystem::remove(file_, problem);
    return;
  }
  std::filesystem::create_directories(file_.parent_path(), problem);
  const auto& [speed, feed] = *wanted;
  std::string text;
  for (const int percent : {speed.base, speed.sent, feed.base, feed.sent}) text += std::to_string(percent) + ' ';
  text += "\nspindle: of the operator, sent; feed: of the operator, sent [%]; machine " + machine_ + "\n";
  if (writeFileAtomically(file_, text).ok()) {
    written_ = wanted;
  } else {
    nextTry_ = SteadyClock().now() + toDuration(kRetryEvery);  // a full disk may be emptied, a share come back
  }
}

}  // namespace stillcut::app
