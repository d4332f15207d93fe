#include "core/record/session_writer.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <utility>
#include <vector>

#include "core/record/hdf5_file.h"
#include "core/record/session_layout.h"
#include "core/record/session_table.h"

namespace stillcut::record {
namespace {

// One channel's samples, as recorded.
class SampleColumn {
 public:
  bool create(hid_t file, int index, const ChannelInfo& info) {
    const hsize_t none = 0;
    const hsize_t unlimited = H5S_UNLIMITED;
    const hsize_t chunk = kSampleChunk;
    const Hdf5Id space(H5Screate_simple(1, &none, &unlimited));
    const Hdf5Id properties(H5Pcreate(H5P_DATASET_CREATE));
    H5Pset_chunk(properties.get(), 1, &chunk);
    const Hdf5Id links(H5Pcreate(H5P_LINK_CREATE));
    H5Pset_create_intermediate_group(links.get(), 1);
    dataset_ = Hdf5Id(H5Dcreate2(file, samplesPath(index).c_str(), H5T_NATIVE_FLOAT, space.get(), links.get(),
                                 properties.get(), H5P_DEFAULT));
    return dataset_ && writeText(dataset_.get(), "name", info.name) &&
           writeText(dataset_.get(), "quantity", std::string(name(info.quantity))) &&
           writeText(dataset_.get(), "unit", std::string(siUnit(info.quantity))) &&
           writeNumber(dataset_.get(), "scale", info.scale) && writeText(dataset_.get(), "axis", info.axis);
  }
  void add(std::span<const float> samples) { pending_.insert(pending_.end(), samples.begin(), samples.end()); }
  std::size_t pending() const { return pending_.size(); }
  bool write() {
    if (pending_.empty()) return true;
    const hsize_t start = frames_;
    const hsize_t size = pending_.size();
    const hsize_t length = start + size;
    if (H5Dset_extent(dataset_.get(), &length) < 0) return false;
    const Hdf5Id file(H5Dget_space(dataset_.get()));
    const Hdf5Id memory(H5Screate_simple(1, &size, nullptr));
    H5Sselect_hyperslab(file.get(), H5S_SELECT_SET, &start, nullptr, &size, nullptr);
    if (H5Dwrite(dataset_.get(), H5T_NATIVE_FLOAT, memory.get(), file.get(), H5P_DEFAULT, pending_.data()) < 0) {
      return false;
    }
    frames_ = length;
    pending_.clear();
    return H5Dflush(dataset_.get()) >= 0;
  }
  void close() { dataset_.reset(); }

 private:
  Hdf5Id dataset_;
  std::vector<float> pending_;
  std::uint64_t frames_ = 0;
};

bool writeHeader(hid_t file, const SessionHeader& header) {
  const CutSetup& s = header.setup;
  const Hdf5Id setup(H5Gcreate2(file, "setup", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  return writeText(file, "format", kSessionFormat) && writeInteger(file, "format_version", kSessionVersion) &&
         writeText(file, "program", "Stillcut") && writeText(file, "program_version", header.programVersion) &&
         writeText(file, "configuration", header.configuration) &&
         writeText(file, "reason_codes", reasonIdentifiers()) &&
         writeInteger(file, "simulated", header.simulated ? 1 : 0) && setup &&
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

}  // namespace

struct SessionWriter::Impl {
  Hdf5Id file;
  std::vector<SampleColumn> samples;
  TableWriter<MachineRow> machine;
  TableWriter<DecisionRow> decisions;
  TableWriter<InputRow> inputs;
  TableWriter<VerdictRow> verdicts;
  TableWriter<CommandRow> commands;
  TableWriter<EventRow> events;
  TableWriter<TruthRow> truth;
  TableWriter<TruthSampleRow> truthSeries;
  TableWriter<BlockRow> blocks;
  std::uint64_t steps = 0;
  std::uint64_t frames = 0;
  Instant flushedUpTo{};
  bool closed = false;

  bool create(const std::string& part, const SessionHeader& header) {
    const Hdf5Id access(H5Pcreate(H5P_FILE_ACCESS));
    H5Pset_libver_bounds(access.get(), H5F_LIBVER_LATEST, H5F_LIBVER_LATEST);
    file = Hdf5Id(H5Fcreate(part.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.get()));
    if (!file || !writeHeader(file.get(), header)) return false;
    samples.resize(header.setup.channels.size());
    for (std::size_t c = 0; c < samples.size(); ++c) {
      if (!samples[c].create(file.get(), static_cast<int>(c), header.setup.channels[c])) return false;
    }
    return machine.create(file.get(), kMachinePath) && decisions.create(file.get(), kDecisionsPath) &&
           inputs.create(file.get(), kInputsPath) && verdicts.create(file.get(), kVerdictsPath) &&
           commands.create(file.get(), kCommandsPath) && events.create(file.get(), kEventsPath) &&
           truth.create(file.get(), kTruthPath) && truthSeries.create(file.get(), kTruthSeriesPath) &&
           blocks.create(file.get(), kBlocksPath) && H5Fstart_swmr_write(file.get()) >= 0;
  }
  // The blocks go last: a reader that sees a block finds everything that belongs to it.
  bool write() {
    return std::all_of(samples.begin(), samples.end(), [](SampleColumn& s) { return s.write(); }) && machine.write() &&
           decisions.write() && inputs.write() && verdicts.write() && commands.write() && events.write() &&
           truth.write() && truthSeries.write() && blocks.write() && H5Fflush(file.get(), H5F_SCOPE_LOCAL) >= 0;
  }
  bool close() {
    closed = true;
    for (SampleColumn& s : samples) s.close();
    machine.close();
    decisions.close();
    inputs.close();
    verdicts.close();
    commands.close();
    events.close();
    truth.close();
    truthSeries.close();
    blocks.close();
    return file.reset();
  }
};

SessionWriter::SessionWriter(std::string path, std::unique_ptr<Impl> impl)
    : path_(std::move(path)), impl_(std::move(impl)) {}

SessionWriter::~SessionWriter() {
  (void)close().ok();
}

Result<std::unique_ptr<SessionWriter>> SessionWriter::create(const std::string& path, const SessionHeader& header) {
  quietHdf5();
  const auto channels = static_cast<int>(header.setup.channels.size());
  if (channels < 1 || channels > kMostChannels || !(header.setup.rate.value > 0.0) || header.setup.blockFrames < 1) {
    return Error{path, "cannot be recorded", "channels, rate and block length must be known before"};
  }
  const std::string part = path + ".part";
  auto impl = std::make_unique<Impl>();
  if (!impl->create(part, header) || std::rename(part.c_str(), path.c_str()) != 0) {
    const std::string cause = hdf5Cause();
    impl->close();
    std::remove(part.c_str());
    return Error{path, "the session file cannot be created", cause};
  }
  return std::unique_ptr<SessionWriter>(new SessionWriter(path, std::move(impl)));
}

Status SessionWriter::failed(const char* doing) {
  const std::string cause = hdf5Cause();
  impl_->close();
  return Error{path_, std::string("recording failed while ") + doing, cause};
}

Status SessionWriter::add(const StepInput& input, const StepOutput& output) {
  if (impl_->closed) return Error{path_, "the session is closed", ""};
  const SampleBlock& block = input.block;
  if (block.channels != static_cast<int>(impl_->samples.size())) {
    return Error{path_, "a block has " + std::to_string(block.channels) + " channels", "the session has others"};
  }
  const std::uint64_t step = impl_->steps++;
  for (int c = 0; c < block.channels; ++c) impl_->samples[static_cast<std::size_t>(c)].add(block.channel(c));
  impl_->blocks.add(toRow(block, impl_->frames));
  impl_->frames += static_cast<std::uint64_t>(block.frames);
  impl_->machine.add(toRow(input.machine));
  impl_->decisions.add(toRow(output));
  for (int i = 0; i < input.inputCount; ++i) impl_->inputs.add(toRow(input.inputs[static_cast<std::size_t>(i)], step));
  for (int i = 0; i < output.verdictCount; ++i) {
    impl_->verdicts.add(toRow(output.verdicts[static_cast<std::size_t>(i)], i, step));
  }
  if (output.hasCommand) impl_->commands.add(toRow(output.command, step));
  for (int i = 0; i < output.eventCount; ++i)
    impl_->events.add(toRow(output.events[static_cast<std::size_t>(i)], step));
  constexpr Duration kFlushEvery = std::chrono::milliseconds(500);
  if (step == 0) impl_->flushedUpTo = block.firstSample;
  const bool due = block.end() - impl_->flushedUpTo >= kFlushEvery;
  if (due || impl_->samples.front().pending() >= kSampleChunk) {
    impl_->flushedUpTo = block.end();
    return flush();
  }
  return Done{};
}

Status SessionWriter::addTruth(std::string_view name, double value) {
  if (impl_->closed) return Error{path_, "the session is closed", ""};
  impl_->truth.add({truthName(name), value});
  return Done{};
}

Status SessionWriter::addTruth(std::string_view name, Instant time, double value) {
  if (impl_->closed) return Error{path_, "the session is closed", ""};
  impl_->truthSeries.add({truthName(name), toNs(time), value});
  return Done{};
}

Status SessionWriter::flush(bool toDisk) {
  if (impl_->closed) return Error{path_, "the session is closed", ""};
  quietHdf5();
  if (!impl_->write()) return failed("writing");
  int* descriptor = nullptr;
  if (toDisk && H5Fget_vfd_handle(impl_->file.get(), H5P_DEFAULT, reinterpret_cast<void**>(&descriptor)) >= 0 &&
      fdatasync(*descriptor) != 0) {
    const std::string cause = std::strerror(errno);
    impl_->close();
    return Error{path_, "recording failed while writing to disk", cause};
  }
  return Done{};
}

Status SessionWriter::close() {
  if (impl_->closed) return Done{};
  if (const Status s = flush(); !s) return s.error();
  if (!impl_->close()) return Error{path_, "the session file was not closed cleanly", hdf5Cause()};
  return Done{};
}

}  // namespace stillcut::record
