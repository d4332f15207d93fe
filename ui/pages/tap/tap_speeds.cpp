#include "ui/pages/tap/tap_speeds.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QSettings>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/base/format.h"
#include "ui/base/say.h"
#include "ui/models/tap/tap_text.h"
#include "ui/widgets/text_label.h"
#include "ui/widgets/tool_button.h"

namespace stillcut::ui {

TapSpeeds::TapSpeeds(TapController& controller, QWidget* parent)
    : TapPart(controller, parent),
      material_(makeChoice(tr("Material"), QStringLiteral("tap-material"))),
      side_(makeChoice(tr("Climb or conventional"), QStringLiteral("tap-side"))),
      teeth_(makeNumber(tr("Flutes"), QStringLiteral("tap-teeth"))),
      diameter_(makeNumber(tr("Diameter"), QStringLiteral("tap-diameter"))),
      width_(makeNumber(tr("Width of cut"), QStringLiteral("tap-width"))),
      feed_(makeNumber(tr("Feed per tooth"), QStringLiteral("tap-feed"))),
      lowest_(makeNumber(tr("Lowest speed"), QStringLiteral("tap-lowest"))),
      highest_(makeNumber(tr("Highest speed"), QStringLiteral("tap-highest"))),
      deepest_(makeNumber(tr("Deepest cut"), QStringLiteral("tap-deepest"))),
      answer_(new TextLabel({type_size::kFault, true, false, true})),
      detail_(new TextLabel({type_size::kBody, false, true, true})),
      said_(new TextLabel({type_size::kBody, false, false, true})),
      tool_(makeChoice(tr("Tool"), QStringLiteral("tap-tool"))),
      keep_(makeToolButton(tr("KEEP"), tr("Keep modes and cut for this tool"), "tap-keep-cut")) {
  auto* column = new QVBoxLayout(this);
  auto* form = new QGridLayout;
  int place = 0;
  const auto add = [&](QWidget* field) {
    auto* label = new TextLabel(TextLabel::Look{type_size::kLabel}, field->accessibleName());
    form->addWidget(label, place / 3 * 2, place % 3);
    form->addWidget(field, place / 3 * 2 + 1, place % 3);
    ++place;
  };
  for (QWidget* field : std::initializer_list<QWidget*>{material_, teeth_, diameter_, side_, width_, feed_, lowest_,
                                                        highest_, deepest_}) {
    add(field);
  }
  // Names of materials are long, numbers short.
  for (int k = 0; k < 3; ++k) form->setColumnStretch(k, k == 0 ? 2 : 1);
  material_->setMinimumContentsLength(18);
  column->addLayout(form);
  answer_->setObjectName(QStringLiteral("tap-answer"));
  detail_->setObjectName(QStringLiteral("tap-answer-detail"));
  column->addSpacing(8);
  column->addWidget(answer_);
  column->addWidget(detail_);
  column->addStretch(1);
  column->addWidget(said_);
  auto* keeping = new QHBoxLayout;
  keeping->addWidget(new TextLabel(TextLabel::Look{type_size::kBody}, tr("Keep for")));
  keeping->addWidget(tool_, 1);
  keeping->addWidget(keep_);
  column->addLayout(keeping);
  said_->setObjectName(QStringLiteral("tap-cut-kept"));
  said_->hide();
  connect(tool_, &QComboBox::activated, this, [this](int row) {
    keep_->setAsking(false);
    if (row > 0) fill(controller_.withTool(typed(), tool_->currentText()));
    edited();
  });
  connect(keep_, &TouchButton::clicked, this, [this] {
    const QString tool = tool_->currentIndex() > 0 ? tool_->currentText() : QString();
    if (asksFirst(keep_, said_, controller_.keptAlready(TapKept::Cut, tool))) return;
    const auto kept = controller_.saveCut(tool);
    said_->setTone(kept ? Tone::Normal : Tone::Onset);
    said_->setText(kept ? tr("Kept: %1").arg(*kept) : sayError(kept.error()));
    said_->show();
  });
  for (const TapMaterial& material : controller.materials()) material_->addItem(material.name, material.id);
  side_->addItems({tr("climb"), tr("conventional")});
  for (QDoubleSpinBox* box : {teeth_, lowest_, highest_}) box->setDecimals(0);
  teeth_->setRange(1, 64);
  for (QDoubleSpinBox* box : {lowest_, highest_}) {
    box->setRange(100, 100000);
    box->setSingleStep(500);
    box->setSuffix(QChar(0xa0) + rpmUnit());
  }
  fill({});
  for (QDoubleSpinBox* box : {teeth_, diameter_, width_, feed_, lowest_, highest_, deepest_}) {
    box->setKeyboardTracking(false);
    connect(box, &QDoubleSpinBox::valueChanged, this, &TapSpeeds::edited);
  }
  for (QComboBox* box : {material_, side_}) connect(box, &QComboBox::activated, this, &TapSpeeds::edited);
}

TapCut TapSpeeds::typed() const {
  TapCut cut;
  cut.material = material_->currentData().toString();
  cut.teeth = static_cast<int>(teeth_->value());
  cut.diameter = lengthFrom(diameter_->value(), units_);
  cut.immersion = std::clamp(lengthFrom(width_->value(), units_) / cut.diameter, 0.005, 1.0);
  cut.upMilling = side_->currentIndex() == 1;
  cut.lowest = Rpm(std::min(lowest_->value(), highest_->value() - 100.0));
  cut.highest = Rpm(highest_->value());
  cut.feedPerTooth = lengthFrom(feed_->value(), units_);
  cut.deepest = lengthFrom(deepest_->value(), units_);
  return cut;
}

void TapSpeeds::fill(const TapCut& cut) {
  const bool inch = units_ == UnitSystem::Inch;
  const struct {
    QDoubleSpinBox* box;
    Metres value;
    int decimals;
    double least, most;  // [m]
  } lengths[] = {{diameter_, cut.diameter, inch ? 4 : 2, 0.1e-3, 0.5},
                 {width_, cut.diameter * cut.immersion, inch ? 4 : 2, 0.01e-3, 0.5},
                 {feed_, cut.feedPerTooth, inch ? 5 : 3, 1e-6, 5e-3},
                 {deepest_, cut.deepest, inch ? 4 : 2, 0.1e-3, 0.2}};
  for (const auto& length : lengths) {
    const QSignalBlocker quiet(length.box);
    length.box->setDecimals(length.decimals);
    length.box->setSuffix(QChar(0xa0) + lengthUnit(units_));
    length.box->setRange(lengthIn(Metres(length.least), units_), lengthIn(Metres(length.most), units_));
    length.box->setValue(lengthIn(length.value, units_));
  }
  const QSignalBlocker quietTeeth(teeth_), quietLowest(lowest_), quietHighest(highest_);
  teeth_->setValue(cut.teeth);
  lowest_->setValue(cut.lowest.value);
  highest_->setValue(cut.highest.value);
  side_->setCurrentIndex(cut.upMilling ? 1 : 0);
  const int row = material_->findData(cut.material);
  if (row >= 0) material_->setCurrentIndex(row);
}

void TapSpeeds::edited() {
  asked_ = true;
  controller_.compute(typed());
  emit stateChanged();
}

// Set up may have added one meanwhile; the library is a file, and not read with every picture.
void TapSpeeds::showEvent(QShowEvent* event) {
  TapPart::showEvent(event);
  const QStringList tools = QStringList{tr("a file alone")} + controller_.tools();
  if (tools != tools_) {
    tools_ = tools;
    const QString chosen = tool_->currentText();
    tool_->clear();
    tool_->addItems(tools_);
    tool_->setCurrentIndex(std::max(tool_->findText(chosen), 0));
  }
}

void TapSpeeds::refresh(int, UnitSystem units) {
  if (units != units_) {
    const TapCut cut = typed();
    units_ = units;
    fill(cut);
  }
  if (!asked_) {
    asked_ = true;
    controller_.compute(typed());
  }
  keep_->setEnabled(!controller_.lobes().limits.empty());
  const TapSign answer = tapAnswer(controller_.lobes(), units_);
  answer_->setTone(answer.tone);
  answer_->setText(answer.text);
  detail_->setText(answer.detail);
}

void TapSpeeds::keep(QSettings& settings) const {
  const TapCut cut = typed();
  settings.setValue(QStringLiteral("material"), cut.material);
  settings.setValue(QStringLiteral("teeth"), cut.teeth);
  settings.setValue(QStringLiteral("diameter"), cut.diameter.value);
  settings.setValue(QStringLiteral("immersion"), cut.immersion);
  settings.setValue(QStringLiteral("up"), cut.upMilling);
  settings.setValue(QStringLiteral("lowest"), cut.lowest.value);
  settings.setValue(QStringLiteral("highest"), cut.highest.value);
  settings.setValue(QStringLiteral("feed"), cut.feedPerTooth.value);
  settings.setValue(QStringLiteral("deepest"), cut.deepest.value);
}

void TapSpeeds::restore(const QSettings& settings) {
  TapCut cut;
  const auto kept = [&](const char* key, double otherwise) {
    const double value = settings.value(QLatin1String(key), otherwise).toDouble();
    return value > 0.0 ? value : otherwise;
  };
  cut.material = settings.value(QStringLiteral("material")).toString();
  cut.teeth = static_cast<int>(kept("teeth", cut.teeth));
  cut.diameter = Metres(kept("diameter", cut.diameter.value));
  cut.immersion = std::min(kept("immersion", cut.immersion), 1.0);
  cut.upMilling = settings.value(QStringLiteral("up"), false).toBool();
  cut.lowest = Rpm(kept("lowest", cut.lowest.value));
  cut.highest = Rpm(kept("highest", cut.highest.value));
  cut.feedPerTooth = Metres(kept("feed", cut.feedPerTooth.value));
  cut.deepest = Metres(kept("deepest", cut.deepest.value));
  fill(cut);
}

}  // namespace stillcut::ui
