#include "ui/pages/analyse_tools.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <algorithm>

#include "ui/widgets/painting.h"
#include "ui/widgets/touch_button.h"

namespace stillcut::ui {

AnalyseTools::AnalyseTools(AnalyseView& view, QWidget* parent)
    : QWidget(parent),
      view_(view),
      row_(new QHBoxLayout(this)),
      live_(addButton(QStringLiteral("live"), tr("LIVE"), Qt::Key_Space)),
      reference_(nullptr),
      channel_(new QComboBox),
      theme_(makeTheme(ThemeKind::Light, 1.0)) {
  row_->setContentsMargins(0, 0, 0, 0);
  addToggle(
      QStringLiteral("waterfall"), tr("WATERFALL"), Qt::Key_W,
      [](AnalyseOptions& o) {
        o.form = o.form == SpectrogramForm::HeatMap ? SpectrogramForm::Waterfall : SpectrogramForm::HeatMap;
      },
      [](const AnalyseOptions& o) { return o.form == SpectrogramForm::Waterfall; });
  addToggle(
      QStringLiteral("linear"), tr("LINEAR"), Qt::Key_L,
      [](AnalyseOptions& o) { o.level = o.level == LevelScale::Decibel ? LevelScale::Linear : LevelScale::Decibel; },
      [](const AnalyseOptions& o) { return o.level == LevelScale::Linear; });
  addToggle(
      QStringLiteral("order"), tr("ORDERS"), Qt::Key_X,
      [](AnalyseOptions& o) { o.axis = o.axis == FrequencyAxis::Hertz ? FrequencyAxis::Order : FrequencyAxis::Hertz; },
      [](const AnalyseOptions& o) { return o.axis == FrequencyAxis::Order; });
  addToggle(
      QStringLiteral("max-hold"), tr("MAX HOLD"), Qt::Key_M, [](AnalyseOptions& o) { o.maxHold = !o.maxHold; },
      [](const AnalyseOptions& o) { return o.maxHold; });
  addToggle(
      QStringLiteral("events"), tr("EVENTS"), Qt::Key_E, [](AnalyseOptions& o) { o.events = !o.events; },
      [](const AnalyseOptions& o) { return o.events; });
  reference_ = addButton(QStringLiteral("reference"), tr("REFERENCE"), Qt::Key_R);
  TouchButton* file = addButton(QStringLiteral("analyse-file"), tr("FILE"), Qt::Key_F);
  file->setCheckable(false);
  connect(file, &TouchButton::clicked, this, &AnalyseTools::fileAsked);
  row_->addStretch(1);
  row_->addWidget(channel_);
  channel_->setObjectName(QStringLiteral("channel"));
  channel_->setAccessibleName(tr("Channel"));
  channel_->setToolTip(tr("Channel of spectrogram, spectrum and signal"));
  connect(live_, &TouchButton::clicked, this, [this] {
    if (view_.following()) {
      view_.pan(Seconds());
    } else {
      view_.follow();
    }
    showState();
  });
  connect(reference_, &TouchButton::clicked, this, &AnalyseTools::referenceAsked);
  connect(channel_, &QComboBox::activated, this, [this](int index) {
    AnalyseOptions o = view_.options();
    o.channel = index;
    view_.setOptions(o);
  });
  connect(&view_, &AnalyseView::changed, this, &AnalyseTools::showState);
  showState();
}

TouchButton* AnalyseTools::addButton(const QString& name, const QString& caption, Qt::Key key) {
  auto* button = new TouchButton(caption, TouchButton::Look::Plain, this);
  button->setObjectName(name);
  button->setKey(key);
  button->setCheckable(true);
  button->setBaseHeight(50);
  row_->addWidget(button);
  return button;
}

void AnalyseTools::addToggle(const QString& name, const QString& caption, Qt::Key key, const Change& change,
                             const IsOn& isOn) {
  TouchButton* button = addButton(name, caption, key);
  toggles_.push_back({button, isOn});
  connect(button, &TouchButton::clicked, this, [this, change] {
    AnalyseOptions o = view_.options();
    change(o);
    view_.setOptions(o);
    showState();
  });
}

void AnalyseTools::setChannels(const QStringList& names) {
  QStringList present;
  for (int k = 0; k < channel_->count(); ++k) present << channel_->itemText(k);
  if (present == names) return;
  channel_->clear();
  channel_->addItems(names);
  channel_->setEnabled(names.size() > 1);
  showState();
}

void AnalyseTools::setReference(bool on) {
  reference_->setChecked(on);
}

void AnalyseTools::showState() {
  live_->setChecked(view_.following());
  for (const Toggle& toggle : toggles_) toggle.button->setChecked(toggle.isOn(view_.options()));
  channel_->setCurrentIndex(std::min(view_.options().channel, channel_->count() - 1));
}

void AnalyseTools::applyTheme(const Theme& theme) {
  theme_ = theme;
  row_->setSpacing(std::max(theme.px(12), pixelsFor(kTouchGapMm, this)));
  channel_->setFont(theme.font(type_size::kButton));
  channel_->setMinimumHeight(std::max(theme.px(50), pixelsFor(kTouchMm, this)));
  channel_->setMinimumWidth(theme.px(130));
}

}  // namespace stillcut::ui
