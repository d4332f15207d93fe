// JoinedSource: several devices as one, aligned on the clock of the first. Its blocks, rate and times are the first
// device's; the channels of the others follow, each brought to its times (clock_aligner.h). Every other device is read
// by a thread of its own. While one of them is away or has a gap, nothing can be said of all together: those blocks are
// missing, as a gap of known length. Thread: as DaqSource says; clocks(): any.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "core/base/time.h"
#include "core/daq/clock_aligner.h"
#include "core/daq/daq_source.h"
#include "core/rt/realtime_thread.h"
#include "core/rt/spsc_ring.h"

namespace stillcut::daq {

struct JoinedPart {
  std::unique_ptr<DaqSource> device;
  Seconds delay{};  // by which its samples are stamped too late: a transport's that the data sheet tells
};

class JoinedSource final : public DaqSource {
 public:
  // Two devices or more; `clock` outlives it.
  JoinedSource(std::vector<JoinedPart> parts, const Clock& clock);
  ~JoinedSource() override;
  JoinedSource(const JoinedSource&) = delete;
  JoinedSource& operator=(const JoinedSource&) = delete;

  Result<SourceFormat> open() override;
  bool read(SampleBlock& block) noexcept override;
  void stop() noexcept override;
  Message fault() const override;
  Message trouble() const override;
  bool live() const override;
  std::vector<AlignedClock> clocks() const override;

 private:
  struct Follower;
  void start();
  enum class Reach { Whole, NotYet, Never };
  Reach reach(Instant from, Instant to) noexcept;

  std::vector<JoinedPart> parts_;
  const Clock& clock_;
  SourceFormat format_;
  int ownChannels_ = 0;
  SampleBlock own_;  // of the first device
  std::vector<std::unique_ptr<Follower>> followers_;
  std::uint64_t missing_ = 0;  // frames left out since the last block handed out
  bool started_ = false;
  bool handedOut_ = false;
  std::atomic<bool> stopped_{false};
};

}  // namespace stillcut::daq
