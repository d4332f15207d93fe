#include "core/session/open_recording.h"

#include <array>
#include <cctype>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>
#include <utility>

#include "core/formats/gap_list.h"
#include "core/formats/hdf5/isolated_reader.h"
#include "core/formats/matlab/mat_import.h"
#include "core/formats/media/media_import.h"
#include "core/formats/numpy/npy_import.h"
#include "core/formats/sound/sound_kinds.h"
#include "core/formats/sound/wav_reader.h"
#include "core/formats/tdms/tdms_import.h"
#include "core/formats/text/sheet_reader.h"
#include "core/formats/text/text_reader.h"
#include "core/formats/text/xlsx_text.h"
#include "core/formats/universal/uff58.h"
#include "core/formats/universal/uff_import.h"
#include "core/session/file/session_reader.h"
#include "core/session/refused_kinds.h"

namespace stillcut::record {
namespace {

bool hasSuffix(const std::string& path, std::string_view suffix) {
  return std::filesystem::path(path).extension() == suffix;
}

// "FILE.h5:/folder/set": a file and a place in it.
struct Place {
  std::string file;
  std::string inner;  // begins with '/'; empty: the whole file
};

Place splitPlace(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::exists(path, ignored)) return {path, ""};
  for (std::size_t at = path.rfind(":/"); at != std::string::npos && at > 0; at = path.rfind(":/", at - 1)) {
    if (std::filesystem::is_regular_file(path.substr(0, at), ignored)) return {path.substr(0, at), path.substr(at + 1)};
  }
  return {path, ""};
}

Status checkFile(const std::string& path) {
  std::error_code problem;
  const std::filesystem::file_status status = std::filesystem::status(path, problem);
  if (!std::filesystem::exists(status)) return Error{path, message("there is no such file")};
  if (std::filesystem::is_directory(status)) return Error{path, message("is a folder, not a recording")};
  if (!std::filesystem::is_regular_file(status))
    return Error{path, message("is not a regular file"), message("a pipe is read as the standard input: - < FILE")};
  return Done{};
}

Result<std::unique_ptr<RecordingReader>> withGaps(Result<std::unique_ptr<RecordingReader>> opened,
                                                  const std::string& name) {
  if (!opened) return opened;
  return openWithGaps(std::move(opened).value(), name);
}

// Starts slowly, for its libraries are many, and may not be there at all.
IsolatedProgram decoder() {
  return {"stillcut-decoder", message("the decoder cannot read it"),
          message("is a phone's or a camera's file, and this Stillcut was built without the decoder for them"),
          message("convert it to WAV: ffmpeg -i FILE cut.wav")};
}

// libsndfile's decoder of MP3 prints what it thinks of a damaged file: apart, nobody hears it.
IsolatedProgram soundReader() {
  IsolatedProgram program;
  program.died = message("the decoder cannot read it");
  return program;
}

// Sound by libsndfile; what that cannot read of a container, and every other container, by libavformat, apart.
Result<std::unique_ptr<RecordingReader>> openSound(const std::string& name, std::string_view head,
                                                   const ReadOptions& options) {
  if (isMpegAudio(head)) return withGaps(openIsolated(name, "", options, soundReader()), name);
  if (isSound(head) || !isMedia(head)) {
    auto opened = openWav(name, options);
    if (opened || !isMedia(head)) return withGaps(std::move(opened), name);
  }
  return openIsolated(name, "", options, decoder());
}

// A table that some program has called a sound file.
Result<std::unique_ptr<RecordingReader>> openTableOr(const std::string& name, const ReadOptions& options,
                                                     Result<std::unique_ptr<RecordingReader>> opened) {
  if (opened || !TextReader::holdsTable(name)) return opened;
  return TextReader::open(name, options, {message("is a table of text, whatever its name says")});
}

// The formats of libsndfile that no first bytes tell for sure: tried where nothing else has known the file. Those that
// it believes by the name alone are none.
Result<std::unique_ptr<RecordingReader>> openRareSound(const std::string& name, const ReadOptions& options,
                                                       Result<std::unique_ptr<RecordingReader>> opened) {
  if (opened || !isRareSound(name)) return opened;
  return withGaps(openWav(name, options), name);
}

// MATLAB's format as libsndfile writes it, with its own two variables: others, cut off, are none.
bool isSoundInMatlab(const std::string& name) {
  std::ifstream file(name, std::ios::binary);
  std::array<char, 512> bytes{};
  file.read(bytes.data(), bytes.size());
  const std::string_view head(bytes.data(), static_cast<std::size_t>(file.gcount()));
  return head.find("samplerate") != std::string_view::npos && head.find("wavedata") != std::string_view::npos;
}

// Version 4 begins with five numbers: its kind, rows, columns, whether complex, and the length of a name.
bool isMatlab4(std::string_view head) {
  constexpr std::size_t kHeader = 20;
  if (head.size() <= kHeader) return false;
  const auto number = [head](std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i > 0; --i) value = value << 8U | static_cast<unsigned char>(head[at + i - 1]);
    return value;
  };
  constexpr std::uint32_t kMostKinds = 5000, kLongestName = 256;
  const std::uint32_t name = number(16);
  return number(0) < kMostKinds && number(12) < 2 && name > 1 && name < kLongestName &&
         std::isalpha(static_cast<unsigned char>(head[kHeader])) != 0;
}

// A .mat file without the header of a later version.
Result<std::unique_ptr<RecordingReader>> openOtherMat(const std::string& name, std::string_view head,
                                                      const ReadOptions& options) {
  if (isRareSound(name)) return withGaps(openWav(name, options), name);
  if (isMatlab4(head))
    return Error{name, message("is a MATLAB file of version 4, which is not read"),
                 message("save it in MATLAB with -v7: save cut.mat -v7")};
  return Error{name, message("is no MATLAB file of version 5 to 7.3"), message("its header is missing")};
}

// Arrays of NumPy, in a file of their own or in a ZIP archive.
bool isNumpyArray(std::string_view head) {
  return head.starts_with("\x93NUMPY");
}

}  // namespace

Result<std::unique_ptr<RecordingReader>> openRecording(const std::string& path, const ReadOptions& options) {
  const auto [name, inner] = splitPlace(path);
  if (const Status s = checkFile(name); !s) return s.error();
  std::ifstream file(name, std::ios::binary);
  if (!file) return Error{name, message("cannot be opened"), foreign(std::strerror(errno))};
  std::array<char, 128> bytes{};
  file.read(bytes.data(), bytes.size());
  const std::string_view head(bytes.data(), static_cast<std::size_t>(file.gcount()));
  if (head.empty()) return Error{name, message("the file is empty")};
  if (isHdf5File(name) || head.starts_with("MATLAB 7.3")) return openIsolated(name, inner, options);
  if (head.starts_with("MATLAB 5.0")) {
    auto opened = openMat5(name, inner, options);
    return isSoundInMatlab(name) ? openRareSound(name, options, std::move(opened)) : std::move(opened);
  }
  if (head.starts_with("PK\x03\x04") && isNpz(name)) return openNpz(name, inner, options);
  if (head.starts_with("TDSm")) return openTdms(name, inner, options);
  if (head.starts_with("PK\x03\x04") && isXlsx(name)) return openSheet(name, inner, options);
  if (!inner.empty()) return Error{path, message("only HDF5, MATLAB, NumPy, TDMS and Excel files have places inside")};
  if (isNumpyArray(head)) return openNpy(name, options);
  if (const std::optional<Error> refused = refusalOf(name, head)) return *refused;
  if (hasSuffix(name, ".mat")) return openOtherMat(name, head, options);
  if (isSound(head) || isMedia(head)) return openSound(name, head, options);
  if (hasSuffix(name, ".wav") || hasSuffix(name, ".WAV"))
    return openTableOr(name, options, openSound(name, head, options));
  if (uff::looksLikeUff(head)) return withGaps(openUff(name, options), name);
  return openRareSound(name, options, TextReader::open(name, options));
}

}  // namespace stillcut::record
