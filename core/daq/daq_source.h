// DaqSource: where samples come from. How to add a device: core/daq/ADDING.md.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/model/channel.h"
#include "core/model/sample_block.h"

namespace stillcut::daq {

struct SourceFormat {
  Hertz rate{};
  int blockFrames = 0;  // frames in a full block
  std::vector<ChannelInfo> channels;
  Message doubt{};  // what may be wrong with the samples and cannot be seen in them; one line, or empty
};

// How a device that was joined to another runs against this computer's clock.
struct AlignedClock {
  Hertz rate{};        // as its stamps have it
  Seconds residual{};  // root mean square of them beside a straight line; a constant lag is not in it
  int channels = 0;    // that are its
};

// Pull interface: the driver thread (rt::RealtimeThread run by pipeline) calls read() in a loop and pushes what it gets
// into the ring. A source paces itself: read() returns when the block's last sample exists (live), or at once (files,
// simulation as fast as possible).
class DaqSource {
 public:
  virtual ~DaqSource() = default;
  // Set-up thread. Opens the device; may allocate. After success format() is final.
  virtual Result<SourceFormat> open() = 0;
  // Driver thread. Fills `block` (allocated for the format). Sequence, time, rate, flags and lostFrames are set by the
  // source. False: no more blocks, ever; fault() says why when it was not a plain end.
  virtual bool read(SampleBlock& block) noexcept = 0;
  // Any thread: makes a blocked read() return false soon.
  virtual void stop() noexcept = 0;
  // After read() returned false: empty for a plain end, else one line.
  virtual Message fault() const = 0;
  // Any thread, while it is read: one line that says why nothing comes, for as long as nothing does; else empty.
  virtual Message trouble() const { return {}; }
  // True: a device measuring the machine as it is now. A source that does not say so drives simulated machines only.
  virtual bool live() const { return false; }
  // Any thread, while it is read: the devices beside the first, where several are joined.
  virtual std::vector<AlignedClock> clocks() const { return {}; }
};

}  // namespace stillcut::daq
