#include "ui/widgets/override_table.h"

#include <QPainter>
#include <array>

#include "ui/widgets/painting.h"

namespace stillcut::ui {
namespace {

constexpr double kHead = 25;
constexpr double kRow = 32;

// Left edges and widths of the columns, as shares of what is right of the label.
constexpr std::array<double, 3> kRight{0.28, 0.56, 0.84};

}  // namespace

OverrideTable::OverrideTable(QWidget* parent) : QWidget(parent), theme_(makeTheme(ThemeKind::Light, 1.0)) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Speed and feed"));
}

void OverrideTable::display(const MachineView& view) {
  if (view == view_) return;
  view_ = view;
  const auto spoken = [](const OverrideRow& r) {
    return tr("%1: programmed %2, override %3, actual %4 %5")
        .arg(r.label, r.programmed, r.overridden, r.actual, r.unit);
  };
  setAccessibleDescription(QStringList{spoken(view.speed), spoken(view.feed), view.note}.join(QStringLiteral(". ")));
  update();
}

void OverrideTable::applyTheme(const Theme& theme) {
  theme_ = theme;
  updateGeometry();
  update();
}

QSize OverrideTable::sizeHint() const {
  return {theme_.px(420), theme_.px(kHead + 2 * kRow)};
}

void OverrideTable::paintEvent(QPaintEvent*) {
  QPainter p(this);
  TextPainter text(p, theme_);
  const double label = theme_.px(124), rest = width() - label, head = theme_.px(kHead), row = theme_.px(kRow);
  const std::array<QString, 3> heads{tr("programmed"), tr("override"), tr("actual")};
  const double column = rest * 0.26;
  // What keeps the overrides from working is worth more than the names of the columns.
  if (view_.warning) {
    text.centred(QRectF(0, 0, width(), head), view_.note,
                 {type_size::kLabel, true, theme_.colors.onsetText, Qt::AlignLeft, 0.8});
  } else {
    text.centred(QRectF(0, 0, label + rest * 0.1, head), view_.note,
                 {type_size::kLabel, false, theme_.colors.secondary, Qt::AlignLeft, 0.8});
  }
  for (std::size_t k = 0; k < heads.size() && !view_.warning; ++k) {
    const double right = label + rest * kRight[k];
    text.centred(QRectF(right - column, 0, column, head), heads[k],
                 {type_size::kLabel, false, theme_.colors.secondary, Qt::AlignRight, 0.8});
  }
  double y = head;
  for (const OverrideRow* r : {&view_.speed, &view_.feed}) {
    text.centred(QRectF(0, y, label, row), r->label,
                 {type_size::kBody, false, theme_.colors.secondary, Qt::AlignLeft, 0.8});
    const std::array<const QString*, 3> values{&r->programmed, &r->overridden, &r->actual};
    for (std::size_t k = 0; k < values.size(); ++k) {
      const QColor color = r->old ? theme_.colors.faint : k == 1 ? theme_.onPanel(r->tone) : theme_.colors.text;
      const double right = label + rest * kRight[k];
      text.centred(QRectF(right - column, y, column, row), *values[k],
                   {type_size::kValue, k != 0, color, Qt::AlignRight, 0.8});
    }
    text.centred(QRectF(label + rest * kRight[2] + theme_.px(8), y, rest * (1 - kRight[2]) - theme_.px(8), row),
                 r->unit, {type_size::kBody, false, theme_.colors.secondary, Qt::AlignLeft, 0.7});
    y += row;
  }
  clipped_ = text.clipped();
}

}  // namespace stillcut::ui
