#include "ui/models/learned_view.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "ui/base/format.h"

namespace stillcut::ui {
namespace {

struct Learned {
  Q_DECLARE_TR_FUNCTIONS(Learned)
};

QString place(const SpeedDepth& at, UnitSystem units) {
  return Learned::tr("%1 at %2").arg(join(number(at.speed.value), rpmUnit()), depthText(at.depth, units));
}

// Below one part in two hundred nothing would be seen of it.
QString nextLine(const LearnedLobes& learned, UnitSystem units) {
  if (!(learned.next.at.speed.value > 0.0)) return {};
  const QString where = place(learned.next.at, units), stable = percent(learned.next.probabilityStable);
  if (learned.gain < 0.005) {
    return Learned::tr("Next most useful cut: %1, because it tells most (stable with %2).").arg(where, stable);
  }
  return Learned::tr(
             "Next most useful cut: %1, because its outcome (stable with %2) may raise the removal rate most: "
             "%3 expected.")
      .arg(where, stable, u'+' + percent(learned.gain));
}

template <class Value>
std::size_t nearest(const std::vector<Value>& steps, Value value) {
  const auto above = std::ranges::lower_bound(steps, value);
  if (above == steps.begin()) return 0;
  if (above == steps.end()) return steps.size() - 1;
  const auto i = static_cast<std::size_t>(above - steps.begin());
  return value - steps[i - 1] < steps[i] - value ? i - 1 : i;
}

}  // namespace

QString learnedLine(const LearnedLobes& learned, UnitSystem units) {
  switch (learned.state) {
    case LearnedLobes::State::NotDescribed:
      return Learned::tr("Nothing is learned from these cuts: say machine, tool, teeth, depth and modes under Set up.");
    case LearnedLobes::State::NoCuts:
      return Learned::tr(
          "Learned from cuts: nothing yet. Cut with this tool: every judged cut is kept and counts here.");
    case LearnedLobes::State::Failed:
      return Learned::tr("Learned from cuts: %1").arg(learned.problem);
    case LearnedLobes::State::Known:
      break;
  }
  const auto chattered = std::ranges::count_if(learned.cuts, [](const LearnedCut& cut) { return cut.chatter; });
  QString text = Learned::tr("Learned from %1 judged cuts (%2 with chatter) and the tool's modes.")
                     .arg(number(static_cast<double>(learned.cuts.size())), number(static_cast<double>(chattered)));
  if (learned.forgotten > 0) {
    text +=
        u' ' +
        Learned::tr("%1 older ones are set aside: the newest indicate another tool.").arg(number(learned.forgotten));
  }
  text +=
      u' ' + Learned::tr("Recommended at a risk of %1: %2.").arg(percent(learned.risk), place(learned.best.at, units));
  const QString next = nextLine(learned, units);
  return next.isEmpty() ? text : text + u' ' + next;
}

QString learnedAt(const LearnedLobes& learned, const SpeedDepth& at) {
  if (learned.state != LearnedLobes::State::Known || learned.speeds.empty() || learned.depths.empty()) return {};
  if (at.speed < learned.speeds.front() || at.speed > learned.speeds.back() || at.depth > learned.depths.back())
    return {};
  const double stable = learned.at(nearest(learned.speeds, at.speed), nearest(learned.depths, at.depth));
  return Learned::tr("Learned from cuts: stable here with %1").arg(percent(std::clamp(stable, 0.01, 0.99)));
}

QString marginLine(const DepthMargin& margin, UnitSystem units) {
  // As fine as its uncertainty: 0.1 mm, 0.01 in; of small cuts a tenth of that.
  const double rise = lengthIn(margin.rise, units), high = lengthIn(margin.high, units);
  const double fine = units == UnitSystem::Metric ? 0.1 : 0.01;
  const int decimals = (units == UnitSystem::Metric ? 1 : 2) + (high < 3.0 * fine ? 1 : 0);
  const auto shown = [&](double length) { return number(std::max(0.0, length), decimals); };
  if (rise < 0.5 * fine) return Learned::tr("No deeper: this cut is close to its limit");
  return Learned::tr("Depth could rise by about %1 (%2 to %3)")
      .arg(join(shown(rise), lengthUnit(units)), shown(lengthIn(margin.low, units)), shown(high));
}

QString evidenceText(const LearnedCut& cut, UnitSystem units) {
  const QString when =
      QLocale().toString(QDateTime::fromSecsSinceEpoch(static_cast<qint64>(cut.wallS)), QLocale::ShortFormat);
  const QString what = !cut.chatter ? Learned::tr("Judged cut: stable")
                       : cut.frequency.value > 0.0
                           ? Learned::tr("Judged cut: chatter, %1").arg(frequency(cut.frequency, cut.frequencySd))
                           : Learned::tr("Judged cut: chatter");
  return QStringLiteral("%1; %2; %3").arg(what, place(cut.at, units), when);
}

}  // namespace stillcut::ui
