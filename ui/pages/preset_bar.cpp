#include "ui/pages/preset_bar.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLineEdit>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/base/format.h"
#include "ui/models/time_text.h"
#include "ui/widgets/painting.h"
#include "ui/widgets/touch_button.h"

namespace stillcut::ui {
namespace {

constexpr double kReadings = 50;

}  // namespace

PresetBar::PresetBar(AnalyseView& view, PresetList& presets, QWidget* parent)
    : QWidget(parent),
      view_(view),
      presets_(presets),
      grid_(new QGridLayout(this)),
      names_(new QComboBox),
      save_(new TouchButton(tr("SAVE"))),
      drop_(new TouchButton(tr("DELETE"))),
      moment_(new QLineEdit),
      go_(new TouchButton(tr("GO TO"))),
      theme_(makeTheme(ThemeKind::Light, 1.0)) {
  names_->setObjectName(QStringLiteral("preset"));
  names_->setModel(&presets_);
  names_->setEditable(true);
  names_->setInsertPolicy(QComboBox::NoInsert);
  names_->setAccessibleName(tr("Preset"));
  names_->setToolTip(tr("Choose a preset, or type a name and save what is on show"));
  moment_->setObjectName(QStringLiteral("moment"));
  moment_->setAccessibleName(tr("Moment"));
  moment_->setPlaceholderText(tr("14:03:20 or -12 s"));
  save_->setObjectName(QStringLiteral("save-preset"));
  drop_->setObjectName(QStringLiteral("drop-preset"));
  go_->setObjectName(QStringLiteral("go-to"));
  for (TouchButton* button : {save_, drop_, go_}) button->setBaseHeight(50);
  grid_->addWidget(names_, 0, 0);
  grid_->addWidget(save_, 0, 1);
  grid_->addWidget(drop_, 0, 2);
  grid_->addWidget(moment_, 1, 0);
  grid_->addWidget(go_, 1, 1, 1, 2);
  grid_->setColumnStretch(0, 1);
  connect(names_, &QComboBox::activated, this, &PresetBar::choose);
  connect(names_, &QComboBox::editTextChanged, this, [this](const QString& name) { offerBack({}, name); });
  connect(save_, &TouchButton::clicked, this, &PresetBar::save);
  connect(drop_, &TouchButton::clicked, this, &PresetBar::drop);
  connect(go_, &TouchButton::clicked, this, &PresetBar::go);
  connect(moment_, &QLineEdit::returnPressed, this, &PresetBar::go);
  connect(moment_, &QLineEdit::textEdited, this, [this] {
    refused_ = false;
    update();
  });
  connect(&view_, &AnalyseView::changed, this, qOverload<>(&QWidget::update));
  drop_->setEnabled(false);
}

void PresetBar::display(const SessionInfo& info) {
  info_ = &info;
}

void PresetBar::choose(int row) {
  if (const auto options = presets_.options(row)) view_.setOptions(*options);
}

void PresetBar::save() {
  const QString name = names_->currentText().simplified().left(40);
  if (!presets_.save(name, view_.options())) return;
  names_->setCurrentIndex(presets_.rowOf(name));
  offerBack({}, name);
}

// The touch that has deleted one brings it back, until another is looked at.
void PresetBar::drop() {
  if (dropped_) {
    const auto [name, options] = *dropped_;
    presets_.save(name, options);
    names_->setCurrentIndex(presets_.rowOf(name));
    offerBack({}, name);
    return;
  }
  const QString name = names_->currentText();
  const int row = presets_.rowOf(name);
  const auto options = presets_.options(row);
  if (options && presets_.remove(row)) offerBack(std::pair(name, *options), {});
}

void PresetBar::offerBack(std::optional<std::pair<QString, AnalyseOptions>> dropped, const QString& shown) {
  dropped_ = std::move(dropped);
  drop_->setText(dropped_ ? tr("UNDO") : tr("DELETE"));
  drop_->setEnabled(dropped_ || presets_.isOwn(presets_.rowOf(shown)));
}

void PresetBar::go() {
  const auto moment = info_ ? momentFrom(moment_->text(), *info_, view_.newest()) : std::nullopt;
  refused_ = !moment;
  if (moment) {
    view_.goTo(*moment);
    view_.setCursor(AnalyseView::A, *moment);
  }
  update();
}

void PresetBar::applyTheme(const Theme& theme) {
  theme_ = theme;
  const int gap = std::max(theme.px(12), pixelsFor(kTouchGapMm, this)),
            high = std::max(theme.px(50), pixelsFor(kTouchMm, this));
  grid_->setContentsMargins(theme.px(12), theme.px(kReadings), theme.px(12), theme.px(10));
  grid_->setSpacing(gap);
  names_->setFont(theme.font(type_size::kBody));
  moment_->setFont(theme.font(type_size::kBody));
  names_->setMinimumHeight(high);
  moment_->setMinimumHeight(high);
  updateGeometry();
}

QSize PresetBar::minimumSizeHint() const {
  return grid_->minimumSize();
}

// "A 14:03:20.120   B 14:03:20.870   B - A 750 ms, 1.3 Hz"
QString PresetBar::cursorText() const {
  if (info_ == nullptr) return {};
  const auto text = [&](AnalyseView::Cursor c, const char* name) {
    const auto t = view_.cursor(c);
    if (!t) return QString();
    const qint64 wall = info_->wallMs(*t);
    return QStringLiteral("%1 %2.%3").arg(QLatin1String(name), clockTime(wall)).arg(wall % 1000, 3, 10, QChar(u'0'));
  };
  QStringList parts{text(AnalyseView::A, "A"), text(AnalyseView::B, "B")};
  const auto a = view_.cursor(AnalyseView::A), b = view_.cursor(AnalyseView::B);
  if (a && b) parts << QStringLiteral("B\u2212A %1").arg(duration(Seconds(std::abs(secondsBetween(*a, *b).value))));
  parts.removeAll(QString());
  return parts.isEmpty() ? tr("No cursor: click into a plot, with Shift for B") : parts.join(QStringLiteral("   "));
}

void PresetBar::paintEvent(QPaintEvent*) {
  QPainter p(this);
  TextPainter text(p, theme_);
  const QRectF line(theme_.px(12), theme_.px(4), width() - theme_.px(24), theme_.px(kReadings - 8));
  if (refused_) {
    text.centred(line, tr("Not a moment: write 14:03:20, or -12 for seconds ago"),
                 {type_size::kBody, true, theme_.colors.onsetText, Qt::AlignLeft, 0.65});
  } else {
    text.centred(line, cursorText(), {type_size::kBody, false, theme_.colors.text, Qt::AlignLeft, 0.65});
  }
  clipped_ = text.clipped();
}

}  // namespace stillcut::ui
