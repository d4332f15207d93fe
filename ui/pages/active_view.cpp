#include "ui/pages/active_view.h"

#include <QHBoxLayout>
#include <algorithm>
#include <utility>

#include "ui/base/say.h"
#include "ui/models/active_text.h"
#include "ui/plots/path_fit_plot.h"
#include "ui/widgets/painting.h"
#include "ui/widgets/text_label.h"
#include "ui/widgets/tool_button.h"

namespace stillcut::ui {

ActiveView::ActiveView(FindController controller, QWidget* parent)
    : QWidget(parent),
      controller_(std::move(controller)),
      actions_(new QHBoxLayout),
      axes_(new QHBoxLayout),
      identify_(
          makeToolButton(tr("IDENTIFY"), tr("Identify the paths, with the tool out of the cut"), "active-identify")),
      start_(makeToolButton(tr("START"), tr("Start active control"), "active-start")),
      stop_(makeToolButton(tr("STOP"), tr("Stop active control"), "active-stop")),
      device_(new TextLabel({type_size::kBody, false, true, true})),
      problem_(new TextLabel({type_size::kBody, true, false, true})),
      state_(new TextLabel({type_size::kValue, true, false, true})),
      earned_(new TextLabel({type_size::kBody, false, false, true})),
      model_(new TextLabel({type_size::kBody, false, false, true})),
      fit_(new PathFitPlot) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  for (TouchButton* b : {identify_, start_, stop_}) actions_->addWidget(b);
  actions_->addStretch(1);
  axisButtons_ = {makeToolButton(QStringLiteral("X"), tr("Axis x"), "active-x"),
                  makeToolButton(QStringLiteral("Y"), tr("Axis y"), "active-y")};
  for (int axis = 0; axis < kActiveAxes; ++axis) {
    TouchButton* b = axisButtons_[static_cast<std::size_t>(axis)];
    b->setCheckable(true);
    axes_->addWidget(b);
    connect(b, &TouchButton::clicked, this, [this, axis] { takeAxis(axis); });
  }
  axes_->addWidget(state_, 1);
  column->addWidget(device_);
  column->addLayout(actions_);
  column->addWidget(problem_);
  column->addLayout(axes_);
  for (TextLabel* label : {earned_, model_}) column->addWidget(label);
  column->addWidget(fit_);
  problem_->setTone(Tone::Onset);
  // Enabled only where there is a desk.
  connect(identify_, &TouchButton::clicked, this, [this] { tell(controller_()->identify()); });
  connect(start_, &TouchButton::clicked, this, [this] { tell(controller_()->start()); });
  connect(stop_, &TouchButton::clicked, this, [this] { controller_()->stop(); });
  takeAxis(0);
}

void ActiveView::takeAxis(int axis) {
  axis_ = axis;
  for (int k = 0; k < kActiveAxes; ++k) axisButtons_[static_cast<std::size_t>(k)]->setChecked(k == axis);
  display();
}

void ActiveView::tell(const Status& status) {
  refused_ = status ? QString() : sayError(status.error());
}

void ActiveView::display() {
  ActiveController* controller = controller_();
  for (TouchButton* b : {identify_, start_, stop_}) b->setEnabled(controller != nullptr);
  if (controller == nullptr) {
    device_->setText(tr("There is no active work-holder here."));
    for (TextLabel* label : {problem_, state_, earned_, model_}) label->clear();
    fit_->display(nullptr);
    return;
  }
  if (controller->problem() != problemSeen_) refused_.clear();  // older than the problem
  problemSeen_ = controller->problem();
  problem_->setText(refused_.isEmpty() ? problemSeen_ : refused_);
  problem_->setVisible(!problem_->text().isEmpty());
  fit_->display(controller->fit(axis_));
  const ActiveSnapshot* snapshot = controller->pull();
  if (snapshot == nullptr) {
    device_->setText(tr("%1: nothing yet").arg(controller->device()));
    return;
  }
  const ActiveAxisView view = makeActiveAxis(*snapshot, axis_);
  device_->setText(activeDeviceText(*snapshot, controller->device()));
  QStringList states;
  Tone worst = Tone::Normal;
  for (int axis = 0; axis < kActiveAxes; ++axis) {
    const ActiveAxisView one = makeActiveAxis(*snapshot, axis);
    states << QStringLiteral("%1: %2, %3").arg(axis == 0 ? QChar(u'x') : QChar(u'y')).arg(one.state, one.stroke);
    if (one.tone == Tone::Chatter || worst == Tone::Normal) worst = one.tone;
  }
  state_->setTone(worst);
  state_->setText(states.join(u'\n'));
  earned_->setText(view.lines.isEmpty()
                       ? tr("Nothing is known of its lines yet")
                       : tr("By the model, against the cut left alone: %1").arg(view.lines.join(QStringLiteral("; "))));
  model_->setTone(view.modelSound ? Tone::Normal : Tone::Onset);
  model_->setText(view.model);
}

void ActiveView::applyTheme(const Theme& theme) {
  layout()->setSpacing(theme.px(10));
  for (QHBoxLayout* line : {actions_, axes_}) line->setSpacing(std::max(theme.px(12), pixelsFor(kTouchGapMm, this)));
}

}  // namespace stillcut::ui
