#include "ui/pages/tap/tap_page.h"

#include <QDragEnterEvent>
#include <QDropEvent>
#include <QHBoxLayout>
#include <QMimeData>
#include <QSettings>
#include <QStackedWidget>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/facade/tap_controller.h"
#include "ui/pages/tap/tap_measure.h"
#include "ui/pages/tap/tap_modes.h"
#include "ui/pages/tap/tap_speeds.h"
#include "ui/plots/tap/frf_plot.h"
#include "ui/plots/tap/tap_lobe_plot.h"
#include "ui/widgets/painting.h"
#include "ui/widgets/text_label.h"
#include "ui/widgets/tool_button.h"

namespace stillcut::ui {
namespace {

QStringList filesOf(const QMimeData* data) {
  QStringList paths;
  for (const QUrl& url : data->urls()) {
    if (url.isLocalFile()) paths << url.toLocalFile();
  }
  return paths;
}

}  // namespace

TapPage::TapPage(TapController* controller, QWidget* parent) : Page(parent), controller_(controller) {
  auto* row = new QHBoxLayout(this);
  if (controller == nullptr) {
    row->addWidget(new TextLabel({type_size::kValue, false, true, true}, tr("There is nothing to measure with here.")));
    return;
  }
  setAcceptDrops(true);
  parts_ = new QStackedWidget;
  plots_ = new QStackedWidget;
  frf_ = new FrfPlot;
  lobes_ = new TapLobePlot;
  plots_->addWidget(frf_);
  plots_->addWidget(lobes_);
  each_ = {new TapMeasure(*controller), new TapModes(*controller), new TapSpeeds(*controller)};
  const struct {
    QString caption;
    const char* name;
  } names[] = {{tr("1 HIT"), "tap-measure"}, {tr("2 MODES"), "tap-find-modes"}, {tr("3 SPEED"), "tap-speeds"}};
  steps_ = new QHBoxLayout;
  for (std::size_t k = 0; k < each_.size(); ++k) {
    parts_->addWidget(each_[k]);
    auto* button = makeToolButton(names[k].caption, names[k].caption, QLatin1String(names[k].name));
    button->setCheckable(true);
    buttons_.push_back(button);
    steps_->addWidget(button);
    connect(button, &TouchButton::clicked, this, [this, k] { showPart(static_cast<int>(k)); });
    connect(each_[k], &TapPart::stateChanged, this, &Page::stateChanged);
  }
  steps_->addStretch(1);
  axes_ = {makeToolButton(QStringLiteral("X"), tr("Axis x, along the feed"), "tap-x"),
           makeToolButton(QStringLiteral("Y"), tr("Axis y"), "tap-y")};
  for (int axis = 0; axis < kTapAxes; ++axis) {
    TouchButton* button = axes_[static_cast<std::size_t>(axis)];
    button->setCheckable(true);
    steps_->addWidget(button);
    connect(button, &TouchButton::clicked, this, [this, axis] { showAxis(axis); });
  }
  auto* left = new QVBoxLayout;
  left->addLayout(steps_);
  left->addWidget(parts_, 1);
  row->addLayout(left, 46);
  row->addWidget(plots_, 54);
  showAxis(0);
  showPart(0);
}

void TapPage::showPart(int part) {
  parts_->setCurrentIndex(part);
  plots_->setCurrentIndex(part == 2 ? 1 : 0);
  for (std::size_t k = 0; k < buttons_.size(); ++k) buttons_[k]->setChecked(static_cast<int>(k) == part);
  refresh();
  emit stateChanged();
}

void TapPage::showAxis(int axis) {
  axis_ = axis;
  for (int k = 0; k < kTapAxes; ++k) axes_[static_cast<std::size_t>(k)]->setChecked(k == axis);
  refresh();
}

void TapPage::refresh() {
  if (controller_ == nullptr) return;
  each_[static_cast<std::size_t>(std::max(parts_->currentIndex(), 0))]->refresh(axis_, units_);
  frf_->display(controller_->response(axis_));
  lobes_->display(controller_->lobes(), units_);
}

// Samples come whether the page is on screen or not.
void TapPage::see(const Picture&) {
  if (controller_ != nullptr) controller_->poll();
}

void TapPage::display(const Picture& picture) {
  units_ = picture.units;
  refresh();
}

void TapPage::keep(QSettings& settings) const {
  for (const TapPart* part : each_) part->keep(settings);
}

void TapPage::restore(const QSettings& settings) {
  for (TapPart* part : each_) part->restore(settings);
}

void TapPage::dragEnterEvent(QDragEnterEvent* event) {
  if (!filesOf(event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void TapPage::dropEvent(QDropEvent* event) {
  const QStringList paths = filesOf(event->mimeData());
  if (paths.isEmpty()) return;
  event->acceptProposedAction();
  controller_->openFiles(paths, axis_);
  showPart(0);
}

void TapPage::applyTheme(const Theme& theme) {
  const int margin = theme.px(16), gap = theme.px(10);
  layout()->setContentsMargins(margin, gap, margin, gap);
  layout()->setSpacing(gap);
  if (steps_ != nullptr) steps_->setSpacing(std::max(theme.px(10), pixelsFor(kTouchGapMm, this)));
}

}  // namespace stillcut::ui
