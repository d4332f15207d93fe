#include "core/cnc/linuxcnc/emc_session.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/cnc/wire_number.h"

namespace stillcut::cnc {
namespace {

constexpr Duration kRetry = std::chrono::milliseconds(500);
constexpr Duration kPatience = std::chrono::milliseconds(600);  // an override's ACK takes 100 ms

// One write: without verbose the first has no reply, only its own echo.
constexpr std::string_view kManners = "set echo off\r\nset verbose on";

}  // namespace

EmcSession::EmcSession(std::unique_ptr<ByteChannel> channel, std::string password)
    : channel_(std::move(channel)), hello_("hello " + std::move(password) + " stillcut 1.0") {}

void EmcSession::keepUp(Instant now) noexcept {
  switch (channel_->state()) {
    case WireState::Closed:
      if (standing_ != ConnectionState::Down || opening_) {
        close();
        nextTry_ = now + kRetry;
      }
      if (now < nextTry_) return;
      nextTry_ = now + kRetry;
      opening_ = true;
      asked_ = now;
      channel_->connect();
      return;
    case WireState::Opening:
      if (now - asked_ > kPatience) close();
      return;
    case WireState::Open:
      if (standing_ != ConnectionState::Down) return;
      opening_ = false;
      standing_ = ConnectionState::Greeting;
      say(hello_, now);
      return;
  }
}

void EmcSession::greeted(std::string_view line, Instant now) noexcept {
  if (line.starts_with("HELLO ACK")) {
    say(kManners, now);
  } else if (line.starts_with("SET VERBOSE ACK")) {
    waiting_ = false;
    standing_ = ConnectionState::Ready;
  } else if (line.find("NAK") != std::string_view::npos) {
    close();
    nextTry_ = now + kRetry;
  }
}

void EmcSession::say(std::string_view line, Instant now) noexcept {
  waiting_ = true;
  complainedAt_.reset();
  warned_ = false;
  asked_ = now;
  write(line);
}

void EmcSession::write(std::string_view line) noexcept {
  std::array<char, 256> out;
  if (line.size() + 2 > out.size()) return;
  line.copy(out.data(), line.size());
  out[line.size()] = '\r';
  out[line.size() + 1] = '\n';
  if (!channel_->write({out.data(), line.size() + 2})) close();
}

void EmcSession::add(std::string_view line) noexcept {
  if (standing_ == ConnectionState::Ready) write(line);
}

bool EmcSession::ask(std::string_view request, Instant now) noexcept {
  if (!idle()) return false;
  std::string_view words = request;
  takeToken(words);  // get, set
  const std::string_view word = takeToken(words);
  wordSize_ = std::min(word.size(), word_.size());
  std::transform(word.begin(), word.begin() + static_cast<std::ptrdiff_t>(wordSize_), word_.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  say(request, now);
  return standing_ == ConnectionState::Ready;
}

// Echoes are lower case as we write them; replies are upper case.
bool EmcSession::isReply(std::string_view line) noexcept {
  return line.front() >= 'A' && line.front() <= 'Z';
}

// "SET SPINDLE_OVERRIDE ACK", "SPINDLE_OVERRIDE 0 100", "SET NAK": whether it names what was asked.
bool EmcSession::settles(std::string_view line) noexcept {
  if (!waiting_) return false;
  std::string_view words = line;
  std::string_view first = takeToken(words);
  if (first == "SET" || first == "GET") first = takeToken(words);
  if (first != std::string_view(word_.data(), wordSize_) && first != "NAK") return false;
  waiting_ = false;
  return true;
}

void EmcSession::watchSilence(Instant now) noexcept {
  if (standing_ == ConnectionState::Down || !waiting_ || now - asked_ <= kPatience) return;
  close();
  nextTry_ = now + kRetry;
}

void EmcSession::close() noexcept {
  channel_->close();
  splitter_.clear();
  standing_ = ConnectionState::Down;
  waiting_ = false;
  opening_ = false;
}

}  // namespace stillcut::cnc
