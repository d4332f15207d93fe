#include "core/record/open_recording.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "core/record/session_reader.h"
#include "core/record/text_reader.h"
#include "core/record/wav_reader.h"

namespace stillcut::record {
namespace {

bool isSound(std::string_view head) {
  constexpr auto kMagics = std::to_array<std::string_view>({"RIFF", "RIFX", "RF64", "fLaC", "FORM", "OggS", "riff"});
  for (const std::string_view magic : kMagics) {
    if (head.starts_with(magic)) return true;
  }
  return false;
}

bool hasSuffix(const std::string& path, std::string_view suffix) {
  return std::filesystem::path(path).extension() == suffix;
}

}  // namespace

Result<std::unique_ptr<RecordingReader>> openRecording(const std::string& path, const ReadOptions& options) {
  std::error_code problem;
  const std::filesystem::file_status status = std::filesystem::status(path, problem);
  if (!std::filesystem::exists(status)) return Error{path, "there is no such file", ""};
  if (std::filesystem::is_directory(status)) return Error{path, "is a folder, not a recording", ""};
  if (!std::filesystem::is_regular_file(status)) return Error{path, "is not a regular file", ""};
  std::ifstream file(path, std::ios::binary);
  if (!file) return Error{path, "cannot be opened", std::strerror(errno)};
  std::array<char, 16> bytes{};
  file.read(bytes.data(), bytes.size());
  const std::string_view head(bytes.data(), static_cast<std::size_t>(file.gcount()));
  if (head.empty()) return Error{path, "the file is empty", ""};
  if (isHdf5File(path)) return openSession(path, options);
  if (isSound(head) || hasSuffix(path, ".wav") || hasSuffix(path, ".WAV")) return openWav(path, options);
  return TextReader::open(path, options);
}

}  // namespace stillcut::record
