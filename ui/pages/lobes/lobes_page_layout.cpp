// What stands where on the Lobes page, and how large.
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QStackedWidget>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/base/format.h"
#include "ui/pages/lobes/cut_form.h"
#include "ui/pages/lobes_page.h"
#include "ui/plots/lobe_chart.h"
#include "ui/widgets/painting.h"
#include "ui/widgets/panel.h"
#include "ui/widgets/text_label.h"
#include "ui/widgets/tool_button.h"

namespace stillcut::ui {

// Longer than a screen: what stands where on the page, from top to bottom
void LobesPage::layOut() {
  auto* around = new Panel;
  auto* chartLayout = new QVBoxLayout(around);
  chartLayout->setContentsMargins(4, 4, 4, 4);
  if (entry_ != nullptr) chartLayout->addWidget(makeSources());
  places_->addWidget(chart_);
  if (entry_ != nullptr) {
    form_ = new CutForm(*entry_);
    form_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
    places_->addWidget(form_);
  }
  chartLayout->addWidget(places_, 1);
  learned_->setObjectName(QStringLiteral("learned"));
  learned_->setWordWrap(true);
  learned_->hide();
  chartLayout->addWidget(learned_);
  auto* column = new QVBoxLayout(side_);
  auto* methods = new QHBoxLayout;
  const std::array<QString, 3> names{QStringLiteral("method-zoa"), QStringLiteral("method-sdm"),
                                     QStringLiteral("method-exact")};
  for (std::size_t k = 0; k < methods_.size(); ++k) {
    methods_[k]->setObjectName(names[k]);
    methods_[k]->setCheckable(true);
    methods_[k]->setBaseHeight(50);
    methods->addWidget(methods_[k]);
  }
  column->addLayout(methods);
  auto* work = new QHBoxLayout;
  compute_->setObjectName(QStringLiteral("compute"));
  compute_->setBaseHeight(50);
  compute_->setKey(Qt::Key_F8);
  progress_->setRange(0, 100);
  progress_->setTextVisible(true);
  progress_->setAccessibleName(tr("Progress of the diagram"));
  work->addWidget(compute_);
  work->addWidget(progress_, 1);
  column->addLayout(work);
  state_->setWordWrap(true);
  column->addWidget(state_);

  auto* form = new QGridLayout;
  auto* speedLabel = new QLabel(tr("What if the speed were"));
  auto* depthLabel = new QLabel(tr("and the depth"));
  speed_->setObjectName(QStringLiteral("what-if-speed"));
  depth_->setObjectName(QStringLiteral("what-if-depth"));
  speed_->setAccessibleName(tr("Speed, what if"));
  depth_->setAccessibleName(tr("Depth, what if"));
  speedLabel->setBuddy(speed_);
  depthLabel->setBuddy(depth_);
  speed_->setSuffix(QChar(0xa0) + rpmUnit());
  speed_->setSingleStep(50);
  // Arrows are too small for a glove: the ring is dragged, or the arrow keys pressed.
  for (QDoubleSpinBox* box : {speed_, depth_}) box->setButtonSymbols(QAbstractSpinBox::NoButtons);
  form->addWidget(speedLabel, 0, 0);
  form->addWidget(depthLabel, 0, 1);
  form->addWidget(speed_, 1, 0);
  form->addWidget(depth_, 1, 1);
  for (int k = 0; k < 2; ++k) form->setColumnStretch(k, 1);
  column->addLayout(form);
  detail_->setWordWrap(true);
  verdict_->setObjectName(QStringLiteral("what-if"));
  column->addWidget(verdict_);
  column->addWidget(detail_);

  pockets_->setModel(table_);
  pockets_->setAccessibleName(tr("Stable speeds at this depth"));
  pockets_->setToolTip(tr("Choose a pocket to try its best speed"));
  pockets_->setSelectionBehavior(QAbstractItemView::SelectRows);
  pockets_->setSelectionMode(QAbstractItemView::SingleSelection);
  pockets_->verticalHeader()->hide();
  pockets_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  pockets_->horizontalHeader()->setSectionResizeMode(PocketTable::Speeds, QHeaderView::ResizeToContents);
  pockets_->setTabKeyNavigation(false);
  column->addWidget(pockets_, 1);
  note_->setWordWrap(true);
  note_->setObjectName(QStringLiteral("lobes-note"));
  column->addWidget(note_);
  grid_->addWidget(around, 0, 0);
  grid_->addWidget(side_, 0, 1);
  grid_->setColumnStretch(0, 62);
  grid_->setColumnStretch(1, 38);
}

// Whose lobes: of what runs, or of what is entered here.
QWidget* LobesPage::makeSources() {
  auto* bar = new QWidget;
  sources_ = new QHBoxLayout(bar);
  sources_->setContentsMargins(0, 0, 0, 0);
  runs_ = makeToolButton(tr("THE CUT THAT RUNS"), tr("Lobes of the cut that runs or is replayed"), "lobes-run");
  entered_ = makeToolButton(tr("YOUR OWN CUT"), tr("Enter a cut, or open a file with one"), "lobes-own");
  for (TouchButton* button : {runs_, entered_}) {
    button->setCheckable(true);
    sources_->addWidget(button);
  }
  sources_->addStretch(1);
  return bar;
}

void LobesPage::applyTheme(const Theme& theme) {
  const int margin = theme.px(16), gap = theme.px(10);
  const int touchGap = std::max(theme.px(12), pixelsFor(kTouchGapMm, this)),
            high = std::max(theme.px(50), pixelsFor(kTouchMm, this));
  grid_->setContentsMargins(margin, gap, margin, gap);
  grid_->setSpacing(gap);
  if (sources_ != nullptr) sources_->setSpacing(touchGap);
  side_->layout()->setContentsMargins(margin, margin, margin, margin);
  side_->layout()->setSpacing(touchGap);
  for (QLabel* label : side_->findChildren<QLabel*>()) {
    if (label != verdict_) label->setFont(theme.font(type_size::kBody));
  }
  for (QDoubleSpinBox* box : {speed_, depth_}) {
    box->setFont(theme.font(type_size::kValue));
    box->setMinimumHeight(high);
  }
  learned_->setFont(theme.font(type_size::kBody));
  progress_->setFont(theme.font(type_size::kBody));
  progress_->setMinimumHeight(high);
  pockets_->setFont(theme.font(type_size::kBody));
  pockets_->horizontalHeader()->setFont(theme.font(type_size::kLabel));
  pockets_->verticalHeader()->setDefaultSectionSize(high);
  showWhatIf();
}

}  // namespace stillcut::ui
