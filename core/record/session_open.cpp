#include "core/record/session_open.h"

#include <array>
#include <cmath>
#include <fstream>

#include "core/record/journaled_driver.h"
#include "core/record/sensor_notes.h"
#include "core/record/session_layout.h"
#include "core/record/session_reader.h"
#include "core/record/session_writer.h"

namespace stillcut::record {
namespace {

Result<RecordedChannel> readChannel(hid_t file, int index, const std::string& path) {
  const std::string where = path + ":" + samplesPath(index);
  const Hdf5Id dataset(H5Dopen2(file, samplesPath(index).c_str(), H5P_DEFAULT));
  if (!dataset) return Error{where, "the samples are missing", ""};
  const std::optional<std::string> quantity = readText(dataset.get(), "quantity");
  const std::optional<double> scale = readNumber(dataset.get(), "scale");
  if (!quantity || !sensorQuantityFromName(*quantity) || !scale || !std::isfinite(*scale)) {
    return Error{where, "quantity or scale is missing or senseless", ""};
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
  if (!group) return Error{path, "the setup is missing", ""};
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
    return Error{path, "the setup is senseless", "channels, block length or rate"};
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

// Beside a writer, after a crash that cannot be repaired here, or of a file whose end is missing (full disk, copy cut
// short). The last keeps HDF5 from opening unless it is told, with h5clear's own property, not to compare lengths.
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

}  // namespace

Result<OpenedSession> openSessionFile(const std::string& path, Repair repair) {
  quietHdf5();
  const Result<Recovery> recovery =
      repair == Repair::Yes ? recoverFromJournal(path) : Result<Recovery>(Recovery::NothingToDo);
  if (!recovery) return recovery.error();
  OpenedSession opened;
  if (recovery.value() == Recovery::Recovered) {
    opened.closedCleanly = false;
    (void)repairSession(path).ok();  // what that cannot mend may still be readable
  }
  if (recovery.value() == Recovery::NotWritable) {
    Result<std::unique_ptr<JournaledFile>> beside = JournaledFile::open(path, JournaledFile::Access::Read);
    if (!beside) return beside.error();
    opened.journaled = std::move(*beside);
  } else {
    opened.file = Hdf5Id(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
    if (opened.file) return opened;
  }
  const std::string cause = hdf5Cause();
  opened.closedCleanly = false;
  opened.file = openAsItIs(path, opened.journaled.get());
  if (opened.file) return opened;
  return Error{path, "the session file cannot be opened", cause};
}

Result<RecordingFormat> readSessionFormat(hid_t file, const std::string& path) {
  if (readText(file, "format") != kSessionFormat) {
    return Error{path, "is an HDF5 file, but not a Stillcut session", ""};
  }
  const std::int64_t version = readInteger(file, "format_version").value_or(0);
  if (version < kOldestSessionVersion || version > kSessionVersion) {
    return Error{path, "is a session of version " + std::to_string(version),
                 "this program reads versions " + std::to_string(kOldestSessionVersion) + " to " +
                     std::to_string(kSessionVersion)};
  }
  Result<CutSetup> setup = readSetup(file, path);
  if (!setup) return setup.error();
  RecordingFormat format;
  format.kind = "Stillcut session";
  format.configuration = readText(file, "configuration").value_or("");
  format.programVersion = readText(file, "program_version").value_or("");
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
