#include "app/compose/build_info.h"

#include <fftw3.h>
#include <gnu/libc-version.h>
#include <hdf5.h>
#include <matio.h>
#include <sndfile.h>
#include <spdlog/version.h>
#include <sqlite3.h>
#include <toml++/toml.h>
#include <zlib.h>

#include <Eigen/Core>
#include <algorithm>
#include <cctype>
#include <iterator>
#include <nlohmann/json.hpp>
#include <vector>

#include "app/io/device_libraries.h"
#include "generated/commit.h"
#include "generated/version.h"

namespace stillcut::app {
namespace {

std::string dotted(unsigned major, unsigned minor, unsigned patch) {
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
}

// FFTW and libsndfile put their name in front: "fftw-3.3.10-sse2", "libsndfile-1.2.0".
std::string numberIn(std::string_view text) {
  std::size_t from = 0;
  while (from < text.size() && std::isdigit(static_cast<unsigned char>(text[from])) == 0) ++from;
  const std::size_t end = text.find_first_not_of("0123456789.", from);
  return std::string(text.substr(from, end == std::string_view::npos ? end : end - from));
}

std::string hdf5Version() {
  unsigned major = 0;
  unsigned minor = 0;
  unsigned patch = 0;
  if (H5get_libversion(&major, &minor, &patch) < 0) return "unknown";
  return dotted(major, minor, patch);
}

std::string matioVersion() {
  int major = 0;
  int minor = 0;
  int patch = 0;
  Mat_GetLibraryVersion(&major, &minor, &patch);
  return dotted(static_cast<unsigned>(major), static_cast<unsigned>(minor), static_cast<unsigned>(patch));
}

}  // namespace

std::string versionText(std::string_view program, std::string_view more) {
  std::vector<std::string> libraries{
      "FFTW " + numberIn(fftw_version),
      "HDF5 " + hdf5Version(),
      "libsndfile " + numberIn(sf_version_string()),
      "matio " + matioVersion(),
      std::string("zlib ") + zlibVersion(),
      "Eigen " + dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION),
      "spdlog " + dotted(SPDLOG_VER_MAJOR, SPDLOG_VER_MINOR, SPDLOG_VER_PATCH),
      std::string("SQLite ") + sqlite3_libversion(),
      "toml++ " + dotted(TOML_LIB_MAJOR, TOML_LIB_MINOR, TOML_LIB_PATCH),
      "JSON for Modern C++ " +
          dotted(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)};
  std::ranges::copy(deviceLibraries(), std::back_inserter(libraries));
  if (!more.empty()) libraries.emplace_back(more);
  libraries.push_back(std::string("glibc ") + ::gnu_get_libc_version());
  std::string text = std::string(program) + " " STILLCUT_VERSION " (commit " STILLCUT_COMMIT ")";
  for (const std::string& library : libraries) text += "\n" + library;
  return text + "\ncompiled by " STILLCUT_COMPILER;
}

}  // namespace stillcut::app
