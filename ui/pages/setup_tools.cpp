#include "ui/pages/setup_tools.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QListView>
#include <QPlainTextEdit>
#include <algorithm>
#include <cmath>

#include "ui/models/format.h"
#include "ui/widgets/text_label.h"
#include "ui/widgets/touch_button.h"

namespace stillcut::ui {
namespace {

double numberIn(const QLineEdit* edit, double otherwise) {
  QString text = edit->text();
  text.replace(u',', u'.').remove(kThousandsSpace);
  bool isNumber = false;
  const double value = text.toDouble(&isNumber);
  return isNumber && std::isfinite(value) && value >= 0.0 ? value : otherwise;
}

}  // namespace

SetupTools::SetupTools(SetupDesk& desk, SetupDraft& draft, QWidget* parent)
    : SetupTab(desk, draft, parent),
      list_(new QListView),
      name_(makeEdit(tr("Tool"), QStringLiteral("tool-name"))),
      holder_(makeEdit(tr("Holder and stick-out"), QStringLiteral("tool-holder"))),
      teeth_(makeEdit(tr("Teeth"), QStringLiteral("tool-teeth"))),
      diameter_(makeEdit(tr("Diameter, mm"), QStringLiteral("tool-diameter"))),
      pitch_(makeEdit(tr("Pitch angles, degrees"), QStringLiteral("tool-pitch"))),
      modes_(makeEdit(tr("File of its modes"), QStringLiteral("tool-modes"))),
      limit_(makeEdit(tr("Highest speed, rpm"), QStringLiteral("tool-limit"))),
      notes_(new QPlainTextEdit),
      chattered_(new TextLabel({type_size::kBody, false, false, true})),
      note_(new TextLabel({type_size::kBody, false, false, true})),
      save_(makeButton(tr("KEEP"), tr("Keep this tool"), QStringLiteral("tool-save"))),
      use_(makeButton(tr("USE IT"), tr("Use this tool for the profile"), QStringLiteral("tool-use"))),
      remove_(makeButton(tr("REMOVE"), tr("Remove this tool"), QStringLiteral("tool-remove"))),
      here_(makeButton(tr("CHATTERED HERE"), tr("Note that it chatters now"), QStringLiteral("tool-chattered"))) {
  auto* columns = new QHBoxLayout(this);
  auto* left = new QVBoxLayout;
  TouchButton* add = makeButton(tr("NEW TOOL"), tr("New tool"), QStringLiteral("tool-new"));
  list_->setModel(&tools_);
  list_->setObjectName(QStringLiteral("tools"));
  list_->setAccessibleName(tr("Tools"));
  list_->setWordWrap(true);
  list_->setResizeMode(QListView::Adjust);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  left->addWidget(list_, 1);
  left->addWidget(add);
  auto* right = new QVBoxLayout;
  auto* fields = new QGridLayout;
  int row = 0;
  for (QLineEdit* edit : {name_, holder_, teeth_, diameter_, pitch_, modes_, limit_}) {
    const int column = row % 2 * 2;
    fields->addWidget(new TextLabel(TextLabel::Look{type_size::kBody}, edit->accessibleName()), row / 2, column);
    fields->addWidget(edit, row / 2, column + 1);
    ++row;
  }
  pitch_->setPlaceholderText(tr("even"));
  modes_->setPlaceholderText(tr("not measured"));
  limit_->setPlaceholderText(tr("no limit"));
  notes_->setObjectName(QStringLiteral("tool-notes"));
  notes_->setAccessibleName(tr("Notes"));
  notes_->setPlaceholderText(tr("Notes"));
  notes_->setTabChangesFocus(true);
  auto* buttons = new QHBoxLayout;
  for (TouchButton* button : {save_, use_, here_, remove_}) buttons->addWidget(button);
  buttons->addStretch(1);
  right->addLayout(fields);
  right->addWidget(notes_, 1);
  right->addWidget(chattered_);
  right->addWidget(note_);
  right->addLayout(buttons);
  columns->addLayout(left, 32);
  columns->addLayout(right, 68);

  connect(list_->selectionModel(), &QItemSelectionModel::currentChanged, this,
          [this](const QModelIndex& index) { showTool(index.row()); });
  connect(add, &TouchButton::clicked, this, [this] {
    ToolEntry tool;
    tool.name = tr("New tool");
    list_->setCurrentIndex(tools_.index(tools_.add(tool)));
    name_->setFocus();
    name_->selectAll();
  });
  connect(save_, &TouchButton::clicked, this, [this] {
    tools_.put(list_->currentIndex().row(), typed());
    keep(tr("Kept"));
  });
  connect(use_, &TouchButton::clicked, this, [this] {
    tools_.put(list_->currentIndex().row(), typed());
    draft_.useTool(typed());
    keep(tr("The profile uses it now"));
  });
  connect(remove_, &TouchButton::clicked, this, [this] {
    tools_.remove(list_->currentIndex().row());
    keep(tr("Removed"));
  });
  connect(here_, &TouchButton::clicked, this, &SetupTools::noteChatter);
  if (auto known = desk_.tools(); known) {
    tools_.show(std::move(known).value());
  } else {
    note_->setTone(Tone::Onset);
    note_->setText(QString::fromStdString(known.error().line()));
  }
  list_->setCurrentIndex(tools_.index(0));
  showTool(list_->currentIndex().row());
}

void SetupTools::refresh() {}

ToolEntry SetupTools::typed() const {
  const ToolEntry* before = tools_.tool(list_->currentIndex().row());
  ToolEntry tool = before != nullptr ? *before : ToolEntry();
  tool.name = name_->text().trimmed().isEmpty() ? tool.name : name_->text().trimmed();
  tool.holder = holder_->text().trimmed();
  tool.teeth = std::clamp(static_cast<int>(numberIn(teeth_, tool.teeth)), 1, 64);
  tool.diameter_mm = std::clamp(numberIn(diameter_, tool.diameter_mm), 0.05, 1000.0);
  tool.pitch = pitch_->text().trimmed();
  tool.modes = modes_->text().trimmed();
  tool.highestSpeed_rpm = std::min(numberIn(limit_, 0.0), 200000.0);
  tool.notes = notes_->toPlainText();
  return tool;
}

void SetupTools::showTool(int row) {
  const ToolEntry* tool = tools_.tool(row);
  for (QLineEdit* edit : {name_, holder_, teeth_, diameter_, pitch_, modes_, limit_}) edit->setEnabled(tool != nullptr);
  notes_->setEnabled(tool != nullptr);
  for (TouchButton* button : {save_, use_, remove_}) button->setEnabled(tool != nullptr);
  here_->setEnabled(tool != nullptr && alarming_);
  const ToolEntry shown = tool != nullptr ? *tool : ToolEntry();
  name_->setText(shown.name);
  holder_->setText(shown.holder);
  teeth_->setText(tool != nullptr ? QString::number(shown.teeth) : QString());
  diameter_->setText(tool != nullptr ? QString::number(shown.diameter_mm, 'g', 5) : QString());
  pitch_->setText(shown.pitch);
  modes_->setText(shown.modes);
  limit_->setText(shown.highestSpeed_rpm > 0.0 ? QString::number(shown.highestSpeed_rpm, 'f', 0) : QString());
  for (QLineEdit* edit : {name_, holder_, pitch_, modes_})
    edit->setCursorPosition(0);  // what is too long shows its head
  notes_->setPlainText(shown.notes);
  QStringList lines;
  for (const ChatterNote& c : shown.chattered) {
    lines.push_back(tr("Chattered at %1 rpm, %2 Hz  %3").arg(number(c.speed_rpm), number(c.frequency_hz), c.note));
  }
  chattered_->setText(lines.join(u'\n'));
  if (tool == nullptr) note_->setText(tr("No tools yet: begin with NEW TOOL"));
}

void SetupTools::keep(const QString& done) {
  const Status saved = desk_.saveTools(tools_.tools());
  note_->setTone(saved ? Tone::Normal : Tone::Onset);
  note_->setText(saved ? done : QString::fromStdString(saved.error().line()));
  const int row = list_->currentIndex().row();
  if (tools_.tool(row) != nullptr) showTool(row);
}

void SetupTools::display(const Picture& picture) {
  alarming_ = picture.snapshot != nullptr && !picture.stale && picture.verdict().alarming();
  if (alarming_) {
    now_.speed_rpm = std::round(picture.snapshot->machine.actualSpeed.value);
    now_.frequency_hz = std::round(picture.verdict().frequency.value);
  }
  here_->setEnabled(alarming_ && tools_.tool(list_->currentIndex().row()) != nullptr);
}

void SetupTools::noteChatter() {
  ToolEntry tool = typed();
  tool.chattered.push_back(now_);
  tools_.put(list_->currentIndex().row(), tool);
  keep(tr("Noted"));
}

void SetupTools::applyTheme(const Theme& theme) {
  SetupTab::applyTheme(theme);
  list_->setFont(theme.font(type_size::kBody));
  notes_->setFont(theme.font(type_size::kBody));
}

}  // namespace stillcut::ui
