// EmcBackend: who turns LinuxCNC's two knobs for us: linuxcncrsh (RshBackend), or stillcut-hal beside the machine
// (HalBackend). What the knobs show is read elsewhere, so that an order and its effect come on different ways. Thread:
// link thread. Nothing throws; bounded in time and memory.
#pragma once

#include <string_view>

#include "core/base/time.h"
#include "core/base/units.h"
#include "core/cnc/linuxcnc/emc_status.h"
#include "core/cnc/shared_override.h"
#include "core/model/machine_state.h"

namespace stillcut::cnc {

// A server that lies once, or for a while, is no hand.
inline constexpr SharedOverride::Manners kEmcManners{.sightings = 2};

struct EmcOverrides {
  SharedOverride speed, feed;
  Ratio adaptiveFeed{1.0};  // a factor of its own, where the hand has one; it reduces only
};

class EmcBackend {
 public:
  virtual ~EmcBackend() = default;
  // Something has to be said to linuxcncrsh before anything is asked: a value that is due, control to take or to give
  // back.
  virtual bool hasWord(const EmcOverrides& knobs, bool wanted, Instant now) const noexcept = 0;
  // One tick: brings the knobs nearer to what they want. `wanted`: commands are being given; without it all goes home
  // and control is given back. `maySpeak`: no other request to linuxcncrsh is under way.
  virtual void turn(EmcOverrides& knobs, bool wanted, bool maySpeak, EmcStatus& status, Instant now) noexcept = 0;
  // A request to linuxcncrsh is under way: the watch has to wait.
  virtual bool speaking() const noexcept = 0;
  // Nothing of ours is left, nor on its way, as far as was read back.
  virtual bool done(const EmcOverrides& knobs) const noexcept = 0;
  // Why the knobs are not ours to turn; None: they are.
  virtual OverrideInhibit block(Instant now) const noexcept = 0;
  virtual bool up() const noexcept = 0;  // connected to whoever turns the knobs
  // Something has answered.
  virtual bool heard() const noexcept = 0;
  // The machine was seen to go home by itself when nothing comes from here.
  virtual bool watchdog() const noexcept = 0;
  // The most that it takes for the spindle, %.
  virtual int highestSpeed() const noexcept { return SharedOverride::kNoCap; }
  // From an order to its acknowledgement; 0: none yet.
  virtual Seconds roundTrip() const noexcept = 0;
  // When an order was acknowledged last; 0: never.
  virtual Instant acknowledged() const noexcept = 0;
  // Until something came on its wire, or `atMost` has passed.
  virtual void wait(Duration atMost) noexcept = 0;
  // Lets go of its wire; up() is false from then on.
  virtual void close() noexcept = 0;
  virtual std::string_view address() const noexcept = 0;  // of that wire, for error lines
};

}  // namespace stillcut::cnc
