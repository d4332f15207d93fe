// PcmDriver: the library boundary of devices that deliver interleaved whole numbers: ALSA, IIO, Comedi. What is above
// it is tested with drivers that overrun, fall short and disappear; what is below it are the calls of one library.
// Thread: open() and close() on one thread at a time; read() and recover() on the driver thread, real-time.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/base/units.h"

namespace stillcut::daq {

struct PcmRequest {
  std::string device = "hw:0";
  Hertz rate{};
  int channels = 1;      // at the least
  int bits = 0;          // 16, 24, 32; 0: as many as the device has
  int periodFrames = 0;  // about
};

struct PcmFormat {
  int channels = 1;     // interleaved
  int sampleBytes = 4;  // 2; 3 packed; 4
  int bits = 32;        // of them in use, the upper ones, but for 24 in 4: the lower three bytes
  int periodFrames = 256;
  std::vector<double> siOfFullScale;  // by channel, where the device knows; empty: 1, the profile's scale says all
  Message doubt{};  // what may be wrong with its samples and cannot be seen in them; one line, or empty
};

// What read() and recover() say below 0.
enum PcmFault : int { kPcmOverrun = -1, kPcmGone = -2, kPcmBroken = -3 };

class PcmDriver {
 public:
  virtual ~PcmDriver() = default;
  // Exactly this rate, without resampling, and the samples as the device delivers them; or one line that says what the
  // device could do instead.
  virtual Result<PcmFormat> open(const PcmRequest& request) = 0;
  // At most `frames` frames; 0: none within a tenth of a second. `taken`: when the last of them was sampled, on the
  // steady clock.
  virtual int read(void* into, int frames, Instant& taken) noexcept = 0;
  // After an overrun: streams again. False: it does not.
  virtual bool recover() noexcept = 0;
  // It says kPcmOverrun when it has lost samples; else time has to show it.
  virtual bool countsLosses() const noexcept = 0;
  virtual void close() noexcept = 0;  // safe when not open; open() may follow
};

struct PcmDevice {
  std::string name;   // as PcmRequest::device takes it
  std::string label;  // as its maker calls it
  std::string range;  // "1 to 2 channels, 8000 to 96000 Hz"
};

}  // namespace stillcut::daq
