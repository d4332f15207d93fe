// A signal in memory as a recording, for what reads recordings.
// Thread: one.
#pragma once

#include "core/formats/recording_reader.h"
#include "tests/support/field_cases/field_case.h"

namespace stillcut::field {

// Keeps a reference to the signal.
class MemoryReader final : public record::RecordingReader {
 public:
  explicit MemoryReader(const Signal& signal);
  const record::RecordingFormat& format() const override { return format_; }
  Result<bool> read(SampleBlock& block) override;

 private:
  const Signal& signal_;
  record::RecordingFormat format_;
  std::int64_t read_ = 0;  // frames
  std::uint64_t sequence_ = 0;
};

}  // namespace stillcut::field
