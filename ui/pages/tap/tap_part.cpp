#include "ui/pages/tap/tap_part.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QLayout>
#include <QLineEdit>
#include <QTableView>
#include <algorithm>

#include "ui/models/tap/tick_table.h"
#include "ui/widgets/painting.h"
#include "ui/widgets/text_label.h"
#include "ui/widgets/touch_button.h"

namespace stillcut::ui {

TapPart::TapPart(TapController& controller, QWidget* parent)
    : Panel(parent), controller_(controller), theme_(makeTheme(ThemeKind::Light, 1.0)) {}

QComboBox* TapPart::makeChoice(const QString& spoken, const QString& name) {
  auto* choice = new QComboBox;
  choice->setObjectName(name);
  choice->setAccessibleName(spoken);
  choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  choice->setMinimumContentsLength(6);
  typed_.push_back(choice);
  return choice;
}

QDoubleSpinBox* TapPart::makeNumber(const QString& spoken, const QString& name) {
  auto* box = new QDoubleSpinBox;
  box->setObjectName(name);
  box->setAccessibleName(spoken);
  box->setButtonSymbols(QAbstractSpinBox::NoButtons);  // too small for a glove
  typed_.push_back(box);
  return box;
}

QLineEdit* TapPart::makeEdit(const QString& spoken, const QString& name) {
  auto* edit = new QLineEdit;
  edit->setObjectName(name);
  edit->setAccessibleName(spoken);
  typed_.push_back(edit);
  return edit;
}

QTableView* TapPart::makeTable(TickTable& rows, const QString& spoken, const QString& name) {
  auto* table = new QTableView;
  table->setModel(&rows);
  table->setObjectName(name);
  table->setAccessibleName(spoken);
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->setSelectionMode(QAbstractItemView::SingleSelection);
  table->setTabKeyNavigation(false);
  table->verticalHeader()->hide();
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table->horizontalHeader()->setStretchLastSection(true);
  connect(table, &QTableView::clicked, &rows, &TickTable::toggle);
  connect(table, &QTableView::activated, &rows, &TickTable::toggle);
  tables_.push_back(table);
  return table;
}

bool TapPart::asksFirst(TouchButton* keep, TextLabel* said, const QString& there) {
  const bool asks = !there.isEmpty() && !keep->asking();
  keep->setAsking(asks, tr("KEEP?"));
  if (!asks) return false;
  said->setTone(Tone::Onset);
  said->setText(tr("%1 is there already. Touch KEEP again to overwrite it, or give another name.").arg(there));
  said->show();
  return true;
}

void TapPart::dressTyped(QWidget* field) const {
  field->setFont(theme_.font(type_size::kBody));
  field->setFixedHeight(touchHeight(theme_, this));
}

void TapPart::applyTheme(const Theme& theme) {
  Panel::applyTheme(theme);
  theme_ = theme;
  const int high = touchHeight(theme, this);
  for (QWidget* widget : typed_) dressTyped(widget);
  for (QTableView* table : tables_) {
    table->setFont(theme.font(type_size::kBody));
    table->horizontalHeader()->setFont(theme.font(type_size::kLabel));
    table->verticalHeader()->setDefaultSectionSize(high);
  }
  if (layout() == nullptr) return;
  layout()->setContentsMargins(theme.px(14), theme.px(12), theme.px(14), theme.px(12));
  layout()->setSpacing(std::max(theme.px(10), pixelsFor(kTouchGapMm, this)));
}

}  // namespace stillcut::ui
