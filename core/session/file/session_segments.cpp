#include "core/session/file/session_segments.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/model/sample_block.h"
#include "core/session/file/session_layout.h"
#include "core/session/file/session_table.h"

namespace stillcut::record {
namespace {

// Times as files may lie about them never overflow.
double elapsedNs(const SegmentRow& segment, std::uint64_t frame) {
  return static_cast<double>(frame - segment.offset) / segment.rate * 1e9;
}

}  // namespace

bool SegmentFinder::begins(const BlockRow& block) {
  const bool follows = started_ && (block.flags & kBlockGap) == 0 && block.rate == open_.rate &&
                       std::abs(static_cast<double>(open_.firstSample) + elapsedNs(open_, block.offset) -
                                static_cast<double>(block.firstSample)) <= static_cast<double>(kSegmentDrift.count());
  if (follows) return false;
  open_ = {0, block.offset, block.firstSample, block.rate};
  started_ = true;
  return true;
}

bool readSegments(hid_t file, std::vector<SegmentRow>& segments) {
  bool damaged = false;
  segments.clear();
  if (H5Lexists(file, kSegmentsPath, H5P_DEFAULT) > 0) {
    TableReader<SegmentRow> stored;
    if (!stored.open(file, kSegmentsPath)) return false;
    for (std::uint64_t i = 0; const SegmentRow* row = stored.at(i, damaged); ++i) segments.push_back(*row);
  } else {
    TableReader<BlockRow> blocks;
    if (!blocks.open(file, kBlocksPath)) return false;
    SegmentFinder finder;
    for (std::uint64_t i = 0; const BlockRow* row = blocks.at(i, damaged); ++i) {
      if (finder.begins(*row)) segments.push_back({i, row->offset, row->firstSample, row->rate});
    }
  }
  const auto senseless = [](const SegmentRow& s) { return !(s.rate > 0.0) || !std::isfinite(s.rate); };
  return !damaged && std::none_of(segments.begin(), segments.end(), senseless) &&
         std::is_sorted(segments.begin(), segments.end(),
                        [](const SegmentRow& a, const SegmentRow& b) { return a.offset < b.offset; });
}

std::uint64_t frameAt(const std::vector<SegmentRow>& segments, std::uint64_t frames, Instant time) {
  const std::int64_t ns = toNs(time);
  const auto after = std::upper_bound(segments.begin(), segments.end(), ns,
                                      [](std::int64_t t, const SegmentRow& s) { return t < s.firstSample; });
  if (after == segments.begin()) return 0;
  const SegmentRow& segment = *std::prev(after);
  const std::uint64_t end = after == segments.end() ? frames : std::min(frames, after->offset);
  if (end <= segment.offset) return end;
  const double since_s = (static_cast<double>(ns) - static_cast<double>(segment.firstSample)) * 1e-9;
  const double frame = std::floor(since_s * segment.rate + 0.5);
  const auto length = static_cast<double>(end - segment.offset);
  return frame >= length ? end : segment.offset + static_cast<std::uint64_t>(std::max(0.0, frame));
}

const SegmentRow& segmentOf(const std::vector<SegmentRow>& segments, std::uint64_t frame) {
  const auto after = std::upper_bound(segments.begin(), segments.end(), frame,
                                      [](std::uint64_t f, const SegmentRow& s) { return f < s.offset; });
  return after == segments.begin() ? segments.front() : *std::prev(after);
}

bool withinSample(const std::vector<SegmentRow>& segments, std::uint64_t frame, Instant time) {
  if (segments.empty()) return false;
  const SegmentRow& segment = segmentOf(segments, frame);
  return std::abs(secondsBetween(time, timeOf(segment, frame)).value) * segment.rate < 1.0;
}

Instant timeOf(const SegmentRow& segment, std::uint64_t frame) {
  return instantFromNs(segment.firstSample) + toDuration(Seconds(elapsedNs(segment, frame) * 1e-9));
}

}  // namespace stillcut::record
