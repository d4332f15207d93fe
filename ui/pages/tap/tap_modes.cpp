#include "ui/pages/tap/tap_modes.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QTableView>

#include "ui/base/say.h"
#include "ui/models/tap/tap_text.h"
#include "ui/widgets/text_label.h"
#include "ui/widgets/tool_button.h"

namespace stillcut::ui {
namespace {

constexpr qsizetype kMostRemarks = 4;  // what does not fit is in the file and in the tool tip

}  // namespace

TapModes::TapModes(TapController& controller, QWidget* parent)
    : TapPart(controller, parent),
      table_(makeTable(modes_, tr("Modes"), QStringLiteral("tap-modes"))),
      sign_(new TextLabel({type_size::kValue, true, false, true})),
      remarks_(new TextLabel({type_size::kLabel, false, true, true})),
      said_(new TextLabel({type_size::kBody, false, false, true})),
      name_(makeEdit(tr("Name of the file of modes"), QStringLiteral("tap-name"))),
      keep_(makeToolButton(tr("KEEP"), tr("Keep the ticked modes of both axes in a file"), "tap-keep")) {
  auto* column = new QVBoxLayout(this);
  column->addWidget(sign_);
  column->addWidget(table_, 1);
  column->addWidget(remarks_);
  auto* line = new QHBoxLayout;
  line->addWidget(new TextLabel(TextLabel::Look{type_size::kBody}, tr("Keep as")));
  line->addWidget(name_, 1);
  line->addWidget(keep_);
  column->addLayout(line);
  column->addWidget(said_);
  name_->setPlaceholderText(QStringLiteral("tap"));
  said_->setObjectName(QStringLiteral("tap-kept"));
  said_->hide();
  connect(&modes_, &TickTable::tickAsked, this,
          [this](int row, bool ticked) { controller_.useMode(axis_, static_cast<std::size_t>(row), ticked); });
  connect(name_, &QLineEdit::textChanged, this, [this] { keep_->setAsking(false); });
  connect(keep_, &TouchButton::clicked, this, [this] {
    if (const QString there = controller_.keptAlready(TapKept::Modes, name_->text()); asksFirst(keep_, said_, there)) {
      return;
    }
    const auto kept = controller_.saveModes(name_->text());
    said_->setTone(kept ? Tone::Normal : Tone::Onset);
    said_->setText(kept ? tr("Kept; a tool takes it as the file of its modes: %1").arg(*kept) : sayError(kept.error()));
    said_->show();
  });
}

void TapModes::refresh(int axis, UnitSystem) {
  axis_ = axis;
  const TapResponse& response = controller_.response(axis);
  if (response.version == seen_ && seen_ != 0) return;
  seen_ = response.version;
  modes_.show(modeHeader(response.withForce), modeRows(response));
  QString text;
  switch (response.state) {
    case TapResponse::State::None:
      text = tr("Not measured along %1").arg(axis == 1 ? QStringLiteral("y") : QStringLiteral("x"));
      break;
    case TapResponse::State::Working:
      text = tr("Fitting the modes");
      break;
    case TapResponse::State::Failed:
      text = response.problem;
      break;
    case TapResponse::State::Done:
      text = response.withForce ? tr("A touch ticks a mode. Only ticked ones count.")
                                : tr("No force was measured: how stiff a mode is cannot be told.");
      break;
  }
  sign_->setTone(response.state == TapResponse::State::Failed ? Tone::Onset : Tone::Normal);
  sign_->setText(text);
  QStringList remarks = response.remarks;
  for (const TapMode& mode : response.modes) {
    if (!mode.doubt.isEmpty()) remarks << tr("%1 Hz: %2").arg(mode.frequency.value, 0, 'f', 0).arg(mode.doubt);
  }
  remarks_->setToolTip(remarks.join(u'\n'));
  remarks_->setText(remarks.mid(0, kMostRemarks).join(u'\n'));
  remarks_->setVisible(!remarks.isEmpty());
  keep_->setEnabled(response.withForce && !response.modes.empty());
}

}  // namespace stillcut::ui
