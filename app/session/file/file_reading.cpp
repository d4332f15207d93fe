#include "app/session/file/file_reading.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "app/session/file/indicator_curve.h"
#include "app/session/file/state_track.h"
#include "app/session/session_view.h"
#include "core/evaluate/scenario_reader.h"
#include "ui/base/say.h"

namespace stillcut::app {
namespace {

constexpr int kBlockFrames = 4096;
constexpr double kLongestGap_s = 3600.0;  // drawn as long as it was

ui::FileContents describe(const std::string& path, const record::RecordingFormat& format) {
  ui::FileContents contents;
  contents.path = QString::fromStdString(path);
  contents.kind = ui::sayCore(format.kind);
  contents.rate = format.rate;
  contents.wallMs = format.started_ns / 1'000'000;
  contents.job = QString::fromStdString(format.job);
  if (format.setup) {
    contents.tool = QString::fromStdString(format.setup->tool);
    contents.told = {format.setup->teeth, format.setup->nominalSpeed};
  }
  for (const Message& note : format.notes) contents.notes << ui::sayCore(note);
  for (const record::RecordedChannel& channel : format.channels) {
    ui::FileChannel shown;
    shown.name = QString::fromStdString(channel.info.name);
    shown.unit = channel.quantityKnown || channel.unit.empty() ? viewText(siUnit(channel.info.quantity))
                                                               : QString::fromStdString(channel.unit);
    contents.channels.push_back(std::move(shown));
  }
  return contents;
}

class Reading {
 public:
  Reading(ui::FileContents contents, std::shared_ptr<evaluate::SampleStore> samples,
          const record::RecordingFormat& format)
      : contents_(std::move(contents)), samples_(std::move(samples)), format_(format) {
    scaled_.resize(format.channels.size());
  }

  Status add(const SampleBlock& block, const StepRecord* step) {
    if (block.has(kBlockGap) && frames_ > 0) {
      if (Status kept = skip(block.lostFrames); !kept) return kept;
    }
    const auto channels = static_cast<std::size_t>(block.channels);
    std::vector<std::span<const float>> spans;
    for (std::size_t c = 0; c < channels; ++c) {
      const std::span<const float> raw = block.channel(static_cast<int>(c));
      scaled_[c].resize(raw.size());
      const auto scale = static_cast<float>(format_.channels[c].info.scale);
      std::transform(raw.begin(), raw.end(), scaled_[c].begin(), [scale](float v) { return v * scale; });
      contents_.channels[c].wave.add(scaled_[c]);
      spans.emplace_back(scaled_[c]);
    }
    const double begin = static_cast<double>(frames_) / contents_.rate.value;
    frames_ += block.frames;
    if (step != nullptr && step->output.verdictCount > 0) {
      recorded_ = true;
      const Verdict& inCharge = step->output.verdicts[static_cast<std::size_t>(step->output.inCharge)];
      const Seconds end(static_cast<double>(frames_) / contents_.rate.value);
      track_.add(inCharge, Seconds(begin), end);
      curve_.add(inCharge, Seconds(begin), end);
    }
    return samples_->append(spans);
  }

  FileReading finish() {
    contents_.length = Seconds(static_cast<double>(frames_) / contents_.rate.value);
    if (recorded_) {
      constexpr double kNoLimit = std::numeric_limits<double>::quiet_NaN();  // that of then is not known
      contents_.recorded = ui::FileTrack{ui::say("Recorded"), track_.states(), curve_.curve({}, kNoLimit)};
    }
    return {std::make_shared<const ui::FileContents>(std::move(contents_)), std::move(samples_)};
  }
  std::int64_t frames() const { return frames_; }

 private:
  Status skip(std::uint64_t lost) {
    const double most = kLongestGap_s * contents_.rate.value;
    auto left = static_cast<std::int64_t>(std::min(static_cast<double>(lost), most));
    std::vector<float> nothing;
    while (left > 0) {
      const std::int64_t now = std::min<std::int64_t>(left, 65536);
      nothing.assign(static_cast<std::size_t>(now), std::numeric_limits<float>::quiet_NaN());
      for (ui::FileChannel& channel : contents_.channels) channel.wave.add(nothing);
      const std::vector<std::span<const float>> spans(contents_.channels.size(), nothing);
      if (Status kept = samples_->append(spans); !kept) return kept;
      frames_ += now;
      left -= now;
    }
    return Done{};
  }

  ui::FileContents contents_;
  std::shared_ptr<evaluate::SampleStore> samples_;
  const record::RecordingFormat& format_;
  std::vector<std::vector<float>> scaled_;
  StateTrack track_;
  IndicatorCurve curve_;
  bool recorded_ = false;
  std::int64_t frames_ = 0;
};

}  // namespace

record::ReadOptions readOptions(const ui::FileTiming& timing) {
  record::ReadOptions options;
  if (timing.rate.value > 0.0) options.rate = timing.rate;
  if (timing.secondsPerTime > 0.0) options.secondsPerTime = timing.secondsPerTime;
  return options;
}

ui::FileLack lackOf(const std::string& path) {
  const auto opens = [&path](const ui::FileTiming& timing) {
    return evaluate::openCut(path, readOptions(timing)).ok();
  };
  if (opens({Hertz(), 1.0})) return ui::FileLack::TimeUnit;
  return opens({Hertz(1000.0), 0.0}) ? ui::FileLack::Rate : ui::FileLack::None;
}

Result<FileReading> readFile(const std::string& path, const ui::FileTiming& timing,
                             BackgroundTask::Progress& progress) {
  auto reader = evaluate::openCut(path, readOptions(timing));
  if (!reader) return reader.error();
  const record::RecordingFormat format = (*reader)->format();
  auto samples = evaluate::SampleStore::make(static_cast<int>(format.channels.size()));
  if (!samples) return samples.error();
  Reading reading(describe(path, format), *samples, format);
  SampleBlock block;
  block.allocate(static_cast<int>(format.channels.size()), format.blockFrames > 0 ? format.blockFrames : kBlockFrames);
  const double all = std::max(static_cast<double>(format.frames), 1.0);
  for (;;) {
    const Result<bool> more = (*reader)->read(block);
    if (!more) return more.error();
    if (!*more) break;
    if (Status kept = reading.add(block, (*reader)->recordedStep()); !kept) return kept.error();
    progress.part.store(static_cast<double>(reading.frames()) / all, std::memory_order_relaxed);
    if (progress.stopped()) return Error{path, message("stopped")};
  }
  if (reading.frames() == 0) return Error{path, message("holds no samples")};
  return reading.finish();
}

}  // namespace stillcut::app
