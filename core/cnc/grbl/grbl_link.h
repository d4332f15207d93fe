// GrblLink: GRBL 1.1 and grblHAL over a serial wire. It asks '?' every few milliseconds and moves the overrides by
// their real-time bytes, which have no reply: an override is known only when "Ov:" shows it, so each round sends at
// most one step of a kind and waits until it shows; where it does not show, the next is to 100 %, which has a byte of
// its own, and not one more step from a place that nobody knows. On a slow wire answers to questions from before a step
// come after it: they say nothing of what the step has done, and are told by their number. On every end the overrides
// go back; 100 % has bytes of its own, which work whatever was lost on the way. FS is what is programmed, not what
// turns: a plain GRBL reports no measured speed (actualSpeed stays 0, and LinkTimes::speed at never). Many boards start
// anew when their port opens, and are deaf for up to 3 s: the port is opened once and handed from open() to the link
// thread, and while the boot time lasts silence is no fault. A serial port that is open stays so through any silence,
// because opening it again would start the board again; a TCP connection is made anew. The port belongs to whoever
// streams the program, so this needs a controller with a second stream, or a sender that shares it. The controller has
// no watchdog: describe() says so. Thread: as CncLink says; a tick waits at most kWait; all of letting go takes at most
// kReleaseTime.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>

#include "core/cnc/byte_channel.h"
#include "core/cnc/cnc_link.h"
#include "core/cnc/delay_gauge.h"
#include "core/cnc/grbl/grbl_status.h"
#include "core/cnc/grbl/pending_questions.h"
#include "core/cnc/line_splitter.h"
#include "core/cnc/release_budget.h"
#include "core/cnc/shared_override.h"

namespace stillcut::cnc {

struct GrblSettings {
  WireAddress wire{.host = {}, .port = 0, .device = "/dev/ttyUSB0"};
  bool inches = false;   // reports in inches ($13=1)
  bool sender = false;   // the wire leads through another program, which has the port
  bool askWords = true;  // "$G" for the F and S words; false where another program counts the "ok"s
};

class GrblLink final : public CncLink {
 public:
  // `clock` bounds what open() and release() wait.
  GrblLink(const GrblSettings& settings, std::unique_ptr<ByteChannel> wire, const Clock& clock);
  ~GrblLink() override;

  LinkInfo describe() const override;
  Status open() override;
  MachineState read(Instant now) noexcept override;
  void apply(const OverrideCommand& command, Instant now) noexcept override;
  void release(Instant now) noexcept override;
  void adopt(std::optional<Ratio> speed, std::optional<Ratio> feed) noexcept override {
    if (speed) speed_.adopt(*speed);
    if (feed) feed_.adopt(*feed);
  }
  void close() noexcept override;

  static constexpr Duration kWait = std::chrono::milliseconds(6);
  static constexpr Duration kReleaseTime = std::chrono::milliseconds(800);
  static constexpr Duration kBootTime = std::chrono::seconds(4);  // from the port's opening to the first word

 private:
  void tick(Instant now) noexcept;
  void keepUp(Instant now) noexcept;
  void listen(Instant now) noexcept;
  void takeReport(const GrblReport& report, Instant now) noexcept;
  void ask(Instant now) noexcept;
  Duration patience() const noexcept;
  bool confirmed() const noexcept;
  void moveOverrides(Instant now) noexcept;
  struct Axis : SharedOverride {
    Axis()
        : SharedOverride(
              kGrblLowest, kGrblHighest,
              {.sightings = 2, .lateAfterHand = false, .inOrder = false, .latestEcho = std::chrono::seconds(1)}) {}
    bool adrift = false;  // a step of ours was taken or lost, and no report has told since
  };
  void resynchronise() noexcept;
  void move(Axis& knob, unsigned char firstByte, Instant now) noexcept;
  void stepped(Instant now) noexcept;
  void forget() noexcept;
  void drop(Instant now) noexcept;
  bool starting(Instant now) const noexcept { return !ever_ && opened_ && now - *opened_ <= kBootTime; }
  MachineState state(Instant now) const noexcept;

  GrblSettings settings_;
  std::unique_ptr<ByteChannel> wire_;
  const Clock& clock_;
  LineSplitter splitter_;
  Axis speed_, feed_;
  GrblReport report_;
  GrblWords words_;
  bool wordsKnown_ = false;
  bool settled_ = true;       // the last step has shown, or is known to be lost
  int answersSinceMove_ = 0;  // to questions asked after the last step
  bool waiting_ = false;      // for a report
  int missed_ = 0;
  Instant asked_{}, askedWords_{}, heard_{}, nextTry_{}, moved_{}, toldWords_{};
  Instant shownAt_{};  // when the question was asked whose answer has shown the overrides as they stand
  PendingQuestions pending_;
  std::size_t olderAnswers_ = 0;  // that may still come to questions from before the last step
  DelayGauge roundTrip_;
  ReleaseBudget releaseBudget_;
  bool ever_ = false;              // it was heard since it was last lost
  std::optional<Instant> opened_;  // the port, as long as nothing was heard since
};

}  // namespace stillcut::cnc
