// What is missing in a file of a format that cannot say so: a short table beside it, "cut.wav.gaps.csv", with a line
// for every gap. Export writes it where it has filled gaps with zeros; a recording that has one beside it is read with
// its gaps, so that zeros nobody has measured are never taken for silence. Plain values: any thread.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/formats/recording_reader.h"

namespace stillcut::record {

struct FilledGap {
  std::int64_t first = 0;   // frame of the file, from 0
  std::int64_t frames = 0;  // 0: how many are missing is not known
};

std::string gapListPath(const std::string& recording);
// Header "first_frame,frames,from_s,to_s". Without gaps a list of an earlier file of that name is removed.
Status writeGapList(const std::string& recording, const std::vector<FilledGap>& gaps, Hertz rate);

// `whole` without the frames that the list beside `recording` names, and with gaps where they were; `whole` itself
// where there is no list. Error: the list is not one of this recording; one line.
Result<std::unique_ptr<RecordingReader>> openWithGaps(std::unique_ptr<RecordingReader> whole,
                                                      const std::string& recording);

}  // namespace stillcut::record
