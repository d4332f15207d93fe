#include "ui/shell/display_panel.h"

#include <QGridLayout>
#include <algorithm>

#include "ui/shell/raised_panel.h"
#include "ui/widgets/touch_button.h"

namespace stillcut::ui {

DisplayPanel::DisplayPanel(QWidget* parent) : QWidget(parent), theme_(makeTheme(ThemeKind::Light, 1.0)) {
  setAccessibleName(tr("Display"));
  new QGridLayout(this);
  addRow<ThemeKind>(
      QStringLiteral("theme"),
      {{ThemeKind::Light, tr("LIGHT")}, {ThemeKind::Dark, tr("DARK")}, {ThemeKind::HighContrast, tr("HIGH CONTRAST")}},
      &DisplayChoice::theme);
  addRow<TextSize>(
      QStringLiteral("text"),
      {{TextSize::Normal, tr("TEXT")}, {TextSize::Large, tr("LARGE TEXT")}, {TextSize::Largest, tr("LARGEST TEXT")}},
      &DisplayChoice::text);
  addRow<UnitSystem>(QStringLiteral("units"), {{UnitSystem::Metric, tr("METRIC")}, {UnitSystem::Inch, tr("INCH")}},
                     &DisplayChoice::units);
  std::vector<std::pair<Language, QString>> languages;
  languages.reserve(std::size(kLanguages));
  for (const Language language : kLanguages) languages.emplace_back(language, nameOfItself(language));
  addRow<Language>(QStringLiteral("language"), languages, &DisplayChoice::language);
  auto* grid = static_cast<QGridLayout*>(layout());
  help_ = new TouchButton(tr("HELP"), TouchButton::Look::Plain, this);
  help_->setObjectName(QStringLiteral("help"));
  help_->setAccessibleName(tr("The manual of this page"));
  help_->setHint(QStringLiteral("F1"));
  help_->setBaseHeight(50);
  grid->addWidget(help_, grid->rowCount(), 0);
  connect(help_, &TouchButton::clicked, this, [this] {
    hide();
    emit helpAsked();
  });
  hide();
}

template <class Value>
void DisplayPanel::addRow(const QString& name, const std::vector<std::pair<Value, QString>>& values,
                          Value DisplayChoice::*member) {
  auto* grid = static_cast<QGridLayout*>(layout());
  const int row = grid->rowCount();
  for (std::size_t k = 0; k < values.size(); ++k) {
    const Value value = values[k].first;
    auto* button = new TouchButton(values[k].second, TouchButton::Look::Plain, this);
    button->setObjectName(QStringLiteral("%1-%2").arg(name).arg(k));
    button->setCheckable(true);
    button->setBaseHeight(50);
    grid->addWidget(button, row, static_cast<int>(k));
    items_.push_back({button, [member, value](const DisplayChoice& choice) { return choice.*member == value; }});
    connect(button, &TouchButton::clicked, this, [this, member, value] {
      choice_.*member = value;
      showChecked();
      emit chosen(choice_);
    });
  }
}

void DisplayPanel::show(const DisplayChoice& choice) {
  choice_ = choice;
  showChecked();
  raise();
  setVisible(true);
}

void DisplayPanel::showChecked() {
  for (const Item& item : items_) item.button->setChecked(item.isChosen(choice_));
}

void DisplayPanel::applyTheme(const Theme& theme) {
  theme_ = theme;
  const int margin = theme.px(16), gap = std::max(theme.px(12), pixelsFor(kTouchGapMm, this));
  layout()->setContentsMargins(margin, margin, margin, margin);
  layout()->setSpacing(gap);
  updateGeometry();
}

QSize DisplayPanel::sizeHint() const {
  return layout()->sizeHint();
}

void DisplayPanel::paintEvent(QPaintEvent*) {
  QPainter p(this);
  drawRaised(p, rect(), theme_);
}

}  // namespace stillcut::ui
