#include "ui/pages/mark_sheet.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QListView>
#include <algorithm>
#include <utility>

#include "ui/pages/tool_button.h"
#include "ui/widgets/painting.h"

namespace stillcut::ui {
MarkSheet::MarkSheet(SessionController* controller, QWidget* parent)
    : QWidget(parent),
      controller_(controller),
      list_(new QListView),
      label_(makeEdit(tr("Label"), tr("Label of the span"), "mark-label")),
      note_(makeEdit(tr("Note"), tr("Note of the next marker"), "mark-text")),
      span_(toolButton(tr("SPAN"), tr("Mark the selected span with the label"), "mark-span")),
      change_(toolButton(tr("CHANGE"), tr("Give the chosen marker this label and note"), "mark-change")),
      remove_(toolButton(tr("REMOVE"), tr("Remove the chosen marker"), "mark-remove")) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  lines_ = {new QHBoxLayout, new QHBoxLayout};
  struct Button {
    QString caption, spoken;
    const char* name;
    const char* label;
    QKeySequence key;
  };
  const Button buttons[] = {
      {tr("CHATTER"), tr("Mark a true alarm"), "mark-true", kLabelTrueAlarm, Qt::ALT | Qt::Key_1},
      {tr("FALSE"), tr("Mark a false alarm"), "mark-false", kLabelFalseAlarm, Qt::ALT | Qt::Key_2},
      {tr("MISSED CHATTER"), tr("I hear it now"), "mark-heard", kLabelOperatorChatter, Qt::ALT | Qt::Key_3},
      {tr("NOTE"), tr("Mark with the note"), "mark-note", kLabelNote, Qt::ALT | Qt::Key_4}};
  for (const Button& b : buttons) {
    TouchButton* button = toolButton(b.caption, b.spoken, b.name);
    button->setKey(b.key);
    lines_[0]->addWidget(button);
    touches_.push_back(button);
    connect(button, &TouchButton::clicked, this, [this, label = b.label] { mark(QLatin1String(label)); });
  }
  lines_[0]->addStretch(1);
  lines_[0]->addWidget(remove_);
  lines_[1]->addWidget(label_, 1);
  lines_[1]->addWidget(note_, 2);
  lines_[1]->addWidget(span_);
  lines_[1]->addWidget(change_);
  for (QBoxLayout* line : lines_) column->addLayout(line);
  list_->setObjectName(QStringLiteral("marker-list"));
  list_->setAccessibleName(tr("Markers"));
  list_->setModel(&markers_);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  column->addWidget(list_, 1);
  connect(list_, &QListView::clicked, this, [this](const QModelIndex& index) { choose(index.row()); });
  connect(list_, &QListView::activated, this, [this](const QModelIndex& index) { choose(index.row()); });
  connect(list_->selectionModel(), &QItemSelectionModel::currentChanged, this,
          [this](const QModelIndex& index) { currentMoved(index.row()); });
  connect(span_, &TouchButton::clicked, this, &MarkSheet::markSpan);
  connect(label_, &QLineEdit::returnPressed, span_, &TouchButton::click);
  connect(change_, &TouchButton::clicked, this, &MarkSheet::change);
  connect(remove_, &TouchButton::clicked, this, &MarkSheet::remove);
}

QLineEdit* MarkSheet::makeEdit(const QString& shown, const QString& spoken, const char* name) {
  auto* edit = new QLineEdit;
  edit->setObjectName(QLatin1String(name));
  edit->setPlaceholderText(shown);
  edit->setAccessibleName(spoken);
  return edit;
}

const Marker* MarkSheet::current() const {
  return markers_.marker(list_->currentIndex().row());
}

// The note is the one that was typed for this marker, not what the list has shown of another.
void MarkSheet::mark(const QString& label) {
  if (controller_ == nullptr || !controller_->replay().open) return;
  const auto [from, to] = chosen();
  const Status done = controller_->mark(from, to, label, note_->isModified() ? note_->text() : QString());
  if (done) {
    list_->setCurrentIndex({});
    editNone();
  }
  emit told(done, tr("Marked: %1").arg(markerText(label.toStdString())));
}

void MarkSheet::markSpan() {
  const QString label = label_->text().trimmed();
  if (!label.isEmpty()) {
    mark(label);
  } else {
    emit told(Error{message("marker"), message("needs a label"), message("type one beside SPAN")}, {});
  }
}

// Only the marker whose words are in the fields.
void MarkSheet::change() {
  const Marker* marker = current();
  if (marker == nullptr || marker->number != edited_) return;
  const QString label = label_->text().trimmed();
  const Status done = controller_->changeMark(
      marker->number, label.isEmpty() ? QString::fromStdString(marker->label) : label, note_->text());
  if (done) {
    label_->setModified(false);
    note_->setModified(false);
  }
  emit told(done, tr("Marker changed"));
}

// The touch that has removed one brings it back, until another is chosen.
void MarkSheet::remove() {
  if (removed_) {
    const auto [begin, length, label, note] = *std::exchange(removed_, std::nullopt);
    emit told(controller_->mark(begin, begin + length, label, note), tr("Marker put back"));
    enable();
    return;
  }
  const Marker* marker = current();
  if (marker == nullptr) return;
  const Removed gone{controller_->markerTime(*marker), secondsBetween(marker->begin, marker->end),
                     QString::fromStdString(marker->label), QString::fromStdString(marker->note)};
  const Status done = controller_->removeMark(marker->number);
  if (done) removed_ = gone;
  emit told(done, tr("Marker removed"));
  enable();
}

void MarkSheet::edit(const Marker& marker) {
  edited_ = marker.number;
  label_->setText(QString::fromStdString(marker.label));
  note_->setText(QString::fromStdString(marker.note));
  enable();
}

void MarkSheet::editNone() {
  edited_.reset();
  label_->clear();
  note_->clear();
  enable();
}

// By the keys. What somebody has typed is not thrown away for it; it belongs to no marker until one is chosen.
void MarkSheet::currentMoved(int row) {
  const Marker* marker = markers_.marker(row);
  if (refreshing_ || marker == nullptr || marker->number == edited_) return;
  removed_.reset();
  if (label_->isModified() || note_->isModified()) {
    edited_.reset();
    enable();
  } else {
    edit(*marker);
  }
}

void MarkSheet::choose(int row) {
  const Marker* marker = markers_.marker(row);
  if (marker == nullptr) return;
  removed_.reset();
  edit(*marker);
  const Seconds begin = controller_->markerTime(*marker);
  emit wentTo(begin, begin + secondsBetween(marker->begin, marker->end));
}

void MarkSheet::refresh() {
  if (controller_ == nullptr) return;
  const bool another = std::exchange(path_, controller_->openedPath()) != controller_->openedPath();
  const Marker* before = current();
  const auto chosenNumber = before != nullptr && !another ? std::optional(before->number) : std::nullopt;
  refreshing_ = true;
  markers_.show(*controller_);
  for (int row = 0; row < markers_.rowCount(); ++row) {
    if (markers_.marker(row)->number == chosenNumber) list_->setCurrentIndex(markers_.index(row));
  }
  refreshing_ = false;
  const bool gone = edited_ && (current() == nullptr || current()->number != edited_);
  if (another) removed_.reset();
  if (another || gone) editNone();
  enable();
}

void MarkSheet::enable() {
  const auto summary = controller_ != nullptr ? controller_->summary() : nullptr;
  const bool open = summary != nullptr && summary->session;
  for (TouchButton* button : touches_) button->setEnabled(open);
  span_->setEnabled(open);
  remove_->setText(removed_ ? tr("UNDO") : tr("REMOVE"));
  remove_->setEnabled(open && (removed_ || current() != nullptr));
  change_->setEnabled(open && current() != nullptr && current()->number == edited_);
}

void MarkSheet::applyTheme(const Theme& theme) {
  const int apart = std::max(theme.px(12), pixelsFor(kTouchGapMm, this));
  layout()->setSpacing(apart);
  for (QBoxLayout* line : lines_) line->setSpacing(apart);
  list_->setFont(theme.font(type_size::kBody));
  for (QLineEdit* edit : {label_, note_}) {
    edit->setFont(theme.font(type_size::kBody));
    edit->setFixedHeight(touchHeight(theme, this, 48));
  }
}

}  // namespace stillcut::ui
