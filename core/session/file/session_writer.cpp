#include "core/session/file/session_writer.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "core/formats/utf_text.h"
#include "core/session/file/session_layout.h"
#include "core/session/file/session_markers.h"
#include "core/session/file/session_reader.h"
#include "core/session/file/session_samples.h"
#include "core/session/file/session_segments.h"
#include "core/session/file/session_table.h"
#include "core/storage/hdf5_file.h"
#include "core/storage/journaled_driver.h"

namespace stillcut::record {
namespace {

bool writeHeader(hid_t file, const SessionHeader& header, bool samples) {
  const CutSetup& s = header.setup;
  const Hdf5Id setup(H5Gcreate2(file, "setup", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  return writeText(file, "format", kSessionFormat) && writeInteger(file, "format_version", kSessionVersion) &&
         writeText(file, "program", "Stillcut") && writeText(file, "program_version", header.programVersion) &&
         writeText(file, "configuration", header.configuration) &&
         writeText(file, "reason_codes", reasonIdentifiers()) &&
         writeInteger(file, "simulated", header.simulated ? 1 : 0) &&
         writeInteger(file, kFeaturesOnly, samples ? 0 : 1) && writeText(file, "operator", header.operatorName) &&
         writeText(file, "job", header.job) && writeInteger(file, "started_utc_ns", nowUtc()) && setup &&
         writeText(setup.get(), "machine", s.machine) && writeText(setup.get(), "tool", s.tool) &&
         writeInteger(setup.get(), "teeth", s.teeth) &&
         writeNumber(setup.get(), "tool_diameter_m", s.toolDiameter.value) &&
         writeNumber(setup.get(), "nominal_speed_rpm", s.nominalSpeed.value) &&
         writeNumber(setup.get(), "nominal_feed_m_s", s.nominalFeed.value) &&
         writeNumber(setup.get(), "rate_hz", s.rate.value) &&
         writeInteger(setup.get(), "block_frames", s.blockFrames) &&
         writeInteger(setup.get(), "channels", static_cast<std::int64_t>(s.channels.size()));
}

std::array<char, kTruthNameSize> truthName(std::string_view name) {
  std::array<char, kTruthNameSize> text{};
  std::copy_n(name.begin(), std::min(name.size(), text.size() - 1), text.begin());
  return text;
}

// What the operator's touch says about the cut; null: nothing.
const char* labelOf(OperatorAction action) {
  switch (action) {
    case OperatorAction::TrueAlarm:
      return kLabelTrueAlarm;
    case OperatorAction::FalseAlarm:
      return kLabelFalseAlarm;
    case OperatorAction::ReportChatter:
      return kLabelOperatorChatter;
    default:
      return nullptr;
  }
}

}  // namespace

struct SessionWriter::Impl {
  std::unique_ptr<JournaledFile> journaled;
  Hdf5Id file;
  std::string author;  // as far as a marker has room for it
  bool keepSamples = true;
  bool powerSafe = false;
  bool commitLater = false;
  std::vector<SampleWriter> samples;
  TableWriter<MachineRow> machine;
  TableWriter<DecisionRow> decisions;
  TableWriter<InputRow> inputs;
  TableWriter<VerdictRow> verdicts;
  TableWriter<CommandRow> commands;
  TableWriter<EventRow> events;
  TableWriter<MarkerRow> markers;
  TableWriter<TruthRow> truth;
  TableWriter<TruthSampleRow> truthSeries;
  TableWriter<SegmentRow> segments;
  TableWriter<BlockRow> blocks;
  SegmentFinder segmentFinder;
  std::uint64_t steps = 0;
  std::uint64_t frames = 0;
  std::uint64_t markerCount = 0;
  std::optional<MarkerRow> mark;  // the newest of a moment that the operator's touch made, unless it was taken back
  std::vector<std::pair<double, MarkerRow>> alarmMarks;  // those of an alarm, with OperatorInput::value
  Instant begin{};
  Instant flushedUpTo{};
  bool closed = false;

  // Tables in the order in which they are written.
  template <class Do>
  bool each(Do act) {
    return act(machine) && act(decisions) && act(inputs) && act(verdicts) && act(commands) && act(events) &&
           act(markers) && act(truth) && act(truthSeries) && act(segments) && act(blocks);
  }
  bool createTables() {
    const hid_t f = file.get();
    return machine.create(f, kMachinePath) && decisions.create(f, kDecisionsPath) && inputs.create(f, kInputsPath) &&
           verdicts.create(f, kVerdictsPath) && commands.create(f, kCommandsPath) && events.create(f, kEventsPath) &&
           markers.create(f, kMarkersPath) && truth.create(f, kTruthPath) && truthSeries.create(f, kTruthSeriesPath) &&
           segments.create(f, kSegmentsPath) && blocks.create(f, kBlocksPath);
  }
  bool create(const std::string& part, const SessionHeader& header) {
    file = Hdf5Id(H5Fcreate(part.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, journaledAccess(*journaled).get()));
    if (!file || !writeHeader(file.get(), header, keepSamples)) return false;
    samples.resize(header.setup.channels.size());
    for (std::size_t c = 0; c < samples.size(); ++c) {
      if (!samples[c].create(file.get(), static_cast<int>(c), header.setup.channels[c])) return false;
    }
    return createTables() && H5Fstart_swmr_write(file.get()) >= 0 && H5Fflush(file.get(), H5F_SCOPE_LOCAL) >= 0;
  }
  // Whoever has made the journal has the name: no other recording takes it between the look and the move.
  Status place(const std::string& part, const std::string& path, bool replaces) {
    const auto which = replaces ? JournaledFile::JournalOf::AnyFile : JournaledFile::JournalOf::NewFile;
    if (Status begun = journaled->beginJournal(path, which); !begun) return begun;
    std::error_code unknown;
    if (!replaces && std::filesystem::exists(path, unknown)) return Error{path, message("is there already")};
    if (std::rename(part.c_str(), path.c_str()) == 0) return Done{};
    return Error{path, foreign(std::strerror(errno))};
  }
  // The blocks go last: a reader that sees a block finds everything that belongs to it.
  bool write() {
    return std::all_of(samples.begin(), samples.end(), [](SampleWriter& s) { return s.write(); }) &&
           each([](auto& table) { return table.write(); }) && H5Fflush(file.get(), H5F_SCOPE_LOCAL) >= 0;
  }
  Result<MarkerRow> addMarker(Marker marker) {
    marker.number = markerCount++;
    if (marker.made_ns == 0) marker.made_ns = nowUtc();
    Result<MarkerRow> row = toRow(marker);
    if (row) markers.add(*row);
    return row;
  }
  void setMark(const char* label, double alarm_s, Instant now) {
    if (!(alarm_s > 0.0)) {
      mark.reset();
      if (const auto row = addMarker({0, now, now, label, author, "", 0})) mark = *row;
      return;
    }
    undoMark(alarm_s);  // an alarm is counted once
    // A little later, so that it is the alarm that has begun last. One before this recording is in another.
    if (!(alarm_s < sinceEpoch(now).value)) return;
    const Instant about = Instant{} + toDuration(Seconds(alarm_s)) + std::chrono::milliseconds(1);
    if (about < begin) return;
    if (const auto row = addMarker({0, about, about, label, author, "", 0})) alarmMarks.emplace_back(alarm_s, *row);
  }
  void undoMark(double alarm_s) {
    if (!(alarm_s > 0.0)) {
      if (mark) removeMark(*mark);
      mark.reset();
      return;
    }
    std::erase_if(alarmMarks, [&](auto& made) {
      if (made.first != alarm_s) return false;
      removeMark(made.second);
      return true;
    });
  }
  void removeMark(MarkerRow row) {
    row.removed = 1;
    markers.add(row);
  }
  bool close() {
    closed = true;
    for (SampleWriter& s : samples) s.close();
    each([](auto& table) { return table.close(), true; });
    return file.reset();
  }
};

SessionWriter::SessionWriter(std::string path, std::unique_ptr<Impl> impl)
    : path_(std::move(path)), impl_(std::move(impl)) {}

SessionWriter::~SessionWriter() {
  (void)close().ok();
}

Result<std::unique_ptr<SessionWriter>> SessionWriter::create(const std::string& path, const SessionHeader& header,
                                                             const SessionWriterOptions& options) {
  quietHdf5();
  const auto channels = static_cast<int>(header.setup.channels.size());
  if (channels < 1 || channels > kMostChannels || !(header.setup.rate.value > 0.0) || header.setup.blockFrames < 1) {
    return Error{path, message("cannot be recorded"), message("channels, rate and block length must be known before")};
  }
  // Of this program alone: another one may be about to take the same name.
  const std::string part = path + "." + std::to_string(getpid()) + ".part";
  Disk& disk = options.disk != nullptr ? *options.disk : systemDisk();
  Result<std::unique_ptr<JournaledFile>> file = JournaledFile::open(part, JournaledFile::Access::Create, disk);
  if (!file) return Error{path, message("the session file cannot be created"), file.error().why};
  auto impl = std::make_unique<Impl>();
  impl->journaled = std::move(*file);
  impl->author = cutUtf8(header.operatorName.substr(0, header.operatorName.find('\0')), kMarkerAuthorSize - 1);
  impl->keepSamples = options.samples;
  impl->powerSafe = options.powerSafe;
  const bool made = impl->create(part, header);
  Status placed = Done{};
  if (made) placed = impl->place(part, path, options.replaces);
  if (!made || !placed) {
    const Message& reason = impl->journaled->error();
    const Message cause = !placed ? placed.error().what : !reason.empty() ? reason : foreign(std::strerror(errno));
    impl->journaled->abandon();
    impl->close();
    impl->journaled->removeJournal();
    std::remove(part.c_str());
    return Error{path, message("the session file cannot be created"), cause};
  }
  return std::unique_ptr<SessionWriter>(new SessionWriter(path, std::move(impl)));
}

Status SessionWriter::failed(const char* doing) {
  const Message& disk = impl_->journaled->error();
  return failed(Error{path_, message("recording failed while %1", doing), disk.empty() ? hdf5Cause() : disk});
}

// What the last flush has brought is closed; what came after it is gone.
Status SessionWriter::failed(const Error& error) {
  leaveWhole();
  return error;
}

void SessionWriter::leaveWhole() {
  const bool beyondRepair = impl_->journaled->cutShort();
  impl_->journaled->abandon();
  impl_->close();
  if (beyondRepair) impl_->journaled->removeJournal();  // it fits nothing any more
  impl_->journaled.reset();
  if (!beyondRepair) (void)here::repairSession(path_).ok();
}

Status SessionWriter::add(const StepInput& input, const StepOutput& output) {
  if (impl_->closed) return Error{path_, message("the session is closed")};
  const SampleBlock& block = input.block;
  if (block.channels != static_cast<int>(impl_->samples.size())) {
    return Error{path_, message("a block has %1 channels", std::to_string(block.channels)),
                 message("the session has others")};
  }
  Impl& w = *impl_;
  const std::uint64_t step = w.steps++;
  for (int c = 0; w.keepSamples && c < block.channels; ++c) {
    w.samples[static_cast<std::size_t>(c)].add(block.channel(c));
  }
  BlockRow row = toRow(block, w.frames);
  if (!w.keepSamples) row.frames = 0;
  w.blocks.add(row);
  if (w.segmentFinder.begins(row)) w.segments.add({step, row.offset, row.firstSample, row.rate});
  w.frames += static_cast<std::uint64_t>(row.frames);
  if (step == 0) w.begin = block.firstSample;
  w.machine.add(toRow(input.machine));
  w.decisions.add(toRow(output));
  for (int i = 0; i < input.inputCount; ++i) {
    const OperatorInput& asked = input.inputs[static_cast<std::size_t>(i)];
    w.inputs.add(toRow(asked, step));
    // Whatever became of it, the touch is among the inputs, and the recording goes on.
    if (const char* label = labelOf(asked.action)) w.setMark(label, asked.value, block.end());
    if (asked.action == OperatorAction::UndoMark) w.undoMark(asked.value);
  }
  for (int i = 0; i < output.verdictCount; ++i) {
    w.verdicts.add(toRow(output.verdicts[static_cast<std::size_t>(i)], i, step));
  }
  if (output.hasCommand) w.commands.add(toRow(output.command, step));
  for (int i = 0; i < output.eventCount; ++i) w.events.add(toRow(output.events[static_cast<std::size_t>(i)], step));
  constexpr Duration kFlushEvery = std::chrono::milliseconds(500);
  if (step == 0) w.flushedUpTo = block.firstSample;
  if (block.end() - w.flushedUpTo < kFlushEvery) return Done{};
  w.flushedUpTo = block.end();
  return flush();
}

Status SessionWriter::addTruth(std::string_view name, double value) {
  if (impl_->closed) return Error{path_, message("the session is closed")};
  impl_->truth.add({truthName(name), value});
  return Done{};
}

Status SessionWriter::addTruth(std::string_view name, Instant time, double value) {
  if (impl_->closed) return Error{path_, message("the session is closed")};
  impl_->truthSeries.add({truthName(name), toNs(time), value});
  return Done{};
}

Status SessionWriter::addMarker(Marker marker) {
  if (impl_->closed) return Error{path_, message("the session is closed")};
  const Result<MarkerRow> row = impl_->addMarker(std::move(marker));
  return row ? Status(Done{}) : Status(row.error());
}

bool SessionWriter::inPlace() const {
  return impl_->journaled && impl_->journaled->isAt(path_);
}

bool SessionWriter::cutShort() const {
  return impl_->journaled && impl_->journaled->cutShort();
}

void SessionWriter::setPowerSafe() {
  impl_->powerSafe = true;
}

void SessionWriter::commitLater(bool later) {
  impl_->commitLater = later;
}

Status SessionWriter::flush() {
  if (impl_->closed) return Error{path_, message("the session is closed")};
  quietHdf5();
  if (!impl_->write()) return failed("writing");
  if (impl_->commitLater) return Done{};
  if (!impl_->journaled->commit(impl_->powerSafe)) return failed("writing");
  return Done{};
}

Status SessionWriter::close() {
  if (impl_->closed) return Done{};
  if (const Status s = flush(); !s) return s.error();
  if (!impl_->close()) return Error{path_, message("the session file was not closed cleanly"), hdf5Cause()};
  if (const Status s = impl_->journaled->commit(true); !s) {
    return failed(Error{path_, message("the session file was not closed cleanly"), impl_->journaled->error()});
  }
  impl_->journaled->removeJournal();
  return Done{};
}

}  // namespace stillcut::record
