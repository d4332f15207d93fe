#include "ui/widgets/param_row.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/base/format.h"
#include "ui/models/tune/param_scale.h"
#include "ui/widgets/painting.h"
#include "ui/widgets/text_label.h"
#include "ui/widgets/touch_button.h"
#include "ui/widgets/value_slider.h"

namespace stillcut::ui {
namespace {

TouchButton* smallButton(const QString& caption, const QString& spoken, const QString& name, QWidget* parent) {
  auto* button = new TouchButton(caption, TouchButton::Look::Plain, parent);
  button->setBaseHeight(46);
  button->setAccessibleName(spoken);
  button->setObjectName(name);
  button->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  return button;
}

}  // namespace

ParamRow::ParamRow(ParamModel& model, TuningController& controller, int row, QWidget* parent)
    : QWidget(parent),
      model_(model),
      controller_(controller),
      decl_(model.decl(row)),
      row_(row),
      theme_(makeTheme(ThemeKind::Light, 1.0)),
      label_(new TextLabel({type_size::kBody, true})),
      meaning_(new TextLabel({type_size::kLabel, false, true, true})),
      note_(new TextLabel({type_size::kLabel, false, true, true})) {
  setObjectName(QString::fromUtf8(decl_.key.data(), static_cast<qsizetype>(decl_.key.size())));
  auto* column = new QVBoxLayout(this);
  column->addWidget(label_);
  column->addWidget(meaning_);
  controls_ = new QHBoxLayout;
  column->addLayout(controls_);
  column->addWidget(note_);
  if (model.view(row).choices.isEmpty()) {
    makeNumber();
    controls_->addWidget(less_);
    controls_->addWidget(slider_, 1);
    controls_->addWidget(more_);
    controls_->addWidget(edit_);
    if (automatic_ != nullptr) controls_->addWidget(automatic_);
  } else {
    makeChoices();
    for (TouchButton* choice : choices_) controls_->addWidget(choice);
    controls_->addStretch(1);
  }
  refresh();
}

void ParamRow::makeNumber() {
  const QString label = model_.view(row_).label;
  slider_ = new ValueSlider(this);
  slider_->setObjectName(objectName() + QStringLiteral("-slider"));
  edit_ = new QLineEdit(this);
  edit_->setObjectName(objectName() + QStringLiteral("-edit"));
  edit_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  less_ = smallButton(QString(QChar(0x2212)), tr("Less: %1").arg(label), objectName() + QStringLiteral("-less"), this);
  more_ = smallButton(QStringLiteral("+"), tr("More: %1").arg(label), objectName() + QStringLiteral("-more"), this);
  connect(slider_, &ValueSlider::moved, this, [this](double fraction) { set(valueAt(decl_, fraction)); });
  const auto step = [this](int direction) { set(stepFrom(decl_, controller_.value(decl_), direction)); };
  connect(slider_, &ValueSlider::stepped, this, step);
  connect(slider_, &ValueSlider::released, &controller_, &TuningController::settle);
  connect(less_, &TouchButton::clicked, this, [this, step] {
    step(-1);
    controller_.settle();
  });
  connect(more_, &TouchButton::clicked, this, [this, step] {
    step(1);
    controller_.settle();
  });
  connect(edit_, &QLineEdit::editingFinished, this, &ParamRow::type);
  if (!decl_.mayBeAutomatic) return;
  automatic_ = smallButton(tr("AUTO"), tr("Automatic: %1").arg(label), objectName() + QStringLiteral("-auto"), this);
  automatic_->setCheckable(true);
  connect(automatic_, &TouchButton::clicked, this, [this] {
    // Leaving automatic begins at what the part chose, where it is known.
    const double chosen = model_.ownValue(decl_);
    const double own = std::isfinite(chosen) && config::isLegal(decl_, chosen) ? chosen : valueAt(decl_, 0.5);
    set(view_.isAutomatic ? own : config::kAutomatic);
    controller_.settle();
  });
}

void ParamRow::makeChoices() {
  const QStringList words = model_.view(row_).choices;
  for (int k = 0; k < words.size(); ++k) {
    auto* button = smallButton(words[k], QStringLiteral("%1: %2").arg(model_.view(row_).label, words[k]),
                               objectName() + QStringLiteral("-%1").arg(k), this);
    button->setCheckable(true);
    connect(button, &TouchButton::clicked, this, [this, k] {
      set(k);
      controller_.settle();
      refresh();
    });
    choices_.push_back(button);
  }
}

void ParamRow::set(double value) {
  model_.setData(model_.index(row_, ParamModel::Value), value);
}

void ParamRow::type() {
  if (edit_->text() == view_.value) return;
  const bool taken = model_.setData(model_.index(row_, ParamModel::Value), edit_->text());
  controller_.settle();
  refresh();
  if (taken) return;
  note_->setTone(Tone::Onset);
  note_->setText(tr("Not taken. Allowed: %1").arg(view_.range));
  note_->setVisible(true);
}

void ParamRow::refresh() {
  view_ = model_.view(row_);
  const QString spoken = QStringLiteral("%1: %2").arg(view_.label, join(view_.value, view_.unit));
  setAccessibleName(spoken);
  label_->setText(view_.otherSide ? tr("%1   (A and B differ)").arg(view_.label) : view_.label);
  meaning_->setText(view_.meaning);
  meaning_->setVisible(!view_.meaning.isEmpty());
  QStringList notes;
  if (!view_.automatic.isEmpty()) notes << tr("Automatic: %1").arg(view_.automatic);
  if (!view_.locked.isEmpty()) {
    notes << view_.locked;
  } else if (view_.changed && view_.automatic.isEmpty()) {
    notes << tr("Default: %1").arg(join(view_.fallback, view_.unit));
  }
  const QString note = notes.join(u'\n');
  note_->setTone(Tone::Normal);
  note_->setText(note);
  note_->setVisible(!note.isEmpty());
  const bool open = view_.locked.isEmpty();
  for (std::size_t k = 0; k < choices_.size(); ++k) {
    choices_[k]->setChecked(static_cast<int>(k) == view_.chosen);
    choices_[k]->setEnabled(open);
  }
  if (slider_ == nullptr) return;
  slider_->display(view_.fraction, view_.fallbackFraction, view_.isAutomatic);
  slider_->setAccessibleName(spoken);
  slider_->setEnabled(open);
  edit_->setAccessibleName(spoken);
  edit_->setToolTip(view_.range);
  edit_->setEnabled(open);
  if (!edit_->hasFocus() || !edit_->isModified())
    edit_->setText(join(view_.value, view_.isAutomatic ? QString() : view_.unit));
  less_->setEnabled(open);
  more_->setEnabled(open);
  if (automatic_ != nullptr) {
    automatic_->setChecked(view_.isAutomatic);
    automatic_->setEnabled(open);
  }
}

void ParamRow::seeAutomatic() {
  if (model_.view(row_).automatic != view_.automatic) refresh();
}

void ParamRow::applyTheme(const Theme& theme) {
  theme_ = theme;
  layout()->setContentsMargins(theme.px(14), theme.px(8), theme.px(14), theme.px(10));
  layout()->setSpacing(theme.px(4));
  controls_->setSpacing(std::max(theme.px(12), pixelsFor(kTouchGapMm, this)));
  if (edit_ != nullptr) {
    edit_->setFont(theme.font(type_size::kBody));
    edit_->setFixedSize(theme.px(132), touchHeight(theme, this));
  }
  update();
}

void ParamRow::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setPen(theme_.colors.border);
  p.drawLine(0, height() - 1, width(), height() - 1);
  if (!view_.changed) return;
  p.fillRect(QRect(0, theme_.px(8), theme_.px(4), height() - theme_.px(16)), theme_.colors.text);
}

}  // namespace stillcut::ui
