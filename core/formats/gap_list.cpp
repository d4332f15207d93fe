#include "core/formats/gap_list.h"

#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <utility>

#include "core/storage/part_file.h"

namespace stillcut::record {
namespace {

class GapReader final : public RecordingReader {
 public:
  GapReader(std::unique_ptr<RecordingReader> whole, std::vector<FilledGap> gaps)
      : whole_(std::move(whole)), format_(whole_->format()), gaps_(std::move(gaps)) {
    for (const FilledGap& gap : gaps_) format_.frames -= gap.frames;
  }

  const RecordingFormat& format() const override { return format_; }

  Result<bool> read(SampleBlock& block) override {
    std::uint64_t lost = 0;
    bool gap = false;
    while (true) {
      if (taken_ == piece_.frames) {
        if (piece_.capacityFrames != block.capacityFrames) piece_.allocate(block.channels, block.capacityFrames);
        Result<bool> more = whole_->read(piece_);
        if (!more || !*more) return more;
        taken_ = 0;
      }
      std::int64_t here = piece_.frames - taken_;
      if (missing_ == 0 && next_ < gaps_.size()) {
        here = std::min(here, gaps_[next_].first - frame_);
        if (here == 0) {
          gap = true;
          missing_ = gaps_[next_++].frames;
          continue;
        }
      }
      if (missing_ == 0) {
        give(block, static_cast<int>(here));
        block.lostFrames = lost;
        if (gap) block.flags |= kBlockGap;
        go(here);
        return true;
      }
      here = std::min(here, missing_);
      missing_ -= here;
      lost += static_cast<std::uint64_t>(here);
      go(here);
    }
  }

 private:
  void go(std::int64_t frames) {
    taken_ += static_cast<int>(frames);
    frame_ += frames;
  }
  void give(SampleBlock& block, int count) {
    block.frames = count;
    for (int c = 0; c < block.channels; ++c) {
      const std::span<const float> from = std::as_const(piece_).channel(c);
      std::copy_n(from.begin() + taken_, count, block.channel(c).begin());
    }
    block.sequence = sequence_++;
    block.rate = piece_.rate;
    block.firstSample = piece_.firstSample + toDuration(Seconds(taken_ / piece_.rate.value));
    delivered_ += count;
    block.flags = delivered_ >= format_.frames ? static_cast<std::uint32_t>(kBlockEnd) : 0U;
  }

  std::unique_ptr<RecordingReader> whole_;
  RecordingFormat format_;
  std::vector<FilledGap> gaps_;  // in order
  std::size_t next_ = 0;
  std::int64_t missing_ = 0;    // frames still to be left out
  SampleBlock piece_;           // of the file as it is
  int taken_ = 0;               // frames of it
  std::int64_t frame_ = 0;      // of the file
  std::int64_t delivered_ = 0;  // frames
  std::uint64_t sequence_ = 0;
};

Result<std::vector<FilledGap>> readGapList(const std::string& path, std::int64_t frames) {
  std::ifstream in(path);
  std::vector<FilledGap> gaps;
  std::string line;
  std::getline(in, line);
  std::int64_t end = 0;
  for (int number = 2; std::getline(in, line); ++number) {
    FilledGap gap;
    if (std::sscanf(line.c_str(), "%" SCNd64 ",%" SCNd64, &gap.first, &gap.frames) != 2 || gap.first < end ||
        gap.frames < 0 || gap.frames > frames - gap.first) {
      return Error{path + ":" + std::to_string(number), message("is no gap of the recording beside it"),
                   message("remove the list where it belongs to another file")};
    }
    end = gap.first + gap.frames;
    gaps.push_back(gap);
  }
  return gaps;
}

}  // namespace

std::string gapListPath(const std::string& recording) {
  return recording + ".gaps.csv";
}

Status writeGapList(const std::string& recording, const std::vector<FilledGap>& gaps, Hertz rate) {
  const std::string path = gapListPath(recording);
  if (gaps.empty()) {
    std::error_code none;
    std::filesystem::remove(path, none);
    return Done{};
  }
  PartFile file(path);
  if (!file.opened()) return file.failure();
  std::fputs("first_frame,frames,from_s,to_s\n", file.stream());
  for (const FilledGap& gap : gaps) {
    std::fprintf(file.stream(), "%" PRId64 ",%" PRId64 ",%.9f,%.9f\n", gap.first, gap.frames,
                 static_cast<double>(gap.first) / rate.value, static_cast<double>(gap.first + gap.frames) / rate.value);
  }
  if (std::ferror(file.stream()) != 0) return file.failure();
  return file.finish();
}

Result<std::unique_ptr<RecordingReader>> openWithGaps(std::unique_ptr<RecordingReader> whole,
                                                      const std::string& recording) {
  const std::string path = gapListPath(recording);
  std::error_code none;
  if (!std::filesystem::exists(path, none)) return whole;
  auto gaps = readGapList(path, whole->format().frames);
  if (!gaps) return gaps.error();
  return std::unique_ptr<RecordingReader>(new GapReader(std::move(whole), std::move(gaps).value()));
}

}  // namespace stillcut::record
