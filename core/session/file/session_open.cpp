#include "core/session/file/session_open.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <utility>
#include <vector>

#include "core/formats/sensor_notes.h"
#include "core/session/file/session_layout.h"
#include "core/session/file/session_reader.h"
#include "core/session/file/session_writer.h"
#include "core/storage/journaled_driver.h"

namespace stillcut::record {
namespace {

Message noSession() {
  return message("is an HDF5 file, but not a Stillcut session");
}

Result<RecordedChannel> readChannel(hid_t file, int index, const std::string& path) {
  const std::string where = path + ":" + samplesPath(index);
  const Hdf5Id dataset(H5Dopen2(file, samplesPath(index).c_str(), H5P_DEFAULT));
  if (!dataset) return Error{where, message("the samples are missing")};
  const std::optional<std::string> quantity = readText(dataset.get(), "quantity");
  const std::optional<double> scale = readNumber(dataset.get(), "scale");
  if (!quantity || !sensorQuantityFromName(*quantity) || !scale || !std::isfinite(*scale)) {
    return Error{where, message("quantity or scale is missing or senseless")};
  }
  RecordedChannel channel;
  channel.info.name = readText(dataset.get(), "name").value_or("");
  channel.info.axis = readText(dataset.get(), "axis").value_or("");
  channel.info.quantity = *sensorQuantityFromName(*quantity);
  channel.info.scale = *scale;
  channel.quantityKnown = true;
  readSensor(dataset.get(), channel.info);
  return channel;
}

Result<CutSetup> readSetup(hid_t file, const std::string& path) {
  const Hdf5Id group(H5Gopen2(file, "setup", H5P_DEFAULT));
  if (!group) return Error{path, message("the setup is missing")};
  const auto number = [&group](const char* name) { return readNumber(group.get(), name).value_or(0.0); };
  const std::int64_t channels = readInteger(group.get(), "channels").value_or(0);
  const std::int64_t blockFrames = readInteger(group.get(), "block_frames").value_or(0);
  CutSetup setup;
  setup.machine = readText(group.get(), "machine").value_or("");
  setup.tool = readText(group.get(), "tool").value_or("");
  setup.teeth = static_cast<int>(readInteger(group.get(), "teeth").value_or(0));
  setup.toolDiameter = Metres(number("tool_diameter_m"));
  setup.nominalSpeed = Rpm(number("nominal_speed_rpm"));
  setup.nominalFeed = MetresPerSecond(number("nominal_feed_m_s"));
  setup.rate = Hertz(number("rate_hz"));
  setup.blockFrames = static_cast<int>(blockFrames);
  if (channels < 1 || channels > kMostChannels || blockFrames < 1 || blockFrames > kMostBlockFrames ||
      !(setup.rate.value > 0.0) || !std::isfinite(setup.rate.value)) {
    return Error{path, message("the setup is senseless"), message("channels, block length or rate")};
  }
  setup.channels.resize(static_cast<std::size_t>(channels));
  return setup;
}

}  // namespace

bool isHdf5File(const std::string& path) {
  constexpr std::string_view kSignature("\x89HDF\r\n\x1a\n", 8);
  std::array<char, 8> head{};
  std::ifstream file(path, std::ios::binary);
  file.read(head.data(), head.size());
  return file.gcount() == 8 && std::string_view(head.data(), head.size()) == kSignature;
}

namespace {

// Beside a writer, after a crash, or of a file whose end may be missing: HDF5 opens those only when it is told, with
// h5clear's own property, not to compare lengths. Without `journaled`: beside a writer.
Hdf5Id openAsItIs(const std::string& path, JournaledFile* journaled) {
  const Hdf5Id access = journaled != nullptr ? journaledAccess(*journaled) : Hdf5Id(H5Pcreate(H5P_FILE_ACCESS));
  const hbool_t yes = 1;
  H5Pset(access.get(), "skip_eof_check", &yes);
  // Beside a writer a piece of metadata may be caught half written and is read again; what a crash has torn stays torn,
  // so a few times are enough (the library's own hundred take minutes).
  constexpr unsigned kAttempts = 4;
  H5Pset_metadata_read_attempts(access.get(), kAttempts);
  for (const unsigned mode : {H5F_ACC_RDONLY, H5F_ACC_RDONLY | H5F_ACC_SWMR_READ}) {
    Hdf5Id file(H5Fopen(path.c_str(), mode, access.get()));
    if (file) return file;
  }
  return Hdf5Id();
}

// Tables and channels grow at their ends: when the last chunk is there, the others are.
bool lastChunkIsThere(hid_t dataset) {
  const Hdf5Id properties(H5Dget_create_plist(dataset));
  const Hdf5Id space(H5Dget_space(dataset));
  const int dimensions = H5Sget_simple_extent_ndims(space.get());
  std::array<hsize_t, 2> size{};
  std::array<hsize_t, 2> chunk{};
  if (dimensions < 1 || dimensions > 2 || H5Pget_layout(properties.get()) != H5D_CHUNKED) return true;
  if (H5Sget_simple_extent_dims(space.get(), size.data(), nullptr) < 0 ||
      H5Pget_chunk(properties.get(), dimensions, chunk.data()) < 0 || chunk[0] == 0) {
    return false;
  }
  if (size[0] == 0) return true;
  constexpr hsize_t kLargestChunk = 16U << 20U;
  const std::array<hsize_t, 2> first{(size[0] - 1) / chunk[0] * chunk[0], 0};
  hsize_t bytes = 0;
  if (H5Dget_chunk_storage_size(dataset, first.data(), &bytes) < 0 || bytes == 0 || bytes > kLargestChunk) return false;
  std::vector<std::byte> content(bytes);
  std::uint32_t filters = 0;
  return H5Dread_chunk(dataset, H5P_DEFAULT, first.data(), &filters, content.data()) >= 0;
}

herr_t visit(hid_t parent, const char* name, const H5O_info_t* info, void* /*unused*/) {
  if (info->type != H5O_TYPE_DATASET) return 0;
  const Hdf5Id dataset(H5Dopen2(parent, name, H5P_DEFAULT));
  return dataset && lastChunkIsThere(dataset.get()) ? 0 : -1;
}

// What was closed is exactly as long as HDF5 has noted. A writer that died with a journal may have noted more than it
// had written, but nothing in it that anything refers to.
Status checkWhole(const JournaledFile& bytes, hid_t file, const std::string& path, bool journal) {
  hsize_t noted = 0;
  const bool known = H5Fget_filesize(file, &noted) >= 0;
  if (known && (journal || noted <= bytes.size()) &&
      H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_NATIVE, visit, nullptr, H5O_INFO_BASIC) >= 0) {
    return Done{};
  }
  return Error{path, message("is cut short: its end is missing"),
               noted > bytes.size() ? message("%1 of %2 bytes are there; copy it again", std::to_string(bytes.size()),
                                              std::to_string(noted))
                                    : message("what is there is left as it is")};
}

}  // namespace

Result<Recovery> recoverSession(const std::string& path) {
  return recoverFromJournal(path, [&path] { return checkUnclosed(path, true); });
}

Status checkUnclosed(const std::string& path, bool journal) {
  const Result<std::unique_ptr<JournaledFile>> bytes = JournaledFile::open(path, JournaledFile::Access::Read);
  if (!bytes) return bytes.error();
  const Hdf5Id file = openAsItIs(path, bytes.value().get());
  if (!file) return Error{path, message("the session file cannot be repaired"), hdf5Cause()};
  if (readText(file.get(), "format") != kSessionFormat) return Error{path, noSession()};
  return checkWhole(*bytes.value(), file.get(), path, journal);
}

Result<OpenedSession> openSessionFile(const std::string& path, Repair repair) {
  quietHdf5();
  const Result<Recovery> recovery =
      repair == Repair::Yes ? recoverSession(path) : Result<Recovery>(Recovery::NothingToDo);
  if (!recovery) return recovery.error();
  OpenedSession opened;
  if (recovery.value() == Recovery::Recovered) {
    opened.closedCleanly = false;
    (void)here::repairSession(path).ok();  // what that cannot mend may still be readable
  }
  if (recovery.value() != Recovery::NotWritable) {
    opened.file = Hdf5Id(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
    if (opened.file) return opened;
  }
  const Message cause = hdf5Cause();
  opened.closedCleanly = false;
  if (recovery.value() != Recovery::WriterAlive) {
    Result<std::unique_ptr<JournaledFile>> bytes = JournaledFile::open(path, JournaledFile::Access::Read);
    if (!bytes) return bytes.error();
    opened.journaled = std::move(*bytes);
  }
  opened.file = openAsItIs(path, opened.journaled.get());
  if (!opened.file) return Error{path, message("the session file cannot be opened"), cause};
  if (opened.journaled) {
    const bool journal = recovery.value() != Recovery::NothingToDo && recovery.value() != Recovery::AnothersJournal;
    if (Status whole = checkWhole(*opened.journaled, opened.file.get(), path, journal); !whole) return whole.error();
  }
  return opened;
}

Result<RecordingFormat> readSessionFormat(const OpenedSession& opened, const std::string& path) {
  const hid_t file = opened.file.get();
  if (readText(file, "format") != kSessionFormat) {
    return Error{path, noSession()};
  }
  const std::int64_t version = readInteger(file, "format_version").value_or(0);
  if (version < kOldestSessionVersion || version > kSessionVersion) {
    return Error{path, message("is a session of version %1", std::to_string(version)),
                 message("this program reads versions %1 to %2", std::to_string(kOldestSessionVersion),
                         std::to_string(kSessionVersion))};
  }
  Result<CutSetup> setup = readSetup(file, path);
  if (!setup) return setup.error();
  RecordingFormat format;
  format.kind = "Stillcut session";
  format.closedCleanly = opened.closedCleanly;
  format.configuration = readText(file, "configuration").value_or("");
  format.programVersion = readText(file, "program_version").value_or("");
  format.operatorName = readText(file, "operator").value_or("");
  format.job = readText(file, "job").value_or("");
  format.started_ns = readInteger(file, "started_utc_ns").value_or(0);
  format.simulated = readInteger(file, "simulated").value_or(0) != 0;
  format.rate = setup->rate;
  format.blockFrames = setup->blockFrames;
  for (std::size_t c = 0; c < setup->channels.size(); ++c) {
    Result<RecordedChannel> channel = readChannel(file, static_cast<int>(c), path);
    if (!channel) return channel.error();
    setup->channels[c] = channel->info;
    format.channels.push_back(std::move(*channel));
  }
  format.setup = std::move(*setup);
  return format;
}

}  // namespace stillcut::record
