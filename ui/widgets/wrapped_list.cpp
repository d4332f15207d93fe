#include "ui/widgets/wrapped_list.h"

#include <QListView>
#include <QStyledItemDelegate>

namespace stillcut::ui {
namespace {

// resources/style/stillcut.qss: padding on both sides of an item, and the border of the one that is chosen.
constexpr int kBesideText = 2 * 10 + 4;

class WrappedRows : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    QStyleOptionViewItem narrower = option;
    narrower.rect.setWidth(option.rect.width() - kBesideText);
    return QStyledItemDelegate::sizeHint(narrower, index);
  }
};

}  // namespace

void showWrapped(QListView& list) {
  list.setWordWrap(true);
  list.setItemDelegate(new WrappedRows(&list));
}

int wrappedHeight(const QListView& list, int row) {
  const QModelIndex index = list.model()->index(row, 0);
  // What a style leaves beside a text, as QCommonStyle has it.
  const int margin = list.style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, &list) + 1;
  const QRect room(0, 0, list.visualRect(index).width() - kBesideText - 2 * margin, 10'000);
  const int flags = static_cast<int>(Qt::TextWordWrap) | static_cast<int>(Qt::AlignLeft);
  return list.fontMetrics().boundingRect(room, flags, index.data().toString()).height();
}

}  // namespace stillcut::ui
