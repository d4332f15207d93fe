#include "ui/pages/rule_grid.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/base/format.h"
#include "ui/widgets/painting.h"

namespace stillcut::ui {
namespace {

constexpr double kNothing = 5.0, kMost = 4.0;  // the rule that asks for nothing, and how far others are from it
constexpr double kLearned = 0.05;              // less is not shown

QColor mixed(const QColor& a, const QColor& b, double share) {
  const auto blend = [share](int x, int y) { return static_cast<int>(x + (y - x) * share); };
  return {blend(a.red(), b.red()), blend(a.green(), b.green()), blend(a.blue(), b.blue())};
}

QString ruleText(double rule) {
  return number(rule, std::abs(rule - std::round(rule)) < 0.05 ? 0 : 1);
}

}  // namespace

QStringList ruleSetNames() {
  return {QStringLiteral("NX"), QStringLiteral("NB"), QStringLiteral("NM"), QStringLiteral("NS"), QStringLiteral("ZE"),
          QStringLiteral("PS"), QStringLiteral("PM"), QStringLiteral("PB"), QStringLiteral("PX")};
}

RuleGrid::RuleGrid(QWidget* parent) : QWidget(parent), theme_(makeTheme(ThemeKind::Light, 1.0)) {
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Rule table"));
}

void RuleGrid::display(const Cells& cells) {
  if (cells == cells_) return;
  cells_ = cells;
  setAccessibleDescription(cellText(chosen_));
  update();
}

void RuleGrid::choose(int cell) {
  chosen_ = std::clamp(cell, 0, kCells - 1);
  setAccessibleDescription(cellText(chosen_));
  update();
  emit chosenChanged(chosen_);
}

QString RuleGrid::cellText(int cell) const {
  const QStringList names = ruleSetNames();
  const RuleCell& c = cells_[static_cast<std::size_t>(cell)];
  const int word = std::clamp(static_cast<int>(std::lround(c.rule)) - 1, 0, kRuleSets - 1);
  const QString rule = tr("error %1, change %2: %3 (%4)")
                           .arg(names[cell / kRuleSets], names[cell % kRuleSets], ruleText(c.rule), names[word]);
  return std::abs(c.now - c.rule) < kLearned ? rule : tr("%1, learned %2").arg(rule, number(c.now, 1));
}

void RuleGrid::applyTheme(const Theme& theme) {
  theme_ = theme;
  updateGeometry();
  update();
}

double RuleGrid::side() const {
  return std::max(theme_.px(46), pixelsFor(kTouchMm, this));
}

double RuleGrid::header() const {
  return theme_.px(34);
}

QSize RuleGrid::sizeHint() const {
  const int size = static_cast<int>(header() + kRuleSets * side()) + 2;
  return {size, size};
}

QRectF RuleGrid::place(int row, int column) const {
  return {header() + column * side(), header() + row * side(), side(), side()};
}

void RuleGrid::mousePressEvent(QMouseEvent* event) {
  const int column = static_cast<int>(std::floor((event->position().x() - header()) / side()));
  const int row = static_cast<int>(std::floor((event->position().y() - header()) / side()));
  if (column < 0 || row < 0 || column >= kRuleSets || row >= kRuleSets) return;
  choose(row * kRuleSets + column);
}

void RuleGrid::keyPressEvent(QKeyEvent* event) {
  const int row = chosen_ / kRuleSets, column = chosen_ % kRuleSets;
  const auto go = [this](int r, int c) {
    choose(std::clamp(r, 0, kRuleSets - 1) * kRuleSets + std::clamp(c, 0, kRuleSets - 1));
  };
  switch (event->key()) {
    case Qt::Key_Left:
      return go(row, column - 1);
    case Qt::Key_Right:
      return go(row, column + 1);
    case Qt::Key_Up:
      return go(row - 1, column);
    case Qt::Key_Down:
      return go(row + 1, column);
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      emit stepped(chosen_, 1);
      return;
    case Qt::Key_Minus:
      emit stepped(chosen_, -1);
      return;
    case Qt::Key_Delete:
      emit reset(chosen_);
      return;
    default:
      QWidget::keyPressEvent(event);
  }
}

// Down is dark, up is light with a frame, nothing is blank; the number always says it as well.
void RuleGrid::paintEvent(QPaintEvent*) {
  QPainter p(this);
  const ThemeColors& c = theme_.colors;
  const QStringList names = ruleSetNames();
  TextPainter text(p, theme_);
  const TextStyle small{type_size::kTick, false, c.secondary, Qt::AlignHCenter};
  for (int k = 0; k < kRuleSets; ++k) {
    text.centred({0, place(k, 0).top(), header(), side()}, names[k], small);
    text.centred({place(0, k).left(), 0, side(), header()}, names[k], small);
  }
  for (int cell = 0; cell < kCells; ++cell) {
    const RuleCell& rule = cells_[static_cast<std::size_t>(cell)];
    const QRectF box = place(cell / kRuleSets, cell % kRuleSets).adjusted(1, 1, -1, -1);
    const double pull = std::clamp((kNothing - rule.rule) / kMost, -1.0, 1.0);
    p.fillRect(box, pull > 0.0 ? mixed(c.track, c.fill, pull) : mixed(c.panel, c.track, 1.0 + pull));
    p.setPen(QPen(c.border, 1.0));
    p.setBrush(Qt::NoBrush);
    p.drawRect(box);
    const bool learned = std::abs(rule.now - rule.rule) >= kLearned;
    const TextStyle value{type_size::kBody, rule.changed, c.text, Qt::AlignHCenter};
    text.centred(learned ? QRectF(box.left(), box.top(), box.width(), box.height() * 0.55) : box, ruleText(rule.rule),
                 value);
    if (!learned) continue;
    const QString sign = rule.now < rule.rule ? QStringLiteral("\u25be") : QStringLiteral("\u25b4");
    text.centred({box.left(), box.top() + box.height() * 0.5, box.width(), box.height() * 0.45},
                 sign + number(rule.now, 1), {type_size::kTick, true, c.text, Qt::AlignHCenter});
  }
  p.setPen(QPen(hasFocus() ? c.advice : c.secondary, theme_.px(3)));
  p.setBrush(Qt::NoBrush);
  p.drawRect(place(chosen_ / kRuleSets, chosen_ % kRuleSets).adjusted(1, 1, -1, -1));
}

}  // namespace stillcut::ui
