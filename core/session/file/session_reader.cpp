#include "core/session/file/session_reader.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/model/block_copy.h"
#include "core/session/file/session_layout.h"
#include "core/session/file/session_open.h"
#include "core/session/file/session_samples.h"
#include "core/session/file/session_segments.h"
#include "core/session/file/session_table.h"

namespace stillcut::record {
namespace {

// Rows of one table that belong to steps, in their order: hands out those of one step after the other.
template <class Row>
class StepRows {
 public:
  bool open(hid_t file, const char* path) { return reader_.open(file, path); }
  // The next row of `step`, nullptr when there is none left.
  const Row* next(std::uint64_t step, bool& damaged) {
    const Row* row = reader_.at(next_, damaged);
    if (row == nullptr || row->step > step) return nullptr;
    if (row->step < step) {
      damaged = true;
      return nullptr;
    }
    ++next_;
    return row;
  }
  // To the first row of `step`.
  bool seek(std::uint64_t step) {
    bool damaged = false;
    std::uint64_t low = 0, high = reader_.rows();
    while (low < high && !damaged) {
      const std::uint64_t middle = low + (high - low) / 2;
      const Row* row = reader_.at(middle, damaged);
      (row != nullptr && row->step < step ? low : high) = row != nullptr && row->step < step ? middle + 1 : middle;
    }
    next_ = low;
    return !damaged;
  }

 private:
  TableReader<Row> reader_;
  std::uint64_t next_ = 0;
};

class SessionReader final : public RecordingReader {
 public:
  static Result<std::unique_ptr<RecordingReader>> open(OpenedSession opened, const std::string& path,
                                                       const ReadOptions& options) {
    std::unique_ptr<SessionReader> reader(new SessionReader(path));
    if (const Status s = reader->use(std::move(opened), options); !s) return s.error();
    return std::unique_ptr<RecordingReader>(std::move(reader));
  }

  const RecordingFormat& format() const override { return format_; }
  const StepRecord* recordedStep() const override { return haveStep_ ? &current_ : nullptr; }

  Result<bool> seek(Instant time) override {
    haveStep_ = false;
    quietHdf5();
    if (segments_.empty() && !readSegments(file_.get(), segments_)) {
      return Error{path_, message("its times cannot be read"), hdf5Cause()};
    }
    const std::uint64_t frame = frameAt(segments_, static_cast<std::uint64_t>(format_.frames), time);
    bool damaged = false;
    std::uint64_t low = 0, high = steps_;  // the first step that ends after the frame
    while (low < high && !damaged) {
      const std::uint64_t middle = low + (high - low) / 2;
      const BlockRow* row = blocks_.at(middle, damaged);
      const bool before = row != nullptr && row->offset + static_cast<std::uint64_t>(row->frames) <= frame;
      (before ? low : high) = before ? middle + 1 : middle;
    }
    step_ = low;
    if (damaged || !inputs_.seek(step_) || !verdicts_.seek(step_) || !commands_.seek(step_) || !events_.seek(step_)) {
      return Error{path_, message("the session file is damaged"), hdf5Cause()};
    }
    return true;
  }

  Result<bool> read(SampleBlock& block) override {
    haveStep_ = false;
    if (step_ >= steps_) return false;
    quietHdf5();
    if (!readStep()) {
      return Error{path_ + ": step " + std::to_string(step_), message("the session file is damaged"), hdf5Cause()};
    }
    const SampleBlock& recorded = current_.input.block;
    if (recorded.frames > block.capacityFrames || recorded.channels != block.channels) {
      return Error{path_ + ": step " + std::to_string(step_), message("the block does not fit where it is read to")};
    }
    copyBlock(recorded, block);
    ++step_;
    if (step_ == steps_) block.flags |= kBlockEnd;
    haveStep_ = true;
    return true;
  }

 private:
  explicit SessionReader(std::string path) : path_(std::move(path)) {}

  Status use(OpenedSession opened, const ReadOptions& options) {
    Result<RecordingFormat> format = readSessionFormat(opened, path_);
    if (!format) return format.error();
    format_ = std::move(*format);
    journaled_ = std::move(opened.journaled);
    file_ = std::move(opened.file);
    reasons_ = ReasonCodes(readText(file_.get(), "reason_codes").value_or(""));
    std::uint64_t frames = 0;
    picked_ = options.channels;
    for (int c = 0; options.channels.empty() && c < static_cast<int>(format_.channels.size()); ++c)
      picked_.push_back(c);
    Result<std::vector<RecordedChannel>> kept = keepChannels(format_.channels, options.channels, path_);
    if (!kept) return kept.error();
    format_.channels = std::move(*kept);
    if (const Status s = applyOptions(format_.channels, options); !s) return s.error();
    for (const int c : picked_) {
      SampleReader samples;
      if (!samples.open(file_.get(), c)) return Error{path_, message("the samples cannot be read"), hdf5Cause()};
      frames = samples_.empty() ? samples.frames() : std::min(frames, samples.frames());
      samples_.push_back(std::move(samples));
    }
    if (!blocks_.open(file_.get(), kBlocksPath) || !machine_.open(file_.get(), kMachinePath) ||
        !decisions_.open(file_.get(), kDecisionsPath) || !inputs_.open(file_.get(), kInputsPath) ||
        !verdicts_.open(file_.get(), kVerdictsPath) || !commands_.open(file_.get(), kCommandsPath) ||
        !events_.open(file_.get(), kEventsPath)) {
      return Error{path_, message("a table is missing or has another layout"), hdf5Cause()};
    }
    return findLastStep(frames);
  }

  // The last step of which all is there: after a crash the tables may have grown unevenly.
  Status findLastStep(std::uint64_t frames) {
    steps_ = std::min({blocks_.rows(), machine_.rows(), decisions_.rows()});
    bool damaged = false;
    const auto complete = [&](const BlockRow* row) {
      return row != nullptr && row->frames >= 0 && row->offset <= frames &&
             static_cast<std::uint64_t>(row->frames) <= frames - row->offset;
    };
    while (steps_ > 0 && !damaged && !complete(blocks_.at(steps_ - 1, damaged))) --steps_;
    if (damaged) return Error{path_, message("the table of blocks cannot be read"), hdf5Cause()};
    format_.blocks = static_cast<std::int64_t>(steps_);
    if (steps_ > 0) {
      const BlockRow* last = blocks_.at(steps_ - 1, damaged);
      format_.frames = static_cast<std::int64_t>(last->offset) + last->frames;
    }
    SampleBlock& block = current_.input.block;
    block.allocate(static_cast<int>(picked_.size()), format_.blockFrames);
    return Done{};
  }

  // False: damaged.
  bool readStep() {
    bool damaged = false;
    current_.output = StepOutput{};
    const BlockRow* block = blocks_.at(step_, damaged);
    const MachineRow* machine = machine_.at(step_, damaged);
    const DecisionRow* decision = decisions_.at(step_, damaged);
    if (block == nullptr || machine == nullptr || decision == nullptr) return false;
    if (block->frames < 0 || block->frames > format_.blockFrames || !(block->rate > 0.0) ||
        !std::isfinite(block->rate)) {
      return false;
    }
    fromRow(*block, current_.input.block);
    fromRow(*machine, current_.input.machine);
    if (!fromRow(*decision, current_.output)) return false;
    translate(current_.output.request.reason);
    for (std::size_t c = 0; c < samples_.size(); ++c) {
      if (!samples_[c].read(block->offset, current_.input.block.channel(static_cast<int>(c)))) return false;
    }
    return readInputs() && readOutputs();
  }

  void translate(Reason& reason) const { reason.code = reasons_.fromFile(reason.code); }

  bool readInputs() {
    bool damaged = false;
    StepInput& input = current_.input;
    input.inputCount = 0;
    input.inputs = {};
    while (const InputRow* row = inputs_.next(step_, damaged)) {
      if (input.inputCount >= kMaxInputsPerStep) return false;
      if (!fromRow(*row, input.inputs[static_cast<std::size_t>(input.inputCount++)])) return false;
    }
    return !damaged;
  }

  bool readOutputs() {
    bool damaged = false;
    StepOutput& output = current_.output;
    while (const VerdictRow* row = verdicts_.next(step_, damaged)) {
      if (output.verdictCount >= kMaxDetectors || row->detector != output.verdictCount) return false;
      Verdict& verdict = output.verdicts[static_cast<std::size_t>(output.verdictCount++)];
      if (!fromRow(*row, verdict)) return false;
      translate(verdict.reason);
    }
    while (const CommandRow* row = commands_.next(step_, damaged)) {
      if (output.hasCommand) return false;
      output.hasCommand = true;
      fromRow(*row, output.command);
      translate(output.command.reason);
    }
    while (const EventRow* row = events_.next(step_, damaged)) {
      if (output.eventCount >= kMaxEventsPerStep) return false;
      Event& event = output.events[static_cast<std::size_t>(output.eventCount++)];
      fromRow(*row, event);
      translate(event.reason);
    }
    return !damaged;
  }

  std::string path_;
  std::unique_ptr<JournaledFile> journaled_;
  Hdf5Id file_;
  RecordingFormat format_;
  ReasonCodes reasons_{""};
  std::vector<int> picked_;
  std::vector<SampleReader> samples_;
  TableReader<BlockRow> blocks_;
  TableReader<MachineRow> machine_;
  TableReader<DecisionRow> decisions_;
  StepRows<InputRow> inputs_;
  StepRows<VerdictRow> verdicts_;
  StepRows<CommandRow> commands_;
  StepRows<EventRow> events_;
  std::vector<SegmentRow> segments_;  // read when first needed
  std::uint64_t steps_ = 0;
  std::uint64_t step_ = 0;
  StepRecord current_;
  bool haveStep_ = false;
};

}  // namespace

Result<std::unique_ptr<RecordingReader>> here::openSession(const std::string& path, const ReadOptions& options) {
  Result<OpenedSession> opened = openSessionFile(path);
  if (!opened) return opened.error();
  return SessionReader::open(std::move(*opened), path, options);
}

}  // namespace stillcut::record
