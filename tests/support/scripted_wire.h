// A wire on virtual time with a peer behind it that a test can delay, split, merge, garble, put out of order, silence
// and hang up. Waiting moves the clock; nothing sleeps.
#pragma once

#include <algorithm>
#include <deque>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "core/cnc/byte_channel.h"
#include "tests/support/virtual_clock.h"

namespace stillcut::cnc::testing {

// What goes wrong, for all wires of a peer. A fluent script: faults.delay(0.05).split(3).
struct WireFaults {
  Seconds latency{0.00005};
  std::size_t piece = 0;  // bytes a read gives at most; 0: all
  Seconds batch{};        // replies come together, at multiples of this
  int disorder = 0;       // every so many replies one comes after the next one; 0: never
  std::string noise;      // said before every reply
  bool silent = false;    // takes requests and never answers
  bool refuses = false;   // no connection comes about

  WireFaults& delay(double seconds) {
    latency = Seconds(seconds);
    return *this;
  }
  WireFaults& split(std::size_t bytes) {
    piece = bytes;
    return *this;
  }
  WireFaults& merge(double seconds) {
    batch = Seconds(seconds);
    return *this;
  }
  WireFaults& wrongOrder(int every) {
    disorder = every;
    return *this;
  }
  WireFaults& garbage(std::string bytes) {
    noise = std::move(bytes);
    return *this;
  }
  WireFaults& hang(bool on = true) {
    silent = on;
    return *this;
  }
  WireFaults& refuse(bool on = true) {
    refuses = on;
    return *this;
  }
};

// A peer's side of one connection.
class Peer {
 public:
  virtual ~Peer() = default;
  virtual void connected() {}
  // Bytes came; `answer(text, extraDelay)` schedules a reply.
  using Answer = std::function<void(std::string, double)>;
  virtual void take(std::string_view bytes, Instant now, const Answer& answer) = 0;
  virtual void gone() {}
};

class ScriptedWire final : public ByteChannel {
 public:
  ScriptedWire(test::VirtualClock& clock, WireFaults& faults, Peer& peer)
      : clock_(clock), faults_(faults), peer_(peer) {}

  std::string_view address() const noexcept override { return "mill:5007"; }
  void connect() noexcept override {
    hangUp();
    if (faults_.refuses) return;
    state_ = WireState::Open;
    peer_.connected();
  }
  WireState state() noexcept override { return state_; }
  std::size_t read(std::span<char> into) noexcept override {
    pour();
    std::size_t n = 0;
    const std::size_t most = faults_.piece == 0 ? into.size() : std::min(into.size(), faults_.piece);
    while (n < most && !coming_.empty() && coming_.front().when <= clock_.now()) {
      std::string& text = coming_.front().text;
      const std::size_t part = std::min(most - n, text.size());
      text.copy(into.data() + n, part);
      text.erase(0, part);
      n += part;
      if (text.empty()) coming_.pop_front();
    }
    return n;
  }
  bool write(std::string_view bytes) noexcept override {
    if (state_ != WireState::Open) return false;
    peer_.take(bytes, clock_.now(), [&](std::string text, double extra) {
      if (faults_.silent) return;
      const Instant when = arrival(toDuration(faults_.latency + Seconds(extra)));
      text.insert(0, faults_.noise);
      if (faults_.disorder > 0 && ++replies_ % faults_.disorder == 0 && late_.empty()) {
        late_ = std::move(text);
        return;
      }
      coming_.push_back({when, std::move(text)});
      if (!late_.empty()) coming_.push_back({when, std::exchange(late_, {})});
    });
    return true;
  }
  void wait(Duration atMost) noexcept override {
    pour();
    const Duration until = coming_.empty() ? atMost : std::max(Duration::zero(), coming_.front().when - clock_.now());
    clock_.advance(toSeconds(std::min(atMost, until)));
  }
  void close() noexcept override { hangUp(); }

  // The peer hangs up, or the cable is pulled.
  void hangUp() noexcept {
    if (state_ == WireState::Open) peer_.gone();
    state_ = WireState::Closed;
    coming_.clear();
    late_.clear();
  }
  // Bytes nobody asked for.
  void say(std::string text) { coming_.push_back({clock_.now(), std::move(text)}); }
  // The same bytes over and over from now on, `every` so long, between whatever else is said; empty: no more.
  void flood(std::string text, Seconds every) {
    flood_ = std::move(text);
    floodEvery_ = toDuration(every);
    floodAt_ = clock_.now();
  }

 private:
  struct Coming {
    Instant when;
    std::string text;
  };
  // What a flood has brought since; what nobody reads backs up in front of the peer and is lost.
  void pour() {
    if (flood_.empty() || state_ != WireState::Open) return;
    for (; floodAt_ <= clock_.now(); floodAt_ += floodEvery_) {
      if (coming_.size() >= kMostWaiting) continue;
      const auto later = [&](const Coming& c) { return c.when > floodAt_; };
      coming_.insert(std::find_if(coming_.begin(), coming_.end(), later), {floodAt_, flood_});
    }
  }
  Instant arrival(Duration after) const {
    const Instant when = clock_.now() + after;
    const Duration batch = toDuration(faults_.batch);
    if (batch <= Duration::zero()) return when;
    const Duration past = (when - Instant{}) % batch;
    return past == Duration::zero() ? when : when + (batch - past);
  }

  test::VirtualClock& clock_;
  WireFaults& faults_;
  Peer& peer_;
  WireState state_ = WireState::Closed;
  std::deque<Coming> coming_;
  static constexpr std::size_t kMostWaiting = 64;
  std::string flood_;
  Duration floodEvery_{};
  Instant floodAt_{};
  std::string late_;  // kept back until the next reply has gone
  int replies_ = 0;
};

}  // namespace stillcut::cnc::testing
