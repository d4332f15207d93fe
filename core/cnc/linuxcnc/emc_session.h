// EmcSession: one conversation with linuxcncrsh or halrmt: connects, greets, keeps one request under way, notices
// silence and connects again. It knows the protocol's manners and none of its words.
// Manners found by doing it (2.9.0~pre1): replies to gets end in CR LF, ACK and NAK in LF CR; echo is on at first, and
// without "verbose on" there is no ACK; a get takes 0.05 ms, an override's ACK 100 ms; an unknown request gets no
// reply. Thread: link thread. Nothing throws; memory is bounded.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/time.h"
#include "core/cnc/byte_channel.h"
#include "core/cnc/line_splitter.h"

namespace stillcut::cnc {

class EmcSession {
 public:
  enum class ConnectionState : std::uint8_t { Down, Greeting, Ready };

  // `password`: that of the server's --connectpw, "EMC" unless it was changed.
  EmcSession(std::unique_ptr<ByteChannel> channel, std::string password);

  // Moves the conversation on: connects when it is time, greets, reads what came. Lines that are neither greeting nor
  // echo go to `take(std::string_view)`; the first of them answers the request.
  template <class Take>
  void pump(Instant now, Take&& take) {
    keepUp(now);
    std::array<char, 1024> bytes;
    while (const std::size_t n = channel_->read(bytes)) {
      splitter_.feed({bytes.data(), n}, [&](std::string_view line) {
        if (standing_ == ConnectionState::Greeting) {
          greeted(line, now);
        } else if (isReply(line)) {
          waiting_ = false;
          take(line);
        }
      });
      if (n < bytes.size()) break;
    }
    watchSilence(now);
  }

  // Sends a request; only when idle(). False: the wire broke.
  bool ask(std::string_view request, Instant now) noexcept;
  bool idle() const { return standing_ == ConnectionState::Ready && !waiting_; }
  // Something was said, greetings included, and not answered yet.
  bool waiting() const { return waiting_; }
  ConnectionState standing() const { return standing_; }
  // Waits for bytes, at most this long.
  void wait(Duration atMost) noexcept { channel_->wait(atMost); }
  void close() noexcept;
  std::string_view address() const noexcept { return channel_->address(); }

 private:
  void keepUp(Instant now) noexcept;
  void greeted(std::string_view line, Instant now) noexcept;
  void say(std::string_view line, Instant now) noexcept;
  void watchSilence(Instant now) noexcept;
  static bool isReply(std::string_view line) noexcept;

  std::unique_ptr<ByteChannel> channel_;
  std::string hello_;
  LineSplitter splitter_;
  ConnectionState standing_ = ConnectionState::Down;
  bool waiting_ = false;
  bool opening_ = false;
  Instant asked_{}, nextTry_{};
};

}  // namespace stillcut::cnc
