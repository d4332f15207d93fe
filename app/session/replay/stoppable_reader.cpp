#include "app/session/replay/stoppable_reader.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "core/evaluate/scenario_reader.h"

namespace stillcut::app {
namespace {

class StoppableReader final : public record::RecordingReader {
 public:
  StoppableReader(std::unique_ptr<record::RecordingReader> reader, std::string path, BackgroundTask::Progress& progress)
      : reader_(std::move(reader)), path_(std::move(path)), progress_(progress) {}
  const record::RecordingFormat& format() const override { return reader_->format(); }
  Result<bool> read(SampleBlock& block) override {
    if (progress_.stopped()) return Error{path_, message("stopped")};
    auto more = reader_->read(block);
    if (more && *more) {
      frames_ += block.frames;
      const auto all = static_cast<double>(std::max<std::int64_t>(format().frames, 1));
      progress_.part.store(std::min(static_cast<double>(frames_) / all, 1.0), std::memory_order_relaxed);
    }
    return more;
  }
  Result<bool> seek(Instant time) override { return reader_->seek(time); }
  const StepRecord* recordedStep() const override { return reader_->recordedStep(); }

 private:
  std::unique_ptr<record::RecordingReader> reader_;
  std::string path_;
  BackgroundTask::Progress& progress_;
  std::int64_t frames_ = 0;
};

}  // namespace

record::OpenCut openStoppable(BackgroundTask::Progress& progress) {
  return [&progress](const std::string& path,
                     const record::ReadOptions& options) -> Result<std::unique_ptr<record::RecordingReader>> {
    auto reader = evaluate::openCut(path, options);
    if (!reader) return reader.error();
    return std::unique_ptr<record::RecordingReader>(
        std::make_unique<StoppableReader>(std::move(reader).value(), path, progress));
  };
}

}  // namespace stillcut::app
