// Samples as lines of text, one instant a line: "0.12,-3.4,9.81". Values are parted by commas, semicolons, tabs or
// spaces. A line that is not so many numbers is an instant lost; where the line begins with a counter, missing lines
// are counted as well. The first line is taken for the rest of one. Thread: driver; real-time after construction.
#pragma once

#include <vector>

#include "core/daq/stream_decoder.h"

namespace stillcut::daq {

class TextLines final : public StreamDecoder {
 public:
  TextLines(int channels, bool counted);

  std::size_t feed(std::string_view bytes) noexcept override;
  bool take(std::span<float> values, std::uint64_t& lost) noexcept override;
  void reset() noexcept override;
  bool countsLosses() const noexcept override { return counted_; }
  std::uint64_t damaged() const noexcept override { return damaged_; }

 private:
  bool parse(std::string_view line, std::span<float> values, std::uint64_t& number) const noexcept;

  int channels_;
  bool counted_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0;
  bool whole_ = false;    // begin_ is the begin of a line
  bool started_ = false;  // a counter was read
  std::uint64_t expected_ = 0;
  std::uint64_t lost_ = 0;
  std::uint64_t damaged_ = 0;
};

}  // namespace stillcut::daq
