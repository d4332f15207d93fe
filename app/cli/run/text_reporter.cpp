#include <cstdio>

#include "app/cli/run/run_reporter.h"
#include "core/model/judged_cut.h"
#include "core/rt/deadline_stats.h"

namespace stillcut::app {
namespace {

std::string format(const char* form, double value) {
  char text[96];
  std::snprintf(text, sizeof text, form, value);
  return text;
}

class TextReporter final : public RunReporter {
 public:
  explicit TextReporter(Rig& rig) : rig_(rig) {}

  void start(const RunBegin& begin) override {
    if (begin.mode == Authority::Off) {
      std::printf("monitoring with %s; authority is off\n", begin.profile.detector.c_str());
    } else {
      std::printf("monitoring with %s, %s with %s\n", begin.profile.detector.c_str(),
                  begin.mode == Authority::Auto ? "Auto" : "Advise", begin.profile.strategy.c_str());
    }
    std::fflush(stdout);
  }
  void change(const RunLook& look) override { line(look, "", ""); }
  void status(const RunLook& look) override {
    const Snapshot& s = look.now;
    std::string totals = format(", in the cut %.0f s", s.cutTime.value) +
                         format(", judged %.0f s", s.judgedTime.value) +
                         format(", in chatter %.1f s", s.chatterTime.value);
    if (s.health.droppedBlocks > 0)
      totals += format(", %.0f blocks dropped", static_cast<double>(s.health.droppedBlocks));
    line(look, "= ", totals);
  }
  void event(const RunLook& look, const Event& event, const Intervention* /*closed*/) override {
    print(look.times.utcMs(event.time), sentence(event.reason));
  }
  void note(const std::string& sentence) override {
    std::printf("%s\n", sentence.c_str());
    std::fflush(stdout);
  }
  void stopped(Seconds silent, const std::string& why) override {
    print(utcNowMs(), format("samples stopped %.1f s ago", silent.value) + (why.empty() ? "" : ": " + why));
  }
  void resumed(Seconds silent) override { print(utcNowMs(), format("samples come again after %.1f s", silent.value)); }
  void end(const RunEnd& end, const RunLook* /*last*/) override {
    print(utcNowMs(), "ends: " + end.why);
    tellLateness();
    for (const daq::AlignedClock& clock : rig_.device().clocks()) {
      std::printf("device of %d more channels: %.3f Hz by this computer's clock, times steady within %.1f us\n",
                  clock.channels, clock.rate.value, 1e6 * clock.residual.value);
    }
    if (const Message& doubt = rig_.deviceFormat().doubt; !doubt.empty())
      std::printf("device: %s\n", text(doubt).c_str());
    std::fflush(stdout);
  }

 private:
  static void print(std::int64_t utcMs, const std::string& words) {
    std::printf("%s  %s\n", timeOfDay(utcMs).c_str(), words.c_str());
    std::fflush(stdout);
  }
  static void line(const RunLook& look, const char* mark, const std::string& totals) {
    const Verdict& v = inCharge(look.now);
    std::string words = mark + std::string(shownState(v));
    if (!hasState(v)) words += " (" + sentence(whyNotJudged(v)) + ")";
    if (v.alarming()) {
      words += v.frequency.value > 0.0 ? format(" at %.0f Hz", v.frequency.value) : "";
      words += format(", energy ratio %.2f", v.severity.value);
    }
    if (v.spindle.value > 0.0) words += format(", %.0f rpm", toRpm(v.spindle).value);
    if (const std::string advice = adviceWords(look.now.advice); !advice.empty()) words += ". Advice: " + advice;
    print(look.times.utcMs(look.now.time), words + totals);
  }
  // How long after a block's last sample everything that it asks for was decided.
  void tellLateness() const {
    const pipeline::Engine* engine = rig_.engine();
    if (engine == nullptr || engine->latency().count() == 0) return;
    const rt::DeadlineStats& latency = engine->latency();
    const auto ms = [](Seconds s) { return 1e3 * s.value; };
    std::printf(
        "%llu blocks decided, half within %.2f ms of their last sample, 99.9 %% within %.2f ms, the latest %.2f ms; "
        "%llu dropped\n",
        static_cast<unsigned long long>(latency.count()), ms(latency.quantile(0.5)),
        ms(std::min(latency.quantile(0.999), latency.worst())), ms(latency.worst()),
        static_cast<unsigned long long>(engine->droppedBlocks()));
    if (engine->leasesExpired() > 0)
      std::printf("%llu leases ran out\n", static_cast<unsigned long long>(engine->leasesExpired()));
  }

  Rig& rig_;
};

}  // namespace

std::unique_ptr<RunReporter> makeTextReporter(Rig& rig) {
  return std::make_unique<TextReporter>(rig);
}

std::string adviceWords(const SpeedAdvice& advice) {
  const double rpm = advice.speed.value;
  switch (advice.kind) {
    case SpeedAdvice::Kind::Speed:
      return format("go to %.0f rpm", rpm);
    case SpeedAdvice::Kind::OutOfReach:
      return format("program %.0f rpm, which the override does not reach", rpm);
    case SpeedAdvice::Kind::LessDepth:
      return advice.depth.value > 0.0 ? format("no speed will do, cut less than %.2g mm deep", 1e3 * advice.depth.value)
                                      : "no speed will do, cut less deep";
    case SpeedAdvice::Kind::ToProgrammed:
      return format("back to the programmed %.0f rpm", rpm);
    case SpeedAdvice::Kind::None:
      break;
  }
  return {};
}

std::string_view shownState(const Verdict& verdict) {
  return hasState(verdict) ? name(verdict.state) : "not-judged";
}

const Verdict& inCharge(const Snapshot& snapshot) {
  return snapshot.verdicts[static_cast<std::size_t>(snapshot.inCharge)];
}

}  // namespace stillcut::app
