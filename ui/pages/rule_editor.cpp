#include "ui/pages/rule_editor.h"

#include <QHBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/base/format.h"
#include "ui/plots/membership_plot.h"
#include "ui/widgets/painting.h"
#include "ui/widgets/text_label.h"
#include "ui/widgets/tool_button.h"

namespace stillcut::ui {
namespace {

constexpr double kStep = 0.5;      // of one touch
constexpr double kLearned = 0.05;  // less is not told

}  // namespace

RuleEditor::RuleEditor(TuningController& controller, QWidget* parent)
    : QWidget(parent),
      controller_(&controller),
      line_(new QHBoxLayout),
      speedTable_(makeToolButton(tr("SPEED"), tr("Rules of the speed"), "rules-speed")),
      feedTable_(makeToolButton(tr("FEED"), tr("Rules of the feed"), "rules-feed")),
      less_(makeToolButton(QStringLiteral("\u2212"), tr("Lower this rule"), "rule-less")),
      more_(makeToolButton(QStringLiteral("+"), tr("Raise this rule"), "rule-more")),
      grid_(new RuleGrid),
      sets_(new MembershipPlot),
      cell_(new TextLabel({type_size::kBody, true, false, true})),
      learned_(new TextLabel({type_size::kLabel, false, true, true})) {
  grid_->setObjectName(QStringLiteral("rules"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  speedTable_->setCheckable(true);
  feedTable_->setCheckable(true);
  for (TouchButton* b : {speedTable_, feedTable_, less_, more_}) line_->addWidget(b);
  line_->addStretch(1);
  column->addWidget(sets_);
  column->addLayout(line_);
  column->addWidget(cell_);
  column->addWidget(grid_, 0, Qt::AlignLeft);
  column->addWidget(learned_);
  connect(speedTable_, &TouchButton::clicked, this, [this] { takeTable(false); });
  connect(feedTable_, &TouchButton::clicked, this, [this] { takeTable(true); });
  connect(less_, &TouchButton::clicked, this, [this] { step(grid_->chosen(), -1); });
  connect(more_, &TouchButton::clicked, this, [this] { step(grid_->chosen(), 1); });
  connect(grid_, &RuleGrid::stepped, this, &RuleEditor::step);
  connect(grid_, &RuleGrid::chosenChanged, this, [this](int cell) { cell_->setText(grid_->cellText(cell)); });
  connect(grid_, &RuleGrid::reset, this, [this](int cell) {
    const config::ParamDecl& decl = *decls()[static_cast<std::size_t>(cell)];
    controller_->set(decl, decl.fallback);
    controller_->settle();
  });
  hide();
}

void RuleEditor::show(const TunableComponent* part) {
  part_ = part != nullptr && !part->speedRules.empty() ? part : nullptr;
  hasNow_ = false;
  setVisible(part_ != nullptr);
  if (part_ != nullptr) takeTable(feed_);
}

const std::vector<const config::ParamDecl*>& RuleEditor::decls() const {
  return feed_ ? part_->feedRules : part_->speedRules;
}

void RuleEditor::takeTable(bool feed) {
  feed_ = feed;
  speedTable_->setChecked(!feed);
  feedTable_->setChecked(feed);
  refresh(nullptr);
}

void RuleEditor::step(int cell, int direction) {
  if (part_ == nullptr) return;
  const config::ParamDecl& decl = *decls()[static_cast<std::size_t>(cell)];
  controller_->set(decl, std::clamp(controller_->value(decl) + direction * kStep, decl.lowest, decl.highest));
  controller_->settle();
}

void RuleEditor::refresh(const RuleTables* told) {
  if (part_ == nullptr) return;
  if (told != nullptr) now_ = *told;
  hasNow_ = hasNow_ || told != nullptr;
  RuleGrid::Cells cells;
  int learned = 0;
  double most = 0.0;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const config::ParamDecl& decl = *decls()[k];
    const std::size_t row = k / kRuleSets, column = k % kRuleSets;
    const double rule = controller_->value(decl);
    const double now = !hasNow_ || now_.lessons == 0 ? rule : feed_ ? now_.feed[row][column] : now_.speed[row][column];
    cells[k] = {rule, now, rule != decl.fallback};
    if (std::abs(now - rule) < kLearned) continue;
    ++learned;
    if (std::abs(now - rule) > std::abs(most)) most = now - rule;
  }
  grid_->display(cells);
  cell_->setText(grid_->cellText(grid_->chosen()));
  std::array<double, 3> centres{};
  for (std::size_t k = 0; k < centres.size(); ++k) centres[k] = controller_->value(*part_->setCentres[k]);
  sets_->display(centres);
  learned_->setVisible(hasNow_);
  learned_->setText(now_.refused ? tr("These values cannot be used together: rules must fall as coherence rises, and "
                                      "the energy limit must be above its reference. Those before them still act")
                    : now_.lessons == 0 ? tr("Nothing has been learned")
                    : learned == 0
                        ? tr("Lessons: %1. No rule of this table has moved").arg(now_.lessons)
                        : tr("Lessons: %1. Rules of this table that moved: %2, the furthest by %3")
                              .arg(QString::number(now_.lessons), QString::number(learned), number(most, 1)));
}

void RuleEditor::applyTheme(const Theme& theme) {
  layout()->setSpacing(theme.px(10));
  line_->setSpacing(std::max(theme.px(12), pixelsFor(kTouchGapMm, this)));
}

}  // namespace stillcut::ui
