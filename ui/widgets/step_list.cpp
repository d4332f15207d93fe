#include "ui/widgets/step_list.h"

#include <QVBoxLayout>

#include "ui/widgets/text_label.h"

namespace stillcut::ui {

StepList::StepList(QWidget* parent)
    : QWidget(parent), theme_(makeTheme(ThemeKind::Light, 1.0)), column_(new QVBoxLayout(this)) {
  column_->setContentsMargins(0, 0, 0, 0);
}

void StepList::display(const std::vector<StepLine>& lines) {
  while (labels_.size() < lines.size()) {
    labels_.push_back(new TextLabel({type_size::kBody, false, false, true}));
    labels_.back()->applyTheme(theme_);
    column_->addWidget(labels_.back());
  }
  for (std::size_t k = 0; k < labels_.size(); ++k) {
    const bool used = k < lines.size();
    labels_[k]->setVisible(used);
    if (!used) continue;
    labels_[k]->setTone(lines[k].tone);
    labels_[k]->setText(lines[k].text);
  }
}

void StepList::applyTheme(const Theme& theme) {
  theme_ = theme;
  column_->setSpacing(theme.px(4));
}

}  // namespace stillcut::ui
