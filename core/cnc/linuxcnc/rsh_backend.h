// RshBackend: the knobs through linuxcncrsh: takes control ("set enable") with the first command, sets the two
// overrides, gives control back. Another client's enable takes it silently; then it keeps off for a while. While the
// machine is off no override is taken: nothing is sent then, and what stands there waits until it is on. The overrides
// stay where they are when we die: no watchdog. Thread: link thread.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/cnc/delay_gauge.h"
#include "core/cnc/linuxcnc/emc_backend.h"
#include "core/cnc/linuxcnc/emc_session.h"

namespace stillcut::cnc {

class RshBackend final : public EmcBackend {
 public:
  // `controlPassword`: that of "set enable".
  RshBackend(EmcSession session, const std::string& controlPassword, const Clock& clock);

  bool hasWord(const EmcOverrides& knobs, bool wanted, Instant now) const noexcept override;
  void turn(EmcOverrides& knobs, bool wanted, bool maySpeak, EmcStatus& status, Instant now) noexcept override;
  bool speaking() const noexcept override { return session_.waiting(); }
  bool done(const EmcOverrides& knobs) const noexcept override;
  OverrideInhibit block(Instant now) const noexcept override;
  bool up() const noexcept override { return session_.standing() == EmcSession::ConnectionState::Ready; }
  bool heard() const noexcept override { return up(); }
  bool watchdog() const noexcept override { return false; }
  int highestSpeed() const noexcept override { return percentFirst() ? 100 : SharedOverride::kNoCap; }
  Seconds roundTrip() const noexcept override { return roundTrip_.typical(); }
  Instant acknowledged() const noexcept override { return acknowledged_; }
  void wait(Duration atMost) noexcept override { session_.wait(atMost); }
  void close() noexcept override { session_.close(); }
  std::string_view address() const noexcept override { return session_.address(); }

 private:
  enum class Asked : std::uint8_t { Nothing, Enable, WaitMode, Speed, Feed, GiveBack, Standing };
  enum class WordOrder : std::uint8_t { Unknown, SpindleFirst, PercentFirst };

  // One of the two overrides, where the machine refused it: left alone for a while, so that the other goes its way.
  struct Refusal {
    std::optional<Instant> at{};
    bool holds(Instant now) const;
  };
  bool dueNow(const SharedOverride& knob, const Refusal& refusal, Instant now) const noexcept;
  bool mayMove(const EmcOverrides& knobs) const noexcept;
  bool needed(const EmcOverrides& knobs, bool wanted) const noexcept;
  bool leavesIt(Instant now) const noexcept;
  void next(EmcOverrides& knobs, bool wanted, Instant now) noexcept;
  void reply(std::string_view line, EmcOverrides& knobs, EmcStatus& status, Instant now) noexcept;
  void ask(Asked what, std::string_view request, Instant now) noexcept;
  struct SetOrder {
    std::array<char, 48> text{};
    std::size_t size = 0;
    std::string_view words() const { return {text.data(), size}; }
  };
  SetOrder orderTo(Asked which, int percent) const noexcept;
  void set(Asked what, SharedOverride& knob, Instant now) noexcept;
  void lastWords(EmcOverrides& knobs, Instant now) noexcept;
  void lose(OverrideInhibit to, Instant now) noexcept;
  bool percentFirst() const { return order_ == WordOrder::PercentFirst; }
  void waitModeAnswered(bool no, std::string_view line, Instant now) noexcept;
  void setAnswered(bool no, Asked which, SharedOverride& knob, Refusal& refusal, Instant now) noexcept;

  EmcSession session_;
  std::string enable_;
  const Clock& clock_;
  DelayGauge roundTrip_;
  Instant setAt_{}, acknowledged_{};
  bool inControl_ = false;  // as far as we know
  bool waitModeSet_ = false;
  bool machineOff_ = false;  // it takes no override then
  Refusal speedRefused_, feedRefused_;
  Instant standingAsked_{};
  std::optional<Instant> lostAt_;
  OverrideInhibit lostTo_ = OverrideInhibit::None;
  Asked asked_ = Asked::Nothing;
  bool lastWordsSaid_ = false;  // since it answered last
  WordOrder order_ = WordOrder::Unknown;
};

}  // namespace stillcut::cnc
