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
      list_(new QListView) {
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
  orderBy(SessionOrder::Time);
  list_->setObjectName(QStringLiteral("session-list"));
  list_->setAccessibleName(tr("Recordings"));
  list_->setModel(&order_);
  showWrapped(*list_);
  list_->setResizeMode(QListView::Adjust);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
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
  column->addWidget(empty_);
  column->addWidget(folder_);
  refresh();
}

void SessionList::orderBy(SessionOrder::By by) {
  order_.orderBy(by);
  byJob_->setChecked(by == SessionOrder::Job);
  byTool_->setChecked(by == SessionOrder::Tool);
  byTime_->setChecked(by == SessionOrder::Time);
  lookInsideShown();
}

// Files are opened for nobody: only what is inside the rows on the screen is asked for.
void SessionList::lookInsideShown() {
  if (controller_ == nullptr || !isVisible() || simulated_->isChecked()) return;
  (void)list_->indexAt({});  // lays the rows out where that waits
  const QRect seen = list_->viewport()->rect();
  QStringList paths;
  for (int k = 0; k < order_.rowCount(); ++k) {
    const QModelIndex row = order_.index(k, 0);
    const QRect place = list_->visualRect(row);
    if (place.top() > seen.bottom()) break;
    if (place.bottom() >= seen.top()) paths.append(row.data(SessionListModel::PathRole).toString());
  }
  controller_->lookInside(paths);
}

void SessionList::showSimulated(bool simulated) {
  recorded_->setChecked(!simulated);
  simulated_->setChecked(simulated);
  refresh();
}

void SessionList::refresh() {
  if (controller_ != nullptr) {
    sessions_.show(simulated_->isChecked() ? controller_->scenarios() : controller_->entries());
    if (!folder_->hasFocus()) folder_->setText(controller_->folder());
  }
  empty_->setText(controller_ != nullptr
                      ? tr("No recordings here. Cuts are recorded as the page SET UP, RECORDING says.")
                      : tr("There are no recordings to work on here."));
  empty_->setVisible(sessions_.rowCount() == 0);
  lookInsideShown();
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
  for (QHBoxLayout* line : {kinds_, orders_}) line->setSpacing(std::max(theme.px(12), pixelsFor(kTouchGapMm, this)));
  list_->setFont(theme.font(type_size::kBody));
  for (QLineEdit* edit : {filter_, folder_}) {
    edit->setFont(theme.font(type_size::kBody));
    edit->setFixedHeight(touchHeight(theme, this, 48));
  }
}

}  // namespace stillcut::ui
