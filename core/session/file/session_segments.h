// Where the steps of a session lie in time: pieces without a gap, so that a moment is found without reading every
// block. Thread: one at a time.
#pragma once

#include <cstdint>
#include <vector>

#include "core/session/file/session_rows.h"
#include "core/storage/hdf5_file.h"

namespace stillcut::record {

// Writing: says where a new piece begins.
class SegmentFinder {
 public:
  // True: this block, the next one, does not follow from those before.
  bool begins(const BlockRow& block);

 private:
  bool started_ = false;
  SegmentRow open_;
};

// The pieces of a file in their order; a file without them (of an older version) is read through. False: damaged.
bool readSegments(hid_t file, std::vector<SegmentRow>& segments);

// The frame that is taken at `time`, and back. Between pieces: the first frame of the next one.
std::uint64_t frameAt(const std::vector<SegmentRow>& segments, std::uint64_t frames, Instant time);
// The piece that `frame` lies in; `segments` must not be empty.
const SegmentRow& segmentOf(const std::vector<SegmentRow>& segments, std::uint64_t frame);
// Whether `frame` is taken less than a sample from `time`.
bool withinSample(const std::vector<SegmentRow>& segments, std::uint64_t frame, Instant time);
Instant timeOf(const SegmentRow& segment, std::uint64_t frame);

}  // namespace stillcut::record
