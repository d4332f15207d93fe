// ReplaySource: a recording as a source. Sessions come back in their own blocks, with the times, flags and gaps of the
// cut; imported files in even blocks. What comes after cannot tell it from a device: where the replay jumps (a loop, a
// place gone to), the blocks go on in time and number, and the first one carries a gap.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/base/time.h"
#include "core/daq/daq_source.h"
#include "core/daq/replay_control.h"
#include "core/formats/recording_reader.h"
#include "core/model/step_record.h"

namespace stillcut::daq {

struct ReplayOptions {
  int blockFrames = 256;                   // of imported files; sessions keep their own
  double pace = 0.0;                       // times real time; 0: as fast as possible
  const Clock* clock = nullptr;            // needed for a pace and for a control
  std::shared_ptr<ReplayControl> control;  // empty: straight through at `pace`
  // Opens the recording once more, for going back in one that can only be read from its beginning; empty: such a jump
  // ends the replay with a fault.
  std::function<Result<std::unique_ptr<record::RecordingReader>>()> reopen;
};

class ReplaySource final : public DaqSource {
 public:
  ReplaySource(std::unique_ptr<record::RecordingReader> reader, const ReplayOptions& options);

  Result<SourceFormat> open() override;
  bool read(SampleBlock& block) noexcept override;
  void stop() noexcept override;
  Message fault() const override { return fault_; }

  const record::RecordingFormat& recording() const { return reader_->format(); }
  // Driver thread: the machine's state and the operator's inputs that were recorded with the block last read, for the
  // chain to be fed with; null for imported files. Valid until the next read(). Its block is the recorded one: times
  // in it that belong to a jump are moved by shift().
  const StepInput* recordedStep() const;
  // How much later than recorded the block last read is.
  Duration shift() const { return shift_; }

 private:
  bool next(SampleBlock& block);
  bool jump(Seconds to);
  void place(SampleBlock& block) noexcept;
  bool waitForTurn() noexcept;
  bool waitFor(const SampleBlock& block) noexcept;

  std::unique_ptr<record::RecordingReader> reader_;
  ReplayOptions options_;
  std::shared_ptr<ReplayControl> control_;
  Message fault_;
  std::atomic<bool> stopped_{false};
  bool started_ = false;
  Instant recordedBegin_{};          // of the first sample of the recording
  std::optional<Seconds> recorded_;  // end of the block last read, in the recording
  Instant end_{};                    // of the block last handed out
  std::uint64_t sequence_ = 0;       // its number
  std::int64_t sequenceShift_ = 0;
  Duration shift_{};
  bool jumped_ = false;
  bool skipping_ = false;  // towards a place, in a recording without seek
  Seconds wanted_{};
  // Paced: a block is due at dueFrom_ + (time since pacedFrom_) / pace.
  double pace_ = 0.0;
  Instant dueFrom_{};
  Instant pacedFrom_{};
};

}  // namespace stillcut::daq
