// DuplexDevice: a paced device whose inputs and outputs share one clock: N frames come in, N frames go out. What is
// written after a block was read is played in the blocks that follow, always equally late: that delay is part of the
// path and measured with it. Thread: open() and close() on one thread at a time; read() and write() on the loop's
// thread, real-time; stop() on any.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "core/base/realtime.h"
#include "core/base/result.h"
#include "core/base/units.h"
#include "core/safety/actuator_gate.h"

namespace stillcut::active {

struct DuplexFormat {
  Hertz rate{};
  int frames = 0;          // in a block
  bool keepsDelay = true;  // also after a Lost
};

enum class DuplexEvent : std::uint8_t {
  Block,  // read; what write() is given next goes out after it
  Lost,   // an over- or underrun: samples are missing and the output fell to zero; it goes on with the next read()
  Gone    // unplugged, broken or stopped: nothing comes any more until it is opened again
};

class DuplexDevice {
 public:
  virtual ~DuplexDevice() = default;
  virtual std::string name() const = 0;  // as a screen shows it
  // Two inputs and two outputs, x and y. The output is zero until the first write().
  virtual Result<DuplexFormat> open() = 0;
  // Waits for the next block and writes it to `in`: [axis * frames + frame], SI of the sensor.
  virtual DuplexEvent read(std::span<double> in) STILLCUT_RT = 0;
  // After a Block: what is to be played next, in metres of stroke, [axis * frames + frame]; only a gate makes it. Lost:
  // it came too late.
  virtual DuplexEvent write(std::span<const safety::ActuatorCommand> out) STILLCUT_RT = 0;
  // Ends a read() that waits, and all after it.
  virtual void stop() noexcept = 0;
  virtual void close() noexcept = 0;  // safe when not open; open() may follow
};

}  // namespace stillcut::active
