#include "core/formats/hdf5/isolated_reader.h"

#include <cstring>
#include <span>
#include <utility>

#include "core/formats/hdf5/isolated_process.h"

namespace stillcut::record {
namespace {

using apart::MessageType;

// What another process says of a step is not trusted with places in memory.
bool withinBounds(const StepRecord& step) {
  const auto fits = [](int count, int most) { return count >= 0 && count <= most; };
  return fits(step.input.inputCount, kMaxInputsPerStep) && fits(step.output.verdictCount, kMaxDetectors) &&
         fits(step.output.eventCount, kMaxEventsPerStep);
}

class IsolatedReader final : public RecordingReader {
 public:
  IsolatedReader(std::unique_ptr<IsolatedProcess> process, RecordingFormat format)
      : process_(std::move(process)), format_(std::move(format)) {}

  const RecordingFormat& format() const override { return format_; }

  const StepRecord* recordedStep() const override { return haveStep_ ? &step_ : nullptr; }

  Result<bool> read(SampleBlock& block) override {
    haveStep_ = false;
    if (ended_) return false;
    const auto heard = ask({apart::Request::Kind::Block, block.capacityFrames, 0});
    if (!heard) return heard.error();
    const auto& [word, bytes] = *heard;
    if (word == MessageType::Refused) return apart::errorFrom(bytes);
    ended_ = word == MessageType::End;
    if (ended_) return false;
    return take(block, bytes) ? Result<bool>(true) : process_->died();
  }

  Result<bool> seek(Instant time) override {
    haveStep_ = false;
    const auto heard = ask({apart::Request::Kind::Seek, 0, toNs(time)});
    if (!heard) return heard.error();
    const auto& [word, bytes] = *heard;
    if (word == MessageType::Refused) return apart::errorFrom(bytes);
    const bool can = word != MessageType::End;
    ended_ = ended_ && !can;
    return can;
  }

 private:
  Result<std::pair<MessageType, std::string>> ask(const apart::Request& request) const {
    if (!apart::send(process_->peer(), std::as_bytes(std::span(&request, 1)))) return process_->died();
    return process_->hear();
  }

  bool take(SampleBlock& block, const std::string& bytes) {
    apart::BlockHead head;
    if (bytes.size() < sizeof head) return false;
    std::memcpy(&head, bytes.data(), sizeof head);
    const auto frames = static_cast<std::size_t>(head.frames);
    const std::size_t samples = frames * format_.channels.size() * sizeof(float);
    const std::size_t step = head.hasStep != 0 ? apart::kStepBytes : 0;
    if (head.frames < (step > 0 ? 0 : 1) || head.frames > block.capacityFrames ||
        bytes.size() != sizeof head + samples + step) {
      return false;
    }
    block.source = head.source;
    block.sequence = head.sequence;
    block.lostFrames = head.lostFrames;
    block.firstSample = instantFromNs(head.firstSample_ns);
    block.frames = head.frames;
    block.flags = head.flags;
    block.rate = Hertz(head.rate);
    const char* from = bytes.data() + sizeof head;
    for (int c = 0; c < block.channels; ++c, from += frames * sizeof(float)) {
      std::memcpy(block.channel(c).data(), from, frames * sizeof(float));
    }
    if (step == 0) return true;
    apart::unpackStep({from, step}, step_);
    step_.input.block = block;
    step_.input.block.flags = head.stepFlags;
    haveStep_ = withinBounds(step_);
    return haveStep_;
  }

  std::unique_ptr<IsolatedProcess> process_;
  RecordingFormat format_;
  StepRecord step_;
  bool haveStep_ = false;
  bool ended_ = false;
};

}  // namespace

Result<std::unique_ptr<RecordingReader>> openIsolated(const std::string& path, const std::string& inner,
                                                      const ReadOptions& options, IsolatedProgram program) {
  auto process = std::make_unique<IsolatedProcess>(std::move(program));
  if (const Status started = process->start(path, inner, apart::toJson(options)); !started) return started.error();
  const auto heard = process->hear();
  if (!heard) return heard.error();
  const auto& [word, bytes] = *heard;
  if (word == MessageType::Refused) return apart::errorFrom(bytes);
  return std::unique_ptr<RecordingReader>(new IsolatedReader(std::move(process), apart::formatFrom(bytes)));
}

}  // namespace stillcut::record
