#include "core/session/convert_recording.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "core/formats/recording_sink.h"
#include "core/session/file/session_reader.h"
#include "core/session/session_folder.h"

namespace stillcut::record {
namespace {

constexpr int kBlockFrames = 4096;

Result<std::unique_ptr<RecordingReader>> openPart(const std::string& from, const ReadOptions& options,
                                                  const TimeSpan& span, const OpenCut& open) {
  Result<std::unique_ptr<RecordingReader>> reader = open(from, options);
  if (!reader || span.whole()) return reader;
  return openSpan(std::move(*reader), span, from);
}

// Calls `take` for every block; its first error ends it.
template <class Take>
Status forEachBlock(RecordingReader& reader, Take take) {
  SampleBlock block;
  const int frames = std::max(kBlockFrames, reader.format().blockFrames);
  block.allocate(static_cast<int>(reader.format().channels.size()), frames);
  while (true) {
    const Result<bool> more = reader.read(block);
    if (!more) return more.error();
    if (!*more) return Done{};
    if (const Status s = take(block); !s) return s.error();
  }
}

Status checkGap(const SampleBlock& after, const std::string& to) {
  // A gap longer than this is no gap but a pause; a recording of mostly zeros helps nobody.
  constexpr double kLongestGap = 60.0;
  const double seconds = static_cast<double>(after.lostFrames) / after.rate.value;
  if (seconds <= kLongestGap) return Done{};
  return Error{to, message("a gap of %1 s", std::to_string(seconds)),
               message("convert to CSV instead, or a span without it")};
}

Status look(RecordingReader& reader, const std::string& to, ExportPlan& plan) {
  plan.peaks.assign(plan.channels.size(), 0.0);
  return forEachBlock(reader, [&](const SampleBlock& block) -> Status {
    if (block.has(kBlockGap)) {
      if (const Status s = checkGap(block, to); !s) return s.error();
      const auto lost = static_cast<std::int64_t>(block.lostFrames);
      plan.gaps.push_back({plan.frames, lost});
      plan.frames += lost;
    }
    plan.frames += block.frames;
    for (std::size_t c = 0; c < plan.peaks.size(); ++c) {
      const double scale = std::abs(plan.channels[c].info.scale);
      for (const float v : block.channel(static_cast<int>(c))) {
        plan.peaks[c] = std::max(plan.peaks[c], scale * static_cast<double>(std::abs(v)));
      }
    }
    return Done{};
  });
}

Status fillGap(RecordingSink& sink, const SampleBlock& after, GapStyle style, const std::string& to) {
  if (const Status s = checkGap(after, to); !s) return s.error();
  SampleBlock filled;
  filled.allocate(after.channels, kBlockFrames);
  if (style == GapStyle::NotANumber) std::fill(filled.samples.begin(), filled.samples.end(), std::nanf(""));
  filled.rate = after.rate;
  for (std::uint64_t left = after.lostFrames; left > 0;) {
    filled.frames = static_cast<int>(std::min<std::uint64_t>(left, kBlockFrames));
    if (const Status s = sink.write(filled); !s) return s.error();
    left -= static_cast<std::uint64_t>(filled.frames);
  }
  return Done{};
}

}  // namespace

Status convertRecording(const std::string& from, const std::string& to, const ReadOptions& options,
                        const TimeSpan& span, const OpenCut& open) {
  if (Status free = checkReplaceable(to, MayReplace::NoSession); !free) return free;
  Result<std::unique_ptr<RecordingReader>> reader = openPart(from, options, span, open);
  if (!reader) return reader.error();
  ExportPlan plan;
  plan.channels = (*reader)->format().channels;
  plan.rate = (*reader)->format().rate;
  if ((*reader)->format().setup && isHdf5File(from)) {  // a session's clock does not begin with it
    const Result<SessionCounts> counts = countSession(from);
    if (!counts) return counts.error();
    plan.begin = counts->begin;
  }
  if (sinkNeedsLook(to)) {
    if (const Status s = look(**reader, to, plan); !s) return s.error();
    if (plan.frames == 0) return Error{from, message("the span holds no samples")};
    reader = openPart(from, options, span, open);
    if (!reader) return reader.error();
  }
  Result<std::unique_ptr<RecordingSink>> sink = createSink(to, plan);
  if (!sink) return sink.error();
  const GapStyle style = sinkGapStyle(to);
  std::int64_t frames = 0;
  std::int64_t filled = 0;
  std::vector<FilledGap> gaps;
  const Status copied = forEachBlock(**reader, [&](const SampleBlock& block) -> Status {
    if (block.has(kBlockGap) && style != GapStyle::Times) {
      if (const Status s = fillGap(**sink, block, style, to); !s) return s.error();
      gaps.push_back({frames + filled, static_cast<std::int64_t>(block.lostFrames)});
      filled += gaps.back().frames;
    }
    frames += block.frames;
    return (*sink)->write(block);
  });
  if (!copied) return copied.error();
  if (frames == 0) return Error{from, message("the span holds no samples")};
  if (const Status s = (*sink)->finish(); !s) return s.error();
  return style == GapStyle::Listed ? writeGapList(to, gaps, plan.rate) : Done{};
}

}  // namespace stillcut::record
