// An override register that the operator's hand and our link both write, at the end of a wire that is late, loses
// answers and keeps its order. It knows who wrote what stands there, which the link cannot. The link between is the
// program's own: LeaseWatch and SharedOverride.
#pragma once

#include <array>
#include <deque>
#include <optional>
#include <set>
#include <string>

#include "core/cnc/shared_override.h"
#include "core/safety/lease_watch.h"

namespace stillcut::safety::testing {

class HandAndWire {
 public:
  static constexpr int kLowest = 50, kHighest = 120;  // [%] that we may ask for

  explicit HandAndWire(const cnc::SharedOverride::Manners& manners)
      : link_(kLowest, kHighest, manners), reportsMayBeFalse_(manners.sightings > 1) {}

  // The operator turns it.
  void turn(int percent) {
    raced_ = raced_ || !writes_.empty();  // ours lands on it before anybody can know
    ambiguous_ = ambiguous_ || sentEver_.count(percent) > 0;
    // What stood there before the hand, and is back, may be the end of a report that was false.
    ambiguous_ = ambiguous_ || (reportsMayBeFalse_ && (stood_ == percent || toldBefore_ == percent));
    stood_ = shows_;
    toldBefore_ = lastTold_;
    if (ambiguous_) forbidden_.reset();
    hand_ = shows_ = percent;
    ++turns_;
  }
  // What is late arrives, in order; an answer may be lost.
  void deliver(Instant now) {
    while (!writes_.empty() && writes_.front().due <= now) {
      shows_ = writes_.front().percent;
      writes_.pop_front();
    }
    while (!answers_.empty() && answers_.front().due <= now) {
      const Message& m = answers_.front();
      link_.seen(m.percent, now);
      if (m.turns != toldTurns_) {
        toldTurns_ = m.turns;
        told_ = m.percent;
        const bool shows = m.percent != lastTold_;
        if (shows && ours_ && !undecidable()) forbidden_ = m.percent;
      }
      lastTold_ = m.percent;
      answers_.pop_front();
    }
  }
  void ask(Instant now, Duration delay, bool lost) {
    if (!lost) push(answers_, {now + delay, shows_, turns_});
  }
  void want(Ratio factor, std::uint64_t engagement) {
    if (engagement != engagement_) forbidden_.reset();
    engagement_ = engagement;
    ours_ = factor.value != 1.0;
    link_.want(factor, engagement);
  }
  void relinquish() {
    ours_ = false;
    forbidden_.reset();
    link_.relinquish();
  }
  // What the link sends now. Empty, or what it broke by that.
  std::string send(Instant now, Duration delay) {
    const std::optional<int> due = link_.due();
    if (!due) return "";
    raced_ = raced_ || turns_ != toldTurns_;
    link_.sent(*due, now);
    sentEver_.insert(*due);
    push(writes_, {now + delay, *due});
    if (forbidden_ && *due != *forbidden_) {
      return "sent " + std::to_string(*due) + " % over the hand's " + std::to_string(*forbidden_) + " %";
    }
    if (raced_ || ambiguous_) return "";
    if (*due > std::max(kHighest, told_)) return "sent " + std::to_string(*due) + " %, above limits and hand";
    if (*due < std::min(kLowest, told_)) return "sent " + std::to_string(*due) + " %, below limits and hand";
    return "";
  }

  const cnc::SharedOverride& link() const { return link_; }
  int shows() const { return shows_; }
  // As the hand left it, nothing of ours on its way there, and the link knows it.
  bool home() const { return shows_ == hand_ && writes_.empty() && link_.baseConfirmed(); }
  int hand() const { return hand_; }
  // Nobody can tell the hand from us: both wrote at once, or the hand chose a number of ours, or took itself back.
  bool undecidable() const { return raced_ || ambiguous_; }

 private:
  struct Message {
    Instant due{};
    int percent = 100;
    int turns = 0;  // that the hand had made by then
  };
  static void push(std::deque<Message>& wire, Message m) {
    if (!wire.empty()) m.due = std::max(m.due, wire.back().due);
    wire.push_back(m);
  }

  cnc::SharedOverride link_;
  bool reportsMayBeFalse_;
  std::optional<int> stood_, toldBefore_;  // before the last turn of the hand, there and as the link had read it
  std::deque<Message> writes_, answers_;
  int shows_ = 100, hand_ = 100, told_ = 100, lastTold_ = 100;
  int turns_ = 0, toldTurns_ = 0;
  std::uint64_t engagement_ = 0;
  bool ours_ = false;             // a factor of ours is wanted: at 100 % there is nothing that a hand could end
  std::optional<int> forbidden_;  // the hand's value: nothing else may be sent in this engagement
  std::set<int> sentEver_;
  bool raced_ = false, ambiguous_ = false;
};

}  // namespace stillcut::safety::testing
