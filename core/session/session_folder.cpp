#include "core/session/session_folder.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <optional>

#include "core/formats/utf_text.h"
#include "core/session/file/session_reader.h"
#include "core/session/session_glance.h"
#include "core/session/session_kind.h"
#include "core/storage/journal.h"

namespace stillcut::record {
namespace {

namespace fs = std::filesystem;

std::string fileName(const std::string& text, const char* otherwise) {
  constexpr std::size_t kLongest = 80;  // bytes
  std::string name;
  for (const char c : utf8Of(text)) {
    const auto code = static_cast<unsigned char>(c);
    const bool bad = code < 0x20 || code == 0x7f || std::string_view("/\\:*?\"<>|").find(c) != std::string_view::npos;
    name += bad ? '-' : c;
  }
  name.resize(cutUtf8(name, kLongest).size());
  while (!name.empty() && (name.back() == ' ' || name.back() == '.')) name.pop_back();
  while (!name.empty() && (name.front() == ' ' || name.front() == '.')) name.erase(0, 1);
  return name.empty() ? otherwise : name;
}

struct Candidate {
  std::string path;
  std::uint64_t bytes = 0;
  std::int64_t changed_ns = 0;
};

enum class Holds : std::uint8_t { Everything, FeaturesOnly };

// What a session holds that nobody has marked; nothing: it stays. What cannot be read stays too: somebody may want to
// mend it.
std::optional<Holds> mayGo(const std::string& path) {
  std::error_code unknown;
  if (fs::exists(journalPath(path), unknown) || !isHdf5File(path)) return std::nullopt;
  const std::optional<SessionGlance> glance = glanceAtSession(path);
  if (!glance || glance->markers > 0) return std::nullopt;
  return glance->featuresOnly ? Holds::FeaturesOnly : Holds::Everything;
}

std::string inWords(Seconds age) {
  const long hours = std::lround(age.value / 3600.0);
  return hours >= 48 ? std::to_string(hours / 24) + " days" : std::to_string(hours) + " hours";
}

std::vector<Candidate> sessionsBelow(const std::string& folder) {
  std::vector<Candidate> found;
  std::error_code problem;
  for (auto entry = fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied, problem);
       !problem && entry != fs::recursive_directory_iterator(); entry.increment(problem)) {
    struct stat info {};
    if (entry->path().extension() != ".h5" || stat(entry->path().c_str(), &info) != 0 || !S_ISREG(info.st_mode))
      continue;
    constexpr std::int64_t kSecond_ns = 1'000'000'000;
    found.push_back({entry->path().string(), static_cast<std::uint64_t>(info.st_size),
                     info.st_mtim.tv_sec * kSecond_ns + info.st_mtim.tv_nsec});
  }
  std::sort(found.begin(), found.end(),
            [](const Candidate& a, const Candidate& b) { return a.changed_ns < b.changed_ns; });
  return found;
}

bool isFree(const std::string& path) {
  std::error_code unknown;
  return !fs::exists(path, unknown) && !fs::exists(journalPath(path), unknown);
}

std::string freeName(const std::string& stem, const std::string& suffix, const char* between) {
  std::string path = stem + suffix;
  for (int n = 2; !isFree(path); ++n) {
    path = stem;
    path.append(between).append(std::to_string(n)).append(suffix);
  }
  return path;
}

}  // namespace

Result<std::string> newSessionPath(const std::string& folder, const std::string& job, const std::string& tool,
                                   std::int64_t utc_ns) {
  const fs::path place = fs::path(folder) / fileName(job, "job") / fileName(tool, "tool");
  std::error_code problem;
  fs::create_directories(place, problem);
  if (problem) return Error{place.string(), message("the folder cannot be made"), foreign(problem.message())};
  if (access(place.c_str(), W_OK) != 0) return Error{place.string(), message("the folder cannot be written to")};
  const std::time_t seconds = utc_ns / 1'000'000'000;
  std::tm parts{};
  char text[40] = "";
  if (gmtime_r(&seconds, &parts) != nullptr) std::strftime(text, sizeof text, "%Y-%m-%d_%H-%M-%S", &parts);
  return freeName((place / text).string(), ".h5", "_");
}

std::string freeSessionPath(const std::string& wanted) {
  return freeName(fs::path(wanted).replace_extension().string(), fs::path(wanted).extension().string(), "-");
}

Status checkRoom(const std::string& path, std::uint64_t bytes) {
  std::error_code problem;
  fs::path place = fs::absolute(path, problem);
  if (!fs::exists(place, problem)) place = place.parent_path();
  if (access(place.c_str(), W_OK) != 0) return Done{};  // whoever writes there is told why it cannot be
  const fs::space_info space = fs::space(place, problem);
  const bool unknown = problem || space.capacity == 0;
  if (unknown || space.available >= bytes) return Done{};
  return Error{path, message("recording stopped: the disk is nearly full"),
               message("%1 MB are left", std::to_string(space.available >> 20U))};
}

Result<std::unique_ptr<SessionWriter>> createUnderNextName(const NextPath& nextPath, const SessionHeader& header,
                                                           const SessionWriterOptions& options) {
  constexpr int kMostTries = 100;
  SessionWriterOptions asNew = options;
  asNew.replaces = false;
  for (int tries = 1;; ++tries) {
    const Result<std::string> path = nextPath();
    if (!path) return path.error();
    Result<std::unique_ptr<SessionWriter>> made = SessionWriter::create(*path, header, asNew);
    if (made || isFree(*path) || tries == kMostTries) return made;
  }
}

Status checkReplaceable(const std::string& path, MayReplace may) {
  const Message refused = message("is not replaced");
  std::error_code unknown;
  if (fs::exists(journalPath(path), unknown)) {
    return Error{path, refused,
                 message("a recording of this name is still being written, or was cut off; take another name")};
  }
  if (!isHdf5File(path)) return Done{};
  const std::string kind = kindOfHdf5(path);
  if (kind == "damaged")
    return Error{path, refused, message("it may be a recording that is damaged; take another name")};
  if (kind == "other" || (kind == "simulated" && may == MayReplace::SimulatedSession)) return Done{};
  return Error{path, refused, message("it is a recorded session; take another name")};
}

std::vector<Deleted> applyRetention(const std::string& folder, const RecordPlan& plan, std::int64_t now_utc_ns) {
  const Seconds features = plan.mode == RecordMode::Features ? plan.history : plan.keepFor;
  std::vector<Candidate> files = sessionsBelow(folder);
  std::uint64_t total = 0;
  for (const Candidate& f : files) total += f.bytes;
  std::vector<Deleted> deleted;
  for (const Candidate& f : files) {
    const Seconds age(static_cast<double>(now_utc_ns - f.changed_ns) * 1e-9);
    const bool beyond = total > plan.keepBytes;
    if (!beyond && age <= std::min(features, plan.keepFor)) continue;
    const std::optional<Holds> holds = mayGo(f.path);
    if (!holds) continue;
    const Seconds keep = *holds == Holds::FeaturesOnly ? features : plan.keepFor;
    if (!beyond && age <= keep) continue;
    std::error_code problem;
    const bool gone = fs::remove(f.path, problem) || !problem;  // or somebody else was first
    total -= f.bytes;
    deleted.push_back(
        {f.path,
         age > keep ? "older than " + inWords(keep) : "more than " + std::to_string(plan.keepBytes / 1'000'000) + " MB",
         gone ? "" : problem.message()});
  }
  return deleted;
}

}  // namespace stillcut::record
