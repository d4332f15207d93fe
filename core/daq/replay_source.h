// ReplaySource: a recording as a source. Sessions come back in their own blocks, with the times, flags and gaps of the
// cut; imported files in even blocks. What comes after cannot tell it from a device.
#pragma once

#include <atomic>
#include <memory>
#include <string>

#include "core/base/time.h"
#include "core/daq/daq_source.h"
#include "core/model/step_record.h"
#include "core/record/recording_reader.h"
#include "core/rt/wakeup.h"

namespace stillcut::daq {

struct ReplayOptions {
  int blockFrames = 256;         // of imported files; sessions keep their own
  double pace = 0.0;             // times real time; 0: as fast as possible
  const Clock* clock = nullptr;  // needed for a pace
};

class ReplaySource final : public DaqSource {
 public:
  ReplaySource(std::unique_ptr<record::RecordingReader> reader, const ReplayOptions& options);

  Result<SourceFormat> open() override;
  bool read(SampleBlock& block) noexcept override;
  void stop() noexcept override;
  std::string fault() const override { return fault_; }

  const record::RecordingFormat& recording() const { return reader_->format(); }
  // Driver thread: the machine's state and the operator's inputs that were recorded with the block last read, for the
  // chain to be fed with; null for imported files. Valid until the next read().
  const StepInput* recordedStep() const;
  // The same with what the program made of it then, to compare.
  const StepRecord* recordedResult() const { return reader_->recordedStep(); }

 private:
  bool waitFor(const SampleBlock& block) noexcept;

  std::unique_ptr<record::RecordingReader> reader_;
  ReplayOptions options_;
  std::string fault_;
  std::atomic<bool> stopped_{false};
  rt::Wakeup wakeup_;
  bool started_ = false;
  Instant startedAt_{};  // on the clock
  Instant firstSample_{};
};

}  // namespace stillcut::daq
