#include "ui/models/verdict_view.h"

#include <QStringList>

#include "core/model/judged_cut.h"
#include "ui/base/format.h"
#include "ui/base/reason_text.h"
#include "ui/base/say.h"
#include "ui/models/named_chatter.h"

namespace stillcut::ui {
namespace {

QString stateWord(CutState state) {
  switch (state) {
    case CutState::AirCutting:
      return say("NO CUT");
    case CutState::Stable:
      return say("STABLE");
    case CutState::Onset:
      return say("ONSET");
    case CutState::Chatter:
      return say("CHATTER");
  }
  return {};
}

QString kindText(ChatterKind kind) {
  switch (kind) {
    case ChatterKind::Unknown:
      return {};
    case ChatterKind::Hopf:
      return say("regenerative");
    case ChatterKind::Flip:
      return say("period doubling");
    case ChatterKind::Forced:
      return say("forced vibration");
  }
  return {};
}

QString trendText(Trend trend) {
  switch (trend) {
    case Trend::Unknown:
      return {};
    case Trend::Growing:
      return say("growing");
    case Trend::Steady:
      return say("steady");
    case Trend::Fading:
      return say("dying down");
  }
  return {};
}

QString phaseText(CutPhase phase) {
  switch (phase) {
    case CutPhase::AirCutting:
      return say("The tool is in the air");
    case CutPhase::RunUp:
      return say("The spindle is running up");
    case CutPhase::Entry:
      return say("The tool is entering");
    case CutPhase::Steady:
      return {};
    case CutPhase::Exit:
      return say("The tool is leaving");
  }
  return {};
}

QString totals(const Picture& picture) {
  const Snapshot& snapshot = *picture.snapshot;
  if (!(snapshot.chatterTime.value > 0)) {
    const auto onsets = static_cast<double>(snapshot.interventionCount);
    return onsets > 0 ? say("Onsets in this run: %1, no chatter").arg(number(onsets)) : say("No chatter in this run");
  }
  return say("In chatter so far: %1, %2")
      .arg(duration(snapshot.chatterTime), lengthText(snapshot.chatterLength, picture.units));
}

VerdictView noVerdict(const QString& why) {
  VerdictView view;
  view.word = say("NO VERDICT");
  view.detail = why;
  return view;
}

VerdictView overVerdict(const Picture& picture) {
  VerdictView view = noVerdict(picture.link.ended);
  view.marked = totals(picture);
  return view;
}

VerdictView staleVerdict(const Picture& picture) {
  const QString why = picture.lags()
                          ? say("%1 behind: this computer does not keep up with the samples").arg(duration(picture.age))
                          : say("The picture is stale: nothing new for %1").arg(duration(picture.age));
  VerdictView view = noVerdict(why);
  const Verdict& last = picture.verdict();
  if (last.valid)
    view.marked =
        say("Last verdict: %1 %2").arg(stateWord(last.state), frequency(last.frequency, last.frequencySd)).trimmed();
  return view;
}

// A tool that enters or leaves has a word of its own, as that is what the operator sees it do.
VerdictView unjudgedVerdict(const Picture& picture) {
  const Verdict& verdict = picture.verdict();
  const QString why = verdict.valid ? phaseText(verdict.phase) : QString();
  VerdictView view = noVerdict(why.isEmpty() ? reasonText(whyNotJudged(verdict)) : why);
  if (view.detail.isEmpty()) view.detail = say("The detector gives no reason");
  if (verdict.valid && verdict.phase == CutPhase::Entry) view.word = say("ENTRY");
  if (verdict.valid && verdict.phase == CutPhase::Exit) view.word = say("EXIT");
  view.marked = totals(picture);
  return view;
}

void fillAlarm(VerdictView& view, const Picture& picture, Trend trend) {
  const Verdict& verdict = picture.verdict();
  const bool chatter = verdict.state == CutState::Chatter;
  view.shape = chatter ? Shape::Octagon : Shape::Triangle;
  view.tone = chatter ? Tone::Chatter : Tone::Onset;
  view.frequency =
      frequency(namedChatter(*picture.snapshot, verdict.frequency, verdict.frequencySd), verdict.frequencySd);
  view.kind = kindText(verdict.kind);
  view.detail = trendText(trend);
  view.marked = say("For %1").arg(duration(verdict.sinceOnset));
  if (verdict.feedSinceOnset.value > 0)
    view.marked =
        say("For %1, %2 of feed").arg(duration(verdict.sinceOnset), lengthText(verdict.feedSinceOnset, picture.units));
}

VerdictView verdictOf(const Picture& picture, Trend trend) {
  if (!picture.snapshot) return noVerdict(say("Waiting for the first samples"));
  if (picture.over()) return overVerdict(picture);
  if (picture.stale) return staleVerdict(picture);
  if (!picture.snapshot->running) return noVerdict(say("The run has ended"));
  const Verdict& verdict = picture.verdict();
  if (!hasState(verdict)) return unjudgedVerdict(picture);
  VerdictView view;
  view.word = stateWord(verdict.state);
  if (verdict.alarming()) {
    fillAlarm(view, picture, trend);
    return view;
  }
  const bool stable = verdict.state == CutState::Stable;
  view.shape = stable ? Shape::Circle : Shape::Ring;
  view.tone = stable ? Tone::Normal : Tone::Faint;
  view.detail =
      stable && verdict.earlyWarning ? say("Early warning: vibration begins to grow") : phaseText(verdict.phase);
  if (view.detail.isEmpty()) view.detail = kindText(verdict.kind);
  if (view.detail.isEmpty()) view.detail = stable ? say("The cut is stable") : say("The tool does not cut");
  view.marked = totals(picture);
  return view;
}

}  // namespace

QString VerdictView::spoken() const {
  QStringList parts{caption, word, frequency, kind, detail, marked};
  parts.removeAll(QString());
  return parts.join(QStringLiteral(". "));
}

VerdictView makeVerdictView(const Picture& picture, Trend trend) {
  VerdictView view = verdictOf(picture, trend);
  if (picture.paused && picture.snapshot && picture.snapshot->running) view.detail = say("The replay is paused");
  if (picture.replay) view.caption = say("REPLAY");
  return view;
}

}  // namespace stillcut::ui
