#include "ui/models/advice_view.h"

#include <QStringList>
#include <cmath>
#include <numbers>

#include "ui/base/format.h"
#include "ui/base/reason_text.h"
#include "ui/base/say.h"
#include "ui/models/learned_view.h"
#include "ui/models/named_chatter.h"

namespace stillcut::ui {
namespace {

// Where speed and feed shall go, whoever says so, and from where. 0: not moved, or not known.
struct Move {
  Rpm speed;
  MetresPerSecond feed;
  Rpm fromSpeed;
  MetresPerSecond fromFeed;
};

// A command nearer to 100 % than the screen can tell has moved nothing.
bool moves(const CommandRecord& command) {
  const bool set = command.kind == CommandKind::Set;
  return set && (std::abs(command.speed.value - 1.0) > 0.004 || std::abs(command.feed.value - 1.0) > 0.004);
}

// The gate only repeats the numbers: it holds nothing back.
bool repeatsNumbers(ReasonCode code) {
  return code == ReasonCode::None || code == ReasonCode::GateInForce || code == ReasonCode::GateMoving;
}

// Told by the panel's own words already.
bool idle(ReasonCode code) {
  return code == ReasonCode::NothingToDo || code == ReasonCode::NothingToDoAt;
}

QString deltaText(const Move& move) {
  if (!(move.fromSpeed.value > 0)) return {};
  // The unit stands beside the speed itself.
  return QStringLiteral("%1, %2").arg(withSign((move.speed - move.fromSpeed).value),
                                      overrideText(move.speed / move.fromSpeed));
}

// Time goes as 1 / feed; the cutting speed is pi D n.
QString costText(const Move& move, const Picture& picture) {
  QStringList parts;
  if (move.feed.value > 0 && move.fromFeed.value > 0) {
    const double change = (move.fromFeed / move.feed - 1.0) * 100.0;
    if (std::abs(change) < 0.05) {
      parts << say("Costs no time");
    } else {
      const QString amount = join(number(std::abs(change), 1), QStringLiteral("%"));
      parts << (change > 0 ? say("Costs %1 time") : say("Saves %1 time")).arg(amount);
    }
  }
  const Metres diameter = picture.info->setup.toolDiameter;
  if (move.speed.value > 0 && diameter.value > 0) {
    const MetresPerSecond edge(std::numbers::pi * diameter.value * move.speed.value / 60.0);
    parts << say("cutting speed %1").arg(cuttingSpeedText(edge, picture.units));
  }
  QString text = parts.join(say(", "));
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

QString feedSentence(const Move& move, UnitSystem units) {
  if (!(move.feed.value > 0)) return say("The feed stays as it is");
  return say("Feed follows: %1").arg(feedText(move.feed, units));
}

void fillMove(AdviceView& view, const Move& move, const Picture& picture) {
  if (move.speed.value > 0) {
    view.target = join(number(move.speed.value), rpmUnit());
    view.delta = deltaText(move);
    view.feed = feedSentence(move, picture.units);
  } else {
    view.target = feedText(move.feed, picture.units);
    view.feed = say("The speed stays as it is");
  }
  view.cost = costText(move, picture);
}

// What the advice asks for, by its kind.
void fillAdvice(AdviceView& view, const SpeedAdvice& advice, const Picture& picture) {
  view.reason = reasonText(advice.reason);
  switch (advice.kind) {
    case SpeedAdvice::Kind::None:
      break;
    case SpeedAdvice::Kind::ToProgrammed:
      view.target = say("Back to 100 %");
      break;
    case SpeedAdvice::Kind::LessDepth:
      view.target = say("Less depth of cut");
      if (advice.depth.value > 0) {
        view.target = say("%1 deep at most").arg(depthText(advice.depth, picture.units));
        view.delta = say("at %1").arg(join(number(advice.speed.value), rpmUnit()));
      }
      break;
    case SpeedAdvice::Kind::Speed:
    case SpeedAdvice::Kind::OutOfReach:
      fillMove(view, {advice.speed, advice.feed, advice.base, advice.baseFeed}, picture);
      break;
  }
}

AdviceView openAdvice(const Picture& picture) {
  AdviceView view;
  view.mode = AdviceView::Mode::Open;
  view.title = say("ADVICE");
  if (picture.replay) {  // it was answered when it was live, or never
    view.mode = AdviceView::Mode::ForHand;
    view.title = say("ADVICE IN THE REPLAY");
  }
  fillAdvice(view, picture.snapshot->advice, picture);
  return view;
}

// No machine to move, or nothing that an override could do: a hand, or the next program, may follow it.
AdviceView forHand(const Picture& picture) {
  const SpeedAdvice& advice = picture.snapshot->advice;
  const Verdict& verdict = picture.verdict();
  AdviceView view;
  view.mode = AdviceView::Mode::ForHand;
  view.title = advice.kind == SpeedAdvice::Kind::Speed && !picture.info->linkLabel.isEmpty()
                   ? say("ADVICE")
                   : say("ADVICE FOR YOUR HAND");
  if (advice.kind == SpeedAdvice::Kind::OutOfReach) view.title = say("ADVICE FOR THE PROGRAM");
  if (picture.replay) view.title = say("ADVICE IN THE REPLAY");
  fillAdvice(view, advice, picture);
  const double turns = verdict.spindle.value * 60.0;
  constexpr double kThere = 0.01;
  const bool there = verdict.valid && !verdict.alarming() && advice.kind == SpeedAdvice::Kind::Speed &&
                     std::abs(turns - advice.speed.value) <= kThere * advice.speed.value;
  if (there && !picture.replay) {
    view.title = say("STABLE SPEED");
    view.reason = say("The spindle turns as advised and the cut is stable: keep it");
    if (picture.margin) view.cost = marginLine(*picture.margin, picture.units);
  }
  return view;
}

// Who gives no authority is told what it would be good for, in grey: nobody has asked.
AdviceView offered(const Picture& picture) {
  AdviceView view;
  view.mode = AdviceView::Mode::Offered;
  view.title = say("ADVICE, AUTHORITY IS OFF");
  fillAdvice(view, picture.snapshot->advice, picture);
  view.feed = say("Touch ADVISE to use it");
  return view;
}

// Somebody wants advice, and the strategy has not yet asked for it: the speed that was offered is the one to come.
AdviceView standing(const Picture& picture) {
  AdviceView view;
  view.mode = AdviceView::Mode::Offered;
  view.title = picture.snapshot->authority == Authority::Auto ? say("WHAT COMES NEXT") : say("ADVICE, IN A MOMENT");
  fillAdvice(view, picture.snapshot->advice, picture);
  return view;
}

// The frequency of a strategy's sentence, as verdict and card name it.
Reason withNamedFrequency(Reason reason, const Picture& picture) {
  const bool third = reason.code == ReasonCode::CentreOfNextPocket || reason.code == ReasonCode::QuarterWave;
  const bool fourth = reason.code == ReasonCode::NextPocketInRange || reason.code == ReasonCode::PocketByLobes;
  if (!third && !fourth) return reason;
  constexpr double kSame = 0.03;
  const Verdict& verdict = picture.verdict();
  const Hertz named = namedChatter(*picture.snapshot, verdict.frequency, verdict.frequencySd);
  double& said = reason.n[third ? 2 : 3];
  if (verdict.alarming() && named.value > 0.0 && std::abs(named.value - said) <= kSame * said) said = named.value;
  return reason;
}

AdviceView commandInForce(const Picture& picture, const Reason& moveReason, Rpm target) {
  const Snapshot& s = *picture.snapshot;
  AdviceView view;
  view.mode = AdviceView::Mode::InForce;
  view.title = !s.machine.linkUp ? say("ASKED FOR, NOT CONFIRMED BY THE MACHINE")
               : s.operatorHold  ? say("ACTIVE, HELD BY YOU")
                                 : say("ACTIVE");
  const MachineState& m = s.machine;
  // While the ramp goes there its end stands large, and where it has come to small: one speed, not two.
  const Rpm commanded = m.programmedSpeed * s.command.speed.value;
  constexpr double kThere = 0.003;
  const bool onItsWay = target.value > 0.0 && commanded.value > 0.0 && repeatsNumbers(s.command.reason.code) &&
                        std::abs(commanded / target - 1.0) > kThere;
  const double further = onItsWay ? target / commanded : 1.0;
  fillMove(
      view,
      {commanded * further, m.programmedFeed * (s.command.feed.value * further), m.programmedSpeed, m.programmedFeed},
      picture);
  if (onItsWay) view.delta = say("now %1").arg(number(commanded.value));
  // What the gate keeps back comes first; otherwise the strategy has the word.
  const bool strategySays = moveReason.code != ReasonCode::None && repeatsNumbers(s.command.reason.code);
  view.reason = reasonText(strategySays ? withNamedFrequency(moveReason, picture) : s.command.reason);
  return view;
}

AdviceView nothing(const Picture& picture) {
  AdviceView view;
  view.title = say("WHAT TO DO");
  if (picture.over()) {
    view.target = say("No advice");
    view.reason = say("Another run begins on the page Set up: GUIDE or PROFILE");
    if (picture.mayRunAgain) {
      view.mode = AdviceView::Mode::Again;
      view.target = say("The simulated cut is over");
      view.reason = picture.notRunAgain.isEmpty()
                        ? say("AGAIN runs it once more. Your own machine: the page Set up")
                        : say("It does not run again: %1. AGAIN tries once more").arg(picture.notRunAgain);
    }
    return view;
  }
  if (!picture.snapshot || picture.stale) {
    view.target = say("No advice");
    view.reason = say("There is no live picture to advise on");
    return view;
  }
  const Snapshot& s = *picture.snapshot;
  const bool alarm = picture.verdict().alarming();
  const bool quiet = picture.verdict().valid && !alarm;
  view.target = quiet ? say("Nothing to do") : say("No advice");
  view.reason = idle(s.request.reason.code) ? QString() : reasonText(s.request.reason);
  const bool wishes = s.request.kind == RequestKind::Set;  // and nobody asks for its reasons
  if (s.authority == Authority::Off && (view.reason.isEmpty() || wishes))
    view.reason = say("Authority is off: Stillcut only watches");
  if (view.reason.isEmpty() && !quiet && !alarm) view.reason = say("There is no verdict to act on");
  if (view.reason.isEmpty() && alarm) view.reason = say("The strategy has not decided yet");
  if (quiet && picture.margin) view.feed = marginLine(*picture.margin, picture.units);
  return view;
}

}  // namespace

QString AdviceView::spoken() const {
  QStringList parts{title, target, delta, reason, feed, cost};
  parts.removeAll(QString());
  return parts.join(QStringLiteral(". "));
}

AdviceView makeAdviceView(const Picture& picture, const Reason& moveReason, Rpm target) {
  if (!picture.snapshot || picture.stale || picture.over()) return nothing(picture);
  const Snapshot& s = *picture.snapshot;
  const SpeedAdvice::Kind kind = s.advice.kind;
  if (s.adviceOpen && kind != SpeedAdvice::Kind::None) return openAdvice(picture);
  if (s.commanding && moves(s.command)) return commandInForce(picture, moveReason, target);
  if (kind == SpeedAdvice::Kind::LessDepth || kind == SpeedAdvice::Kind::OutOfReach) return forHand(picture);
  if (kind != SpeedAdvice::Kind::Speed) return nothing(picture);
  if (picture.replay || picture.info->linkLabel.isEmpty()) return forHand(picture);
  if (s.authority == Authority::Off) return offered(picture);
  // Refused is refused. Otherwise what was offered stays where it is until the strategy has asked for it by itself.
  return s.request.reason.code == ReasonCode::AdviceRefused ? nothing(picture) : standing(picture);
}

}  // namespace stillcut::ui
