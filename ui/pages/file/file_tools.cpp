#include "ui/pages/file/file_tools.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <algorithm>

#include "ui/base/format.h"
#include "ui/widgets/painting.h"
#include "ui/widgets/touch_button.h"

namespace stillcut::ui {
namespace {

constexpr std::array<int, 8> kLengths{256, 512, 1024, 2048, 4096, 8192, 16384, 32768};
constexpr std::array<double, 4> kOverlaps{0.0, 0.5, 0.75, 0.9};
constexpr std::array<SpectraWindow, 3> kWindows{SpectraWindow::Hann, SpectraWindow::FlatTop,
                                                SpectraWindow::Rectangular};

template <class Values, class Value>
int placeOf(const Values& values, const Value& value) {
  const auto found = std::find(values.begin(), values.end(), value);
  return found == values.end() ? 0 : static_cast<int>(found - values.begin());
}

template <class Values>
auto valueAt(const Values& values, int place) {
  return values[static_cast<std::size_t>(std::clamp<int>(place, 0, static_cast<int>(values.size()) - 1))];
}

}  // namespace

FileTools::FileTools(QWidget* parent) : QWidget(parent), row_(new QHBoxLayout(this)) {
  row_->setContentsMargins(0, 0, 0, 0);
  QStringList lengths, overlaps;
  for (const int length : kLengths) lengths << number(length);
  for (const double overlap : kOverlaps) overlaps << percent(overlap);
  channel_ = addChoice("file-channel", tr("Channel"), {});
  length_ = addChoice("file-length", tr("Samples of one spectrum"), lengths);
  window_ = addChoice("file-window", tr("Window of the spectra"), {tr("Hann"), tr("Flat top"), tr("Rectangular")});
  overlap_ = addChoice("file-overlap", tr("Overlap of the spectra"), overlaps);
  log_ = addToggle("file-log", tr("LOG"), tr("Logarithmic axis of frequency"), Qt::Key_L, &FileLook::log);
  order_ =
      addToggle("file-order", tr("ORDERS"), tr("Frequencies as orders of the spindle"), Qt::Key_X, &FileLook::order);
  row_->addStretch(1);
  showLook();
}

QComboBox* FileTools::addChoice(const char* name, const QString& spoken, const QStringList& items) {
  auto* choice = new QComboBox;
  choice->setObjectName(QLatin1String(name));
  choice->setAccessibleName(spoken);
  choice->setToolTip(spoken);
  choice->addItems(items);
  row_->addWidget(choice);
  connect(choice, &QComboBox::activated, this, &FileTools::take);
  return choice;
}

TouchButton* FileTools::addToggle(const char* name, const QString& caption, const QString& spoken, Qt::Key key,
                                  bool FileLook::*value) {
  auto* button = new TouchButton(caption, TouchButton::Look::Plain, this);
  button->setObjectName(QLatin1String(name));
  button->setAccessibleName(spoken);
  button->setKey(key);
  button->setCheckable(true);
  button->setBaseHeight(48);
  row_->addWidget(button);
  connect(button, &TouchButton::clicked, this, [this, value] {
    look_.*value = !(look_.*value);
    showLook();
    emit changed();
  });
  return button;
}

void FileTools::take() {
  look_.channel = std::max(channel_->currentIndex(), 0);
  look_.length = valueAt(kLengths, length_->currentIndex());
  look_.window = valueAt(kWindows, window_->currentIndex());
  look_.overlap = valueAt(kOverlaps, overlap_->currentIndex());
  emit changed();
}

void FileTools::setLook(const FileLook& look) {
  look_ = look;
  showLook();
}

void FileTools::setChannels(const QStringList& names) {
  QStringList present;
  for (int k = 0; k < channel_->count(); ++k) present << channel_->itemText(k);
  if (present == names) return;
  channel_->clear();
  channel_->addItems(names);
  channel_->setEnabled(names.size() > 1);
  look_.channel = std::clamp(look_.channel, 0, std::max(static_cast<int>(names.size()) - 1, 0));
  showLook();
}

void FileTools::showLook() {
  channel_->setCurrentIndex(std::min(look_.channel, channel_->count() - 1));
  length_->setCurrentIndex(placeOf(kLengths, look_.length));
  window_->setCurrentIndex(placeOf(kWindows, look_.window));
  overlap_->setCurrentIndex(placeOf(kOverlaps, look_.overlap));
  log_->setChecked(look_.log);
  order_->setChecked(look_.order);
}

void FileTools::applyTheme(const Theme& theme) {
  row_->setSpacing(std::max(theme.px(10), pixelsFor(kTouchGapMm, this)));
  for (QComboBox* choice : {channel_, length_, window_, overlap_}) {
    choice->setFont(theme.font(type_size::kBody));
    choice->setMinimumHeight(std::max(theme.px(48), pixelsFor(kTouchMm, this)));
    choice->setMinimumWidth(theme.px(choice == channel_ ? 140 : 86));
  }
}

}  // namespace stillcut::ui
