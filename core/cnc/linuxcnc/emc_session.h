// EmcSession: one conversation with linuxcncrsh or halrmt: connects, greets, keeps one request under way, notices
// silence and connects again. It knows the protocol's manners and none of its words.
// Manners found by doing it (2.9.0~pre1): replies to gets end in CR LF, ACK and NAK in LF CR; echo is on at first, and
// without "verbose on" there is no ACK; a get takes 0.05 ms, an override's ACK 100 ms; an unknown request gets no
// reply. Newer ones complain in a line of their own, "error: ...", which may be all, or be followed by a NAK; and warn
// before the reply. So a line is the answer only when it names what was asked. Thread: link thread. Nothing throws; the
// memory and the time of each call are bounded.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
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

  // Moves the conversation on: connects when it is time, greets, reads what came. Replies go to
  // `take(std::string_view line, bool answers)`; `answers`: it is the one to the request, a refusal included.
  template <class Take>
  void pump(Instant now, Take&& take) {
    keepUp(now);
    std::array<char, 1024> bytes;
    for (int i = 0; i < kReadsAtOnce; ++i) {
      const std::size_t n = channel_->read(bytes);
      splitter_.feed({bytes.data(), n}, [&](std::string_view line) {
        if (standing_ == ConnectionState::Greeting) {
          greeted(line, now);
        } else if (waiting_ && isComplaint(line)) {
          complainedAt_ = now;
        } else if (isWarning(line)) {
          warned_ = warned_ || waiting_;
        } else if (isReply(line)) {
          take(line, settles(line));
        }
      });
      if (n < bytes.size()) break;
    }
    if (waiting_ && complainedAt_ && now - *complainedAt_ > kNakFollows) {
      waiting_ = false;
      take(kComplaint, true);
    }
    watchSilence(now);
  }

  // Sends a request; only when idle(). False: the wire broke.
  bool ask(std::string_view request, Instant now) noexcept;
  // Says a line without waiting for its answer, also while another is waited for.
  void add(std::string_view line) noexcept;
  // How long an answer has been waited for; 0: none is.
  Duration waited(Instant now) const { return waiting_ ? now - asked_ : Duration::zero(); }
  bool idle() const { return standing_ == ConnectionState::Ready && !waiting_; }
  // Something was said, greetings included, and not answered yet.
  bool waiting() const { return waiting_; }
  // The answer came with a complaint, or is one: what was asked is not known there, or is out of range.
  bool complained() const { return complainedAt_.has_value(); }
  bool warned() const { return warned_; }  // before the answer: what was asked is out of use
  ConnectionState standing() const { return standing_; }
  // Waits for bytes, at most this long.
  void wait(Duration atMost) noexcept { channel_->wait(atMost); }
  void close() noexcept;
  std::string_view address() const noexcept { return channel_->address(); }

 private:
  void keepUp(Instant now) noexcept;
  void greeted(std::string_view line, Instant now) noexcept;
  void say(std::string_view line, Instant now) noexcept;
  void write(std::string_view line) noexcept;
  void watchSilence(Instant now) noexcept;
  static bool isReply(std::string_view line) noexcept;
  static bool isComplaint(std::string_view line) noexcept { return line.starts_with("error:"); }
  static bool isWarning(std::string_view line) noexcept { return line.starts_with("WARNING"); }
  bool settles(std::string_view line) noexcept;

  static constexpr int kReadsAtOnce = 16;  // of 1024 bytes: a peer may flood
  static constexpr Duration kNakFollows = std::chrono::milliseconds(50);
  static constexpr std::string_view kComplaint = "error: NAK";  // what is handed on in its place

  std::unique_ptr<ByteChannel> channel_;
  std::string hello_;
  LineSplitter splitter_;
  ConnectionState standing_ = ConnectionState::Down;
  bool waiting_ = false;
  bool opening_ = false;
  std::optional<Instant> complainedAt_;  // since the request
  bool warned_ = false;                  // since the request
  std::array<char, 40> word_{};          // that was asked for, as replies write it: "SPINDLE_OVERRIDE"
  std::size_t wordSize_ = 0;
  Instant asked_{}, nextTry_{};
};

}  // namespace stillcut::cnc
