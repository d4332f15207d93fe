#include "ui/pages/session_list.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QListView>
#include <QScrollBar>
#include <algorithm>

#include "ui/pages/tool_button.h"
#include "ui/widgets/painting.h"
#include "ui/widgets/text_label.h"
#include "ui/widgets/wrapped_list.h"

namespace stillcut::ui {

SessionList::SessionList(SessionController* controller, QWidget* parent)
    : QWidget(parent),
      controller_(controller),
      kinds_(new QHBoxLayout),
      orders_(new QHBoxLayout),
      ends_(new QHBoxLayout),
      list_(new QListView),
      historyList_(new QListView) {
  order_.setSourceModel(&sessions_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  filter_ = new QLineEdit;
  filter_->setObjectName(QStringLiteral("session-filter"));
  filter_->setPlaceholderText(tr("Find job or tool"));
  filter_->setAccessibleName(filter_->placeholderText());
  filter_->setClearButtonEnabled(false);
  connect(filter_, &QLineEdit::textChanged, this, [this](const QString& text) {
    order_.setFilterFixedString(text);
    foundGroups_.setFilterFixedString(text);
    sayWhatIsMissing();
    lookInsideShown();
  });
  byJob_ = toolButton(tr("JOB"), tr("Order by job"), "sessions-by-job");
  byTool_ = toolButton(tr("TOOL"), tr("Order by tool"), "sessions-by-tool");
  byTime_ = toolButton(tr("TIME"), tr("Order by time"), "sessions-by-time");
  for (const auto& [button, by] : {std::pair{byJob_, SessionOrder::Job}, std::pair{byTool_, SessionOrder::Tool},
                                   std::pair{byTime_, SessionOrder::Time}}) {
    button->setCheckable(true);
    orders_->addWidget(button);
    connect(button, &TouchButton::clicked, this, [this, by = by] { orderBy(by); });
  }
  recorded_ = toolButton(tr("RECORDED"), tr("Recordings of the folder"), "sessions-recorded");
  simulated_ = toolButton(tr("SIMULATED"), tr("Simulated cuts, replayed as recordings are"), "sessions-simulated");
  for (TouchButton* button : {recorded_, simulated_}) {
    button->setCheckable(true);
    kinds_->addWidget(button);
    connect(button, &TouchButton::clicked, this, [this, button] { showSimulated(button == simulated_); });
  }
  recorded_->setChecked(true);
  makeHistory();
  orderBy(SessionOrder::Time);
  list_->setObjectName(QStringLiteral("session-list"));
  list_->setAccessibleName(tr("Recordings"));
  list_->setModel(&order_);
  for (QListView* list : {list_, historyList_}) {
    showWrapped(*list);
    list->setResizeMode(QListView::Adjust);
    list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  }
  const auto openIndex = [this](const QModelIndex& index) {
    const QString path = index.data(SessionListModel::PathRole).toString();
    if (controller_ != nullptr && !path.isEmpty() && path != controller_->openedPath()) controller_->open(path);
  };
  connect(list_->verticalScrollBar(), &QScrollBar::valueChanged, this, &SessionList::lookInsideShown);
  connect(list_->verticalScrollBar(), &QScrollBar::rangeChanged, this, &SessionList::lookInsideShown);
  connect(list_, &QListView::clicked, this, openIndex);
  connect(list_, &QListView::activated, this, openIndex);
  empty_ = new TextLabel({type_size::kBody, false, true, true});
  folder_ = new QLineEdit;
  folder_->setObjectName(QStringLiteral("session-folder"));
  folder_->setAccessibleName(tr("Folder of the recordings"));
  connect(folder_, &QLineEdit::editingFinished, this, [this] {
    if (controller_ != nullptr && folder_->text() != controller_->folder()) controller_->setFolder(folder_->text());
  });
  column->addLayout(kinds_);
  column->addWidget(filter_);
  column->addLayout(orders_);
  column->addWidget(list_, 1);
  column->addWidget(historyList_, 1);
  column->addWidget(empty_);
  ends_->addWidget(folder_, 1);
  ends_->addWidget(history_);
  column->addLayout(ends_);
  refresh();
}

void SessionList::makeHistory() {
  foundGroups_.setSourceModel(&groups_);
  foundGroups_.setFilterCaseSensitivity(Qt::CaseInsensitive);
  foundGroups_.setFilterRole(HistoryModel::NameRole);
  historyList_->setObjectName(QStringLiteral("session-history"));
  historyList_->setAccessibleName(tr("History"));
  historyList_->setModel(&foundGroups_);
  historyList_->hide();
  const auto openGroup = [this](const QModelIndex& index) {
    if (!index.isValid()) return;
    filter_->setText(index.data(HistoryModel::NameRole).toString());
    showHistory(false);
  };
  connect(historyList_, &QListView::clicked, this, openGroup);
  connect(historyList_, &QListView::activated, this, openGroup);
  history_ = toolButton(tr("HISTORY"), tr("Alarms by day, tool or job over all recordings"), "sessions-history");
  history_->setCheckable(true);
  connect(history_, &TouchButton::clicked, this, [this] { showHistory(history_->isChecked()); });
}

void SessionList::orderBy(SessionOrder::By by) {
  by_ = by;
  order_.orderBy(by);
  refreshHistory();
  byJob_->setChecked(by == SessionOrder::Job);
  byTool_->setChecked(by == SessionOrder::Tool);
  byTime_->setChecked(by == SessionOrder::Time);
  lookInsideShown();
}

// Files are opened for nobody: only what is inside the rows on the screen is asked for.
void SessionList::lookInsideShown() {
  if (controller_ == nullptr || !isVisible() || simulated_->isChecked()) return;
  QStringList paths;
  if (history_->isChecked()) {  // which is of all of them
    for (const SessionEntry& entry : controller_->entries()) paths.append(entry.path);
    return controller_->lookInside(paths);
  }
  (void)list_->indexAt({});  // lays the rows out where that waits
  const QRect seen = list_->viewport()->rect();
  for (int k = 0; k < order_.rowCount(); ++k) {
    const QModelIndex row = order_.index(k, 0);
    const QRect place = list_->visualRect(row);
    if (place.top() > seen.bottom()) break;
    if (place.bottom() >= seen.top()) paths.append(row.data(SessionListModel::PathRole).toString());
  }
  controller_->lookInside(paths);
}

void SessionList::showHistory(bool history) {
  history_->setChecked(history);
  historyList_->setVisible(history);
  list_->setVisible(!history);
  if (history && simulated_->isChecked()) return showSimulated(false);
  refreshHistory();
  sayWhatIsMissing();
  lookInsideShown();
}

void SessionList::refreshHistory() {
  if (controller_ != nullptr && history_->isChecked()) groups_.show(historyOf(controller_->entries(), by_));
}

void SessionList::showSimulated(bool simulated) {
  if (simulated && history_->isChecked()) showHistory(false);
  recorded_->setChecked(!simulated);
  simulated_->setChecked(simulated);
  refresh();
}

void SessionList::refresh() {
  if (controller_ != nullptr) {
    sessions_.show(simulated_->isChecked() ? controller_->scenarios() : controller_->entries());
    if (!folder_->hasFocus()) folder_->setText(controller_->folder());
  }
  refreshHistory();
  sayWhatIsMissing();
  lookInsideShown();
}

void SessionList::sayWhatIsMissing() {
  if (controller_ == nullptr) {
    empty_->setText(tr("There are no recordings to work on here."));
  } else if (sessions_.rowCount() == 0) {
    empty_->setText(tr("No recordings here. Cuts are recorded as the page SET UP, RECORDING says."));
  } else if (history_->isChecked()) {
    const auto& entries = controller_->entries();
    const auto counted = [&](SessionEntry::Inside inside) {
      return std::ranges::count(entries, inside, &SessionEntry::inside);
    };
    const auto open = std::ranges::count_if(
        entries, [](const SessionEntry& entry) { return entry.session && entry.inside == SessionEntry::Inside::No; });
    const auto reading = counted(SessionEntry::Inside::NotYet), without = counted(SessionEntry::Inside::No) - open;
    QStringList words;
    if (reading > 0) words << tr("recordings still to be read: %1").arg(reading);
    if (open > 0) words << tr("not closed, still written or cut off, so not counted: %1").arg(open);
    if (without > 0) words << tr("without alarms of their own, not counted: %1").arg(without);
    empty_->setText(words.join(u'\n'));
  } else {
    empty_->setText(order_.rowCount() == 0 ? tr("No recording has this in its job, tool or date.") : QString());
  }
  empty_->setVisible(!empty_->text().isEmpty());
}

void SessionList::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  lookInsideShown();
}

void SessionList::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (controller_ != nullptr) controller_->setFolder(controller_->folder());
}

void SessionList::applyTheme(const Theme& theme) {
  layout()->setSpacing(theme.px(10));
  for (QHBoxLayout* line : {kinds_, orders_, ends_})
    line->setSpacing(std::max(theme.px(12), pixelsFor(kTouchGapMm, this)));
  for (QListView* list : {list_, historyList_}) list->setFont(theme.font(type_size::kBody));
  for (QLineEdit* edit : {filter_, folder_}) {
    edit->setFont(theme.font(type_size::kBody));
    edit->setFixedHeight(touchHeight(theme, this, 48));
  }
}

}  // namespace stillcut::ui
