// What must hold for whatever the gate lets out, written down without the gate's code: authority, limits of machine,
// tool, holder and cutting edge, rates, order, recovery, changes per minute, holding on bad input, and the way home.
// breach() is empty or says what was broken. It keeps books of its own (gate_books.h) and is told nothing by the gate
// but what the gate sends, shows and says.
#pragma once

#include <cmath>
#include <sstream>
#include <string>

#include "tests/support/gate_books.h"

namespace stillcut::safety::testing {

class GateOracle {
 public:
  void prepared(const GateLimits& limits, const CutterLimits& cutter = {}) {
    limits_ = limits;
    cutter_ = cutter;
    books_.prepared(limits);
    changes_.prepared(limits);
  }

  std::string breach(const GateInput& in, const GateOutput& out) {
    books_.before(in);
    for (int i = 0; i < out.eventCount; ++i) {
      if (out.events[static_cast<std::size_t>(i)].reason.code == ReasonCode::AutoWithoutHelp) {
        books_.giveUp();
        ++withdrawn;
      }
    }
    std::string what = judge(in, out);
    if (what.empty()) what = changes_.breach(in, out, books_);
    books_.after(in, out);
    if (out.command && out.command->kind() == CommandKind::Set) ++sets;
    if (out.command) last_ = out.command->record();
    return what;
  }
  long sets = 0;
  long withdrawn = 0;  // Auto, for want of help

 private:
  static constexpr double kTiny = 1e-9;
  static bool inside(double v, const config::FactorRange& r) { return v >= r.low - kTiny && v <= r.high + kTiny; }

  std::string judge(const GateInput& g, const GateOutput& out) const {
    const Books& b = books_;
    if (out.authority == Authority::Auto && !limits_.autoAllowed) return "Auto without leave";
    if (!b.mayShow(out.authority)) return "an authority that nobody gave";
    if (std::string untold = notTold(g, out); !untold.empty()) return untold;
    if (!out.command) return b.inForce && !b.lapsed ? "a Set in force was neither renewed nor released" : "";
    const CommandRecord& c = out.command->record();
    if (c.sequence <= last_.sequence) return "sequence did not grow";
    if (c.kind == CommandKind::Release) return whenReleased(g, out);
    if (!std::isfinite(c.speed.value) || !std::isfinite(c.feed.value)) return "not finite";
    if (b.lapsed) return "Set on a dead lease";
    if (c.lease != toDuration(limits_.lease)) return "wrong lease";
    if (c.engagement <= g.machine.endedEngagement) return "Set of an engagement that the link has ended";
    if (b.inForce && c.engagement != last_.engagement) return "changed its engagement without a release";
    if (!b.inForce) {
      if (std::string why = whenTaken(g, out); !why.empty()) return why;
    }
    if (!b.steerable(g)) return whenUntrusted(c);
    if (std::string why = limitsBroken(g.machine, c); !why.empty()) return why;
    return whenMoving(g, out);
  }

  // Every fault and change of authority leaves an event and a flight, also with nothing in force.
  std::string notTold(const GateInput& g, const GateOutput& out) const {
    const auto said = [&out](auto&& is) {
      for (int i = 0; i < out.eventCount; ++i) {
        if (is(out.events[static_cast<std::size_t>(i)])) return true;
      }
      return out.eventsLost > 0;
    };
    if (out.authority != books_.shown) {
      const bool told = said([](const Event& e) { return e.reason.code == ReasonCode::AuthorityChanged; });
      if (!told || !out.flight) return "a change of authority without event and flight";
    }
    const bool news =
        !books_.mayLeave && books_.badSince == 0.0 && books_.goodFor > 1.5 && books_.bad && books_.unusual;
    if (news && books_.shown != Authority::Off && out.authority != Authority::Off) {
      const bool told = said([](const Event& e) { return e.level != EventLevel::Info; });
      if (!told || !out.flight) return "trouble without event and flight";
    }
    if (g.strategyFailed && !books_.failed && !(said([](const Event& e) { return e.level == EventLevel::Fault; }))) {
      return "a failed strategy without an event";
    }
    return "";
  }

  // Nothing jumps where the machine can still be steered.
  std::string whenReleased(const GateInput& g, const GateOutput& out) const {
    const Books& b = books_;
    if (out.commanding) return "released and still commanding";
    if (!b.inForce || b.lapsed || !b.steerable(g)) return "";
    const bool home = std::abs(last_.speed.value - 1.0) < 1e-4 && std::abs(last_.feed.value - 1.0) < 1e-4;
    const bool excused = last_.engagement <= g.machine.endedEngagement || b.notTaken > limits_.takeTime.value ||
                         (b.badClock > 0.0 && b.badClock >= limits_.holdTime.value) ||
                         b.stuck + b.elapsed > limits_.followTime.value;
    if (home || excused) return "";
    std::ostringstream s;
    s << "jumped from " << last_.speed.value << ", " << last_.feed.value << " to 100 % with a machine that is well";
    return s.str();
  }

  std::string whenTaken(const GateInput& g, const GateOutput& out) const {
    const Books& b = books_;
    const MachineState& m = g.machine;
    if (out.authority == Authority::Off) return "took the overrides without authority";
    if (b.bad) return "took the overrides on bad input";
    if (out.authority == Authority::Advise && !b.licence) return "took the overrides on an advice that nobody accepted";
    if (b.sinceRelease + b.elapsed < limits_.reengageDelay.value - kTiny) {
      return "took the overrides again after " + std::to_string(b.sinceRelease + b.elapsed) + " of " +
             std::to_string(limits_.reengageDelay.value) + " s";
    }
    if (b.held || m.feedHold) return "took the overrides while something was on hold";
    if (b.sinceKnob < limits_.operatorPause.value - kTiny) return "took the overrides from under the operator's hand";
    if (g.verdict.state == CutState::AirCutting || g.verdict.phase == CutPhase::RunUp)
      return "took the overrides in air";
    const double speed = m.programmedSpeed.value * m.operatorSpeed.value;
    const bool turns = m.actualSpeed.value <= 0.0 ||
                       std::abs(m.actualSpeed.value - speed) <= limits_.speedTolerance * speed * (1.0 + kTiny);
    return m.atSpeed && turns ? "" : "took the overrides before the spindle was at speed";
  }

  std::string whenUntrusted(const CommandRecord& c) const {
    if (!books_.inForce) return "took the overrides of a machine that cannot be trusted";
    if (c.speed != last_.speed || c.feed != last_.feed) return "moved on bad machine state";
    if (books_.mustLeave) return "holds on where it can only let go";
    return books_.badSince > limits_.holdTime.value + 0.2 ? "held on bad machine state for too long" : "";
  }

  std::string limitsBroken(const MachineState& m, const CommandRecord& c) const {
    const config::OverrideLimits& o = limits_.overrides;
    if (m.programmedSpeed.value <= 0.0) return "";
    const double base = m.programmedSpeed.value * m.operatorSpeed.value;
    const double n = base * c.speed.value;
    const auto beyond = [&](double most) { return n > std::max(most, base) * (1.0 + kTiny); };
    if (beyond(cutter_.machine.value)) return "faster than the machine may turn";
    if (beyond(cutter_.tool.value)) return "faster than the tool may turn";
    if (beyond(cutter_.holder.value)) return "faster than the holder may turn";
    if (beyond(60.0 * cutter_.edge.value / (3.14159265358979 * cutter_.diameter.value))) {
      return "faster than the edge may cut";
    }
    if (n < std::min(o.slowest.value, base) * (1.0 - kTiny)) return "slower than the spindle may turn";
    const double feedBase = m.programmedFeed.value * m.operatorFeed.value;
    const double feed = feedBase * c.feed.value;
    if (feed > std::max(o.fastestFeed.value, feedBase) * (1.0 + kTiny)) return "faster than the feed may be";
    if (feed < std::min(o.slowestFeed.value, feedBase) * (1.0 - kTiny)) return "slower than the feed may be";
    if (!inside(c.speed.value, books_.ownSpeeds(m))) return "speed out of the override's range";
    if (!inside(c.feed.value, books_.feeds(m))) return "feed out of the override's range";
    if (c.feed.value > o.feedPerTooth * c.speed.value + kTiny) return "feed per tooth too high";
    if (c.feed.value < o.lowestFeedPerTooth * c.speed.value - kTiny) return "feed per tooth too low";
    return "";
  }

  std::string whenMoving(const GateInput& g, const GateOutput& out) const {
    const Books& b = books_;
    const CommandRecord& c = out.command->record();
    // Where we came from, taken along by edges that moved: that may be at once, and is always toward 100 %.
    const config::OverrideLimits& o = limits_.overrides;
    const double speed = b.inForce ? b.speeds(g.machine).clamp(last_.speed.value) : 1.0;
    double feed = b.inForce ? b.feeds(g.machine).clamp(last_.feed.value) : 1.0;
    feed = std::max(std::min(feed, o.feedPerTooth * speed), o.lowestFeedPerTooth * speed);
    const double ds = c.speed.value - speed, df = c.feed.value - feed;
    const bool still = std::abs(ds) <= kTiny && std::abs(df) <= kTiny;
    const auto homeward = [](double from, double d) {
      return std::abs(d) <= kTiny || ((from - 1.0) * d < 0.0 && std::abs(d) <= std::abs(from - 1.0) + kTiny);
    };
    if (b.mustLeave && !(homeward(speed, ds) && homeward(feed, df))) {
      std::ostringstream s;
      s << "from " << speed << ", " << feed << " by " << ds << ", " << df << " is not the way home";
      return s.str();
    }
    if (b.mustLeave && still && b.stuck > limits_.followTime.value + 0.25) return "stays where it has to leave";
    if (!b.mayLeave) {
      if (b.bad && !still) return "moved on bad input";
      if (!still && (b.held || g.machine.feedHold)) return "moved while something was on hold";
      if (!still && b.sinceKnob < limits_.operatorPause.value - kTiny) return "moved under the operator's hand";
      if (!still && out.authority == Authority::Advise && !b.licence) return "moved without an accepted advice";
    }
    return rates(g, speed, feed, ds, df);
  }

  std::string rates(const GateInput& g, double speed, double feed, double ds, double df) const {
    const double perTooth = limits_.overrides.feedPerTooth;
    const double dt = std::min(books_.elapsed, g.dt.value > 0.0 ? g.dt.value : 0.0);
    const auto most = [&](double from, double d, double step, double slew) {
      const bool back = (from - 1.0) * d < 0.0 && std::abs(d) <= std::abs(from - 1.0) + kTiny;
      const bool slow = back && !g.verdict.alarming() && !books_.mayLeave;
      return (slow ? 0.2 : 1.0) * std::min(step, slew * dt) + kTiny;
    };
    std::ostringstream s;
    const auto tooFast = [&](const char* which, double from, double d, double step, double slew) {
      const double allowed = most(from, d, step, slew);
      if (std::abs(d) > allowed)
        s << which << " moved from " << from << " by " << d << " in " << dt << " s, allowed " << allowed;
    };
    tooFast("speed", speed, ds, limits_.speedStep, limits_.speedSlew);
    tooFast("feed", feed, df, limits_.feedStep, limits_.feedSlew);
    const MachineState& m = g.machine;
    if (ds < -kTiny && speed + ds < feed / perTooth - kTiny) s << "speed fell before feed";
    if (df > kTiny && feed + df > perTooth * speed + kTiny) s << "feed rose before speed";
    const double inForce = m.operatorFeed.value > 0.0 ? m.feedOverride.value / m.operatorFeed.value : 0.0;
    if (ds < -kTiny && speed + ds < (inForce - limits_.speedTolerance - kReadbackRounding) / perTooth - kTiny) {
      s << "speed fell before the feed that is in force";
    }
    const double base = m.programmedSpeed.value * m.operatorSpeed.value;
    const double reached = base > 0.0 && m.actualSpeed.value / base > 0.0 ? m.actualSpeed.value / base : speed;
    const bool waits = !books_.blind;
    if (waits && df > kTiny && feed + df > perTooth * reached * (1.0 + limits_.speedTolerance) + kTiny) {
      s << "feed rose from " << feed << " by " << df << " before the spindle, at " << reached << ", speed " << speed
        << " by " << ds;
    }
    return s.str();
  }

  GateLimits limits_;
  CutterLimits cutter_;
  Books books_;
  ChangeCount changes_;
  CommandRecord last_;
};

}  // namespace stillcut::safety::testing
