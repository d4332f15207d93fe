#include "core/record/hdf5_probe.h"

#include <filesystem>

#include "core/record/hdf5_import.h"
#include "core/record/journal.h"
#include "core/record/run_apart.h"
#include "core/record/session_open.h"

namespace stillcut::record {
namespace {

// None of them is what a sanitizer ends a program with.
constexpr int kOther = 10;
constexpr int kSession = 11;

bool isSession(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::exists(journalPath(path), ignored)) return true;
  const Result<OpenedSession> opened = openSessionFile(path, Repair::No);
  return opened && readText(opened->file.get(), "format").has_value();
}

// A file that was not closed, as a crash leaves a session: not for the plain importer.
bool opensPlainly(const std::string& path) {
  quietHdf5();
  return static_cast<bool>(Hdf5Id(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT)));
}

int tryOut(const std::string& path, const std::string& inner, const ReadOptions& options) {
  if (inner.empty() && (isSession(path) || !opensPlainly(path))) return kSession;
  auto reader = openHdf5(path, inner, options);
  if (!reader) return kOther;
  SampleBlock block;
  const int channels = static_cast<int>((*reader)->format().channels.size());
  constexpr int kFrames = 4096;
  block.allocate(channels, kFrames);
  constexpr std::int64_t kMostSamples = std::int64_t{16} << 20U;
  for (std::int64_t samples = 0; samples < kMostSamples; samples += std::int64_t{kFrames} * channels) {
    const Result<bool> more = (*reader)->read(block);
    if (!more || !*more) break;
  }
  return kOther;
}

}  // namespace

Result<bool> probeHdf5(const std::string& path, const std::string& inner, const ReadOptions& options) {
  constexpr Seconds kLimit{60.0};
  const std::optional<int> result = runApart([&] { return tryOut(path, inner, options); }, kLimit);
  if (!result || (*result != kOther && *result != kSession && *result != 0)) {
    return Error{path, "the HDF5 library cannot read it", "a damaged file"};
  }
  return result == kSession || (result == 0 && inner.empty() && isSession(path));
}

}  // namespace stillcut::record
