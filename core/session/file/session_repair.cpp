// Repair of a crashed session, and what `info` counts.
#include <cmath>
#include <cstring>
#include <utility>

#include "core/session/file/session_layout.h"
#include "core/session/file/session_markers.h"
#include "core/session/file/session_open.h"
#include "core/session/file/session_reader.h"
#include "core/session/file/session_table.h"
#include "core/storage/journal.h"
#include "core/storage/journaled_driver.h"

namespace stillcut::record {
namespace {

std::string textOf(const std::array<char, kTruthNameSize>& name) {
  return {name.data(), strnlen(name.data(), name.size())};
}

// The property h5clear itself sets: opening for writing then clears the marks of the dead writer.
Status clearMarks(const std::string& path, JournaledFile& journaled) {
  const Hdf5Id access = journaledAccess(journaled);
  const hbool_t yes = 1;
  if (H5Pset(access.get(), "clear_status_flags", &yes) < 0 || H5Pset(access.get(), "skip_eof_check", &yes) < 0) {
    return Error{path, message("this HDF5 library cannot repair files"), hdf5Cause()};
  }
  Hdf5Id file(H5Fopen(path.c_str(), H5F_ACC_RDWR, access.get()));
  const bool opened = static_cast<bool>(file);
  if (!opened || !file.reset()) {
    const Message cause = hdf5Cause();
    journaled.abandon();
    journaled.removeJournal();
    return Error{
        path,
        opened ? message("the repaired file could not be written") : message("the session file cannot be repaired"),
        cause};
  }
  return journaled.commit(true);
}

}  // namespace

Result<bool> here::repairSession(const std::string& path) {
  quietHdf5();
  if (!isHdf5File(path)) return Error{path, message("is no session file")};
  const Result<Recovery> recovery = recoverSession(path);
  if (!recovery) return recovery.error();
  if (recovery.value() == Recovery::WriterAlive) return Error{path, message("is still being recorded")};
  const bool marked = !Hdf5Id(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
  if (recovery.value() == Recovery::AnothersJournal) {
    if (!marked && checkUnclosed(path, false)) return false;
    return Error{path, message("is not repaired: the journal beside it does not fit it"),
                 message("move %1 away to clear the mark of the dead writer alone", journalPath(path))};
  }
  const bool journal = recovery.value() != Recovery::NothingToDo;
  if (!marked && !journal) return false;
  if (marked) {
    if (const Status whole = checkUnclosed(path, journal); !whole) return whole.error();
  }
  Result<std::unique_ptr<JournaledFile>> journaled = JournaledFile::open(path, JournaledFile::Access::Write);
  if (!journaled) return journaled.error();
  if (marked) {
    if (const Status cleared = clearMarks(path, **journaled); !cleared) return cleared.error();
  }
  (*journaled)->removeJournal();
  return true;
}

Result<SessionCounts> here::countSession(const std::string& path) {
  Result<std::vector<Marker>> markers = here::readMarkers(path);
  if (!markers) return markers.error();
  const Result<OpenedSession> opened = openSessionFile(path);
  if (!opened) return opened.error();
  const hid_t file = opened.value().file.get();
  TableReader<BlockRow> blocks;
  TableReader<InputRow> inputs;
  TableReader<VerdictRow> verdicts;
  TableReader<CommandRow> commands;
  TableReader<EventRow> events;
  TableReader<TruthRow> truth;
  if (!blocks.open(file, kBlocksPath) || !inputs.open(file, kInputsPath) || !verdicts.open(file, kVerdictsPath) ||
      !commands.open(file, kCommandsPath) || !events.open(file, kEventsPath) || !truth.open(file, kTruthPath)) {
    return Error{path, message("a table is missing or has another layout"), hdf5Cause()};
  }
  const ReasonCodes reasons(readText(file, "reason_codes").value_or(""));
  constexpr std::uint64_t kMostShown = 100;
  SessionCounts counts;
  counts.markers = std::move(*markers);
  counts.steps = blocks.rows();
  counts.inputs = inputs.rows();
  counts.verdicts = verdicts.rows();
  counts.commands = commands.rows();
  counts.events = events.rows();
  bool damaged = false;
  for (std::uint64_t i = 0; const BlockRow* row = blocks.at(i, damaged); ++i) {
    if (i == 0) counts.begin = instantFromNs(row->firstSample);
    counts.end = instantFromNs(row->firstSample);
    if ((row->flags & kBlockGap) != 0) ++counts.gaps;
  }
  for (std::uint64_t i = 0; i < kMostShown; ++i) {
    const EventRow* row = events.at(i, damaged);
    if (row == nullptr) break;
    Event event;
    fromRow(*row, event);
    event.reason.code = reasons.fromFile(event.reason.code);
    counts.firstEvents.push_back(event);
  }
  for (std::uint64_t i = 0; i < kMostShown; ++i) {
    const TruthRow* row = truth.at(i, damaged);
    if (row == nullptr) break;
    counts.truthValues.emplace_back(textOf(row->name), row->value);
  }
  if (damaged) return Error{path, message("the session file is damaged"), hdf5Cause()};
  return counts;
}

Result<std::vector<RecordedTruthSample>> here::readTruthSeries(const std::string& path) {
  const Result<OpenedSession> opened = openSessionFile(path);
  if (!opened) return opened.error();
  TableReader<TruthSampleRow> series;
  if (!series.open(opened.value().file.get(), kTruthSeriesPath))
    return Error{path, message("holds no truth"), hdf5Cause()};
  std::vector<RecordedTruthSample> samples;
  bool damaged = false;
  for (std::uint64_t i = 0; const TruthSampleRow* row = series.at(i, damaged); ++i) {
    samples.push_back({textOf(row->name), instantFromNs(row->time), row->value});
  }
  if (damaged) return Error{path, message("the session file is damaged"), hdf5Cause()};
  return samples;
}

}  // namespace stillcut::record
