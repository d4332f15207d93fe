// RtuBus: a RegisterBus of Modbus RTU over a wire of bytes. Nothing in an answer names its question, so what matters
// here is that an answer that comes late is not taken for the next question's:
// - between two frames the line is silent for 3.5 characters;
// - after a question that was not answered in time the line is left alone until the late answer has come, or for as
//   long again as it may take; whatever comes until then is thrown away;
// - where it has not come by then it may come with the next answer: that one is waited for until the line has been
//   silent for as long, and is taken only when as many frames came as questions are open. Else the reply is unsure.
// A peer that never falls silent is spoken to all the same, a little later.
// Thread: the link thread alone, but for the constructor. Nothing throws; memory and the time of each call are bounded.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/cnc/modbus/register_bus.h"
#include "core/cnc/modbus/rtu_frame.h"

namespace stillcut::cnc {

class RtuBus final : public RegisterBus {
 public:
  // `clock` outlives it.
  RtuBus(const BusAddress& address, std::unique_ptr<ByteChannel> wire, const Clock& clock);

  std::string_view address() const noexcept override { return name_; }
  void connect() noexcept override;
  WireState state() noexcept override;
  void wait(Duration atMost) noexcept override;
  void close() noexcept override;
  bool read(RegisterTable table, int first, int count) noexcept override;
  bool write(RegisterTable table, int first, int count, const RegisterWords& words) noexcept override;
  bool busy() const noexcept override { return phase_ != Phase::Free; }
  std::optional<BusReply> take() noexcept override;

 private:
  enum class Phase : std::uint8_t {
    Free,
    Due,    // a question waits for its silence
    Asked,  // and for its answer
    Quiet,  // nothing is asked until the line is silent
  };
  void step() noexcept;
  void listen(Instant now) noexcept;
  void takeFrame(std::string_view frame) noexcept;
  bool ask(const RtuQuestion& question) noexcept;
  void sendWhenSilent(Instant now) noexcept;
  void waitForAnswer(Instant now) noexcept;
  void endQuiet(Instant now) noexcept;
  void answer(const BusReply& reply) noexcept;
  void beQuiet(Instant now) noexcept;

  std::unique_ptr<ByteChannel> wire_;
  const Clock& clock_;
  int unit_;
  std::string name_;
  Duration gap_, answerWithin_;
  RtuReceiver receiver_;
  Phase phase_ = Phase::Free;
  std::optional<RtuQuestion> question_;
  std::optional<BusReply> held_;   // the newest that fits, while more may come
  std::optional<BusReply> reply_;  // to be taken
  int owed_ = 0;                   // questions that were given up and may still be answered
  int came_ = 0;                   // frames since the question went out
  Instant lastByte_{}, since_{};   // of the phase
};

}  // namespace stillcut::cnc
