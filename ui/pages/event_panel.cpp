#include "ui/pages/event_panel.h"

#include <QLineEdit>
#include <QListView>
#include <QScrollBar>
#include <QVBoxLayout>

#include "ui/widgets/painting.h"
#include "ui/widgets/text_label.h"
#include "ui/widgets/wrapped_list.h"

namespace stillcut::ui {

EventPanel::EventPanel(const QString& name, QWidget* parent)
    : Panel(parent),
      find_(new QLineEdit),
      list_(new QListView),
      none_(new TextLabel({type_size::kBody, false, true, true})) {
  auto* column = new QVBoxLayout(this);
  find_->setObjectName(name + QStringLiteral("-find"));
  find_->setPlaceholderText(tr("What happened at 13:58, or a word"));
  find_->setAccessibleName(tr("Search the events by time of day or by a word"));
  list_->setObjectName(name);
  list_->setAccessibleName(tr("What happened"));
  found_.setSourceModel(&model_);
  found_.setFilterCaseSensitivity(Qt::CaseInsensitive);
  list_->setModel(&found_);
  showWrapped(*list_);
  list_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  list_->setResizeMode(QListView::Adjust);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  column->addWidget(find_);
  column->addWidget(list_, 1);
  column->addWidget(none_);
  none_->setText(tr("Nothing has happened yet"));
  connect(find_, &QLineEdit::textChanged, this, &EventPanel::search);
  const auto go = [this](const QModelIndex& index) {
    if (index.isValid()) emit wentTo(model_.eventAt(found_.mapToSource(index).row()).time);
  };
  connect(list_, &QListView::clicked, this, go);
  connect(list_, &QListView::activated, this, go);
}

// Where nothing happened at the time that was asked for, what happened next to it.
void EventPanel::search() {
  const QString asked = find_->text().trimmed();
  found_.setFilterFixedString(asked);
  nearestShown_ = false;
  none_->setText(model_.rowCount() == 0 ? tr("Nothing has happened yet") : tr("Nothing like that"));
  if (const auto nearest = found_.rowCount() == 0 ? model_.nearestTo(asked) : std::nullopt) {
    nearestShown_ = true;
    found_.setFilterFixedString({});
    const QModelIndex there = found_.mapFromSource(model_.index(*nearest));
    list_->setCurrentIndex(there);
    list_->scrollTo(there, QAbstractItemView::PositionAtCenter);
    none_->setText(tr("Nothing at %1. The nearest is chosen").arg(asked));
    return none_->setVisible(true);
  }
  none_->setVisible(found_.rowCount() == 0);
}

void EventPanel::display(const std::vector<RunEvent>& events, const std::function<qint64(Instant)>& wallMs,
                         UnitSystem units) {
  // Whoever has scrolled away from the newest event goes on reading where he is.
  const bool reading = list_->verticalScrollBar()->value() > 0;
  const QPersistentModelIndex top = reading ? list_->indexAt({list_->width() / 2, 1}) : QModelIndex();
  const int place = top.isValid() ? list_->visualRect(top).top() : 0;
  model_.show(events, wallMs, units);
  if (top.isValid()) {
    list_->doItemsLayout();
    list_->verticalScrollBar()->setValue(list_->verticalScrollBar()->value() + list_->visualRect(top).top() - place);
  }
  if (nearestShown_ && !events.empty()) return;  // and says so
  none_->setText(events.empty() ? tr("Nothing has happened yet") : tr("Nothing like that"));
  none_->setVisible(found_.rowCount() == 0);
}

void EventPanel::applyTheme(const Theme& theme) {
  Panel::applyTheme(theme);
  layout()->setContentsMargins(theme.px(10), theme.px(8), theme.px(10), theme.px(8));
  layout()->setSpacing(theme.px(8));
  find_->setFont(theme.font(type_size::kBody));
  find_->setFixedHeight(touchHeight(theme, this, 48));
  list_->setFont(theme.font(type_size::kBody));
}

}  // namespace stillcut::ui
