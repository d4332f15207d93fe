#include "ui/pages/setup/setup_tools.h"

#include <QDate>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QListView>
#include <QPlainTextEdit>
#include <QScrollArea>
#include <QTextDocument>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/base/format.h"
#include "ui/base/say.h"
#include "ui/base/typed_number.h"
#include "ui/widgets/text_label.h"
#include "ui/widgets/touch_button.h"
#include "ui/widgets/wrapped_list.h"

namespace stillcut::ui {
namespace {

double numberIn(const QLineEdit* edit, double otherwise) {
  QString text = edit->text();
  text.replace(u',', u'.').remove(kThousandsSpace);
  bool isNumber = false;
  const double value = text.toDouble(&isNumber);
  return isNumber && std::isfinite(value) && value >= 0.0 ? value : otherwise;
}

// More fields than a low screen has rows for.
QScrollArea* scrolledFields(QGridLayout* fields) {
  auto* scroll = new QScrollArea;
  auto* box = new QWidget;
  box->setLayout(fields);
  fields->setContentsMargins(0, 0, 0, 0);
  scroll->setWidget(box);
  scroll->setWidgetResizable(true);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setMinimumWidth(box->minimumSizeHint().width());
  return scroll;
}

}  // namespace

SetupTools::SetupTools(SetupController& controller, SetupDraft& draft, QWidget* parent)
    : SetupTab(controller, draft, parent),
      list_(new QListView),
      name_(makeEdit(tr("Tool"), QStringLiteral("tool-name"))),
      holder_(makeEdit(tr("Holder and stick-out"), QStringLiteral("tool-holder"))),
      teeth_(makeEdit(tr("Flutes"), QStringLiteral("tool-teeth"))),
      diameter_(makeEdit(tr("Diameter"), QStringLiteral("tool-diameter"))),
      pitch_(makeEdit(tr("Pitch angles, degrees"), QStringLiteral("tool-pitch"))),
      modes_(makeEdit(tr("File of its modes"), QStringLiteral("tool-modes"))),
      material_(makeEdit(tr("Cuts"), QStringLiteral("tool-material"))),
      response_(makeEdit(tr("File of its response"), QStringLiteral("tool-response"))),
      stickOut_(makeEdit(tr("Stick-out"), QStringLiteral("tool-stick-out"))),
      deepest_(makeEdit(tr("Deepest cut"), QStringLiteral("tool-deepest"))),
      slowest_(makeEdit(tr("Lowest speed, rpm"), QStringLiteral("tool-slowest"))),
      limit_(makeEdit(tr("Highest speed, rpm"), QStringLiteral("tool-limit"))),
      notes_(new QPlainTextEdit),
      chattered_(new TextLabel({type_size::kBody, false, false, true})),
      note_(new TextLabel({type_size::kBody, false, false, true})),
      save_(makeButton(tr("KEEP"), tr("Keep this tool"), QStringLiteral("tool-save"))),
      use_(makeButton(tr("USE IT"), tr("Use this tool for the profile"), QStringLiteral("tool-use"))),
      remove_(makeButton(tr("REMOVE"), tr("Remove this tool"), QStringLiteral("tool-remove"))),
      putBack_(makeButton(tr("PUT IT BACK"), tr("Put the removed tool back"), QStringLiteral("tool-put-back"))),
      here_(makeButton(tr("CHATTERED HERE"), tr("Note that it chatters now"), QStringLiteral("tool-chattered"))) {
  auto* columns = new QHBoxLayout(this);
  auto* left = new QVBoxLayout;
  TouchButton* add = makeButton(tr("NEW TOOL"), tr("New tool"), QStringLiteral("tool-new"));
  list_->setModel(&tools_);
  list_->setObjectName(QStringLiteral("tools"));
  list_->setAccessibleName(tr("Tools"));
  showWrapped(*list_);
  list_->setResizeMode(QListView::Adjust);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  left->addWidget(list_, 1);
  left->addWidget(add);
  left->addWidget(putBack_);
  putBack_->hide();
  auto* right = new QVBoxLayout;
  auto* fields = new QGridLayout;
  int row = 0;
  fields_ = {name_,     holder_,   teeth_,    diameter_, pitch_,   modes_,
             material_, response_, stickOut_, deepest_,  slowest_, limit_};
  for (QLineEdit* edit : fields_) {
    constexpr int kBeside = 2;
    const int column = row % kBeside * 2;
    auto* label = new TextLabel(TextLabel::Look{type_size::kBody}, edit->accessibleName());
    if (edit == diameter_ || edit == stickOut_ || edit == deepest_)
      lengths_.push_back({edit, label, edit->accessibleName()});
    fields->addWidget(label, row / kBeside, column);
    fields->addWidget(edit, row / kBeside, column + 1);
    ++row;
  }
  pitch_->setPlaceholderText(tr("even"));
  modes_->setPlaceholderText(tr("not measured"));
  material_->setPlaceholderText(QStringLiteral("7075-T6, 1045 \u2026"));
  response_->setPlaceholderText(tr("none"));
  for (QLineEdit* edit : {slowest_, limit_, deepest_}) edit->setPlaceholderText(tr("no limit"));
  notes_->setObjectName(QStringLiteral("tool-notes"));
  notes_->setAccessibleName(tr("Notes"));
  notes_->setPlaceholderText(tr("Notes"));
  notes_->setTabChangesFocus(true);
  auto* buttons = new QHBoxLayout;
  for (TouchButton* button : {save_, use_, here_, remove_}) buttons->addWidget(button);
  buttons->addStretch(1);
  right->addWidget(scrolledFields(fields), 2);
  right->addWidget(notes_, 1);
  right->addWidget(chattered_);
  right->addWidget(note_);
  right->addLayout(buttons);
  columns->addLayout(left, 32);
  columns->addLayout(right, 68);

  connect(list_->selectionModel(), &QItemSelectionModel::currentChanged, this,
          [this](const QModelIndex& index, const QModelIndex& before) {
            if (edited() && tools_.tool(before.row()) != nullptr) typed_[before.row()] = typedOver(before.row());
            showTool(index.row());
          });
  connect(add, &TouchButton::clicked, this, [this] {
    ToolEntry tool;
    tool.name = tr("New tool");
    list_->setCurrentIndex(tools_.index(tools_.add(tool)));
    name_->setFocus();
    name_->selectAll();
  });
  connect(save_, &TouchButton::clicked, this, [this] {
    if (!fits()) return;
    take(typed());
    keep(tr("Kept"));
  });
  connect(use_, &TouchButton::clicked, this, [this] {
    if (!fits()) return;
    ToolEntry tool = typed();
    take(tool);
    if (!tool.modes.isEmpty()) {
      const auto cut = controller_.cutFile(tool);
      if (!cut) return void(refuse(tr("Not used: %1").arg(sayError(cut.error()))));
      tool.modes = *cut;
    }
    draft_.useTool(tool);
    keep(tr("The profile uses it now"));
  });
  connect(remove_, &TouchButton::clicked, this, [this] {
    const int chosen = list_->currentIndex().row();
    showTool(chosen);  // what was typed of it goes with it
    removed_ = {chosen, *tools_.tool(chosen)};
    tools_.remove(chosen);
    moveTyped(chosen, -1);
    putBack_->show();
    keep(tr("Removed"));
  });
  connect(putBack_, &TouchButton::clicked, this, [this] {
    moveTyped(removed_.first, 1);
    tools_.insert(removed_.first, removed_.second);
    list_->setCurrentIndex(tools_.index(removed_.first));
    putBack_->hide();
    keep(tr("It is back"));
  });
  connect(here_, &TouchButton::clicked, this, &SetupTools::noteChatter);
  if (auto known = controller_.tools(); known) {
    tools_.show(std::move(known).value());
  } else {
    note_->setTone(Tone::Onset);
    note_->setText(sayError(known.error()));
  }
  list_->setCurrentIndex(tools_.index(0));
  showUnits();
}

void SetupTools::refresh() {
  // A tap test may have changed them; what is typed here and not kept goes before it.
  if (auto known = controller_.tools(); known && typed_.empty() && !edited() && *known != tools_.tools()) {
    const int row = list_->currentIndex().row();
    tools_.show(std::move(known).value());
    list_->setCurrentIndex(tools_.index(std::max(row, 0)));
  }
  if (tools_.units() != draft_.units()) showUnits();
}

void SetupTools::showUnits() {
  tools_.setUnits(draft_.units());
  for (const Length& length : lengths_) {
    const QString label = QStringLiteral("%1, %2").arg(length.name, lengthUnit(draft_.units()));
    length.label->setText(label);
    length.edit->setAccessibleName(label);
  }
  showTool(list_->currentIndex().row());
}

bool SetupTools::edited() const {
  return notes_->document()->isModified() ||
         std::any_of(fields_.begin(), fields_.end(), [](const QLineEdit* edit) { return edit->isModified(); });
}

void SetupTools::take(ToolEntry tool) {
  const int row = list_->currentIndex().row();
  const ToolEntry* before = tools_.tool(row);
  const auto note = [&](const QString& now, const QString& then, const QString& what) {
    if (now == then || now.isEmpty()) return;
    tool.history.push_back({QDate::currentDate().toString(Qt::ISODate), what.arg(now)});
  };
  if (before != nullptr) {
    note(tool.modes, before->modes, tr("modes: %1"));
    note(tool.response, before->response, tr("response: %1"));
  }
  tools_.put(row, tool);
  typed_.erase(row);
}

// The rows from `from` on have moved.
void SetupTools::moveTyped(int from, int by) {
  std::map<int, ToolEntry> moved;
  for (auto& [row, tool] : typed_) {
    if (by < 0 && row == from) continue;
    moved[row >= from ? row + by : row] = std::move(tool);
  }
  typed_ = std::move(moved);
}

ToolEntry SetupTools::typed() const {
  return typedOver(list_->currentIndex().row());
}

ToolEntry SetupTools::typedOver(int row) const {
  const ToolEntry* before = tools_.tool(row);
  ToolEntry tool = before != nullptr ? *before : ToolEntry();
  const UnitSystem units = tools_.units();
  tool.name = name_->text().trimmed().isEmpty() ? tool.name : name_->text().trimmed();
  tool.holder = holder_->text().trimmed();
  tool.teeth = std::clamp(static_cast<int>(numberIn(teeth_, tool.teeth)), 1, 64);
  if (diameter_->isModified()) {  // what is shown is rounded
    const Metres typed = lengthFrom(numberIn(diameter_, lengthIn(Metres(tool.diameter_mm * 1e-3), units)), units);
    tool.diameter_mm = std::clamp(1e3 * typed.value, 0.05, 1000.0);
  }
  tool.pitch = pitch_->text().trimmed();
  // What is shown is rounded: only what was typed is taken.
  const auto length = [units](const QLineEdit* edit, double kept, double most) {
    if (!edit->isModified()) return kept;
    return std::min(1e3 * lengthFrom(numberIn(edit, 0.0), units).value, most);
  };
  tool.stickOut_mm = length(stickOut_, tool.stickOut_mm, 2000.0);
  tool.deepest_mm = length(deepest_, tool.deepest_mm, 1000.0);
  tool.modes = modes_->text().trimmed();
  tool.material = material_->text().trimmed();
  tool.response = response_->text().trimmed();
  const auto speed = [](const QLineEdit* edit, double kept) {
    bool isNumber = false;
    const double typed = typedSpeed(edit->text(), &isNumber);
    if (!isNumber || typed < 0.0) return edit->text().trimmed().isEmpty() ? 0.0 : kept;
    return std::min(typed, 200000.0);
  };
  tool.lowestSpeed_rpm = speed(slowest_, tool.lowestSpeed_rpm);
  tool.highestSpeed_rpm = speed(limit_, tool.highestSpeed_rpm);
  tool.notes = notes_->toPlainText();
  return tool;
}

bool SetupTools::refuse(const QString& why) {
  note_->setTone(Tone::Onset);
  note_->setText(why);
  return false;
}

bool SetupTools::fits() {
  const ToolEntry tool = typed();
  if (!pitchAngles(tool)) {
    return refuse(tr("Not kept: the pitch needs one angle per tooth, 360 degrees together"));
  }
  if (tool.lowestSpeed_rpm > 0.0 && tool.highestSpeed_rpm > 0.0 && tool.lowestSpeed_rpm >= tool.highestSpeed_rpm) {
    return refuse(tr("Not kept: the lowest speed lies above the highest"));
  }
  const std::pair<QString, SetupController::ToolFile> files[] = {{tool.modes, SetupController::ToolFile::Modes},
                                                                 {tool.response, SetupController::ToolFile::Response}};
  for (const auto& [file, kind] : files) {
    if (file.isEmpty()) continue;
    if (const Status usable = controller_.checkToolFile(file, kind); !usable) {
      return refuse(tr("Not kept: %1").arg(sayError(usable.error())));
    }
  }
  return true;
}

void SetupTools::showTool(int row) {
  const ToolEntry* tool = tools_.tool(row);
  for (QLineEdit* edit : fields_) edit->setEnabled(tool != nullptr);
  notes_->setEnabled(tool != nullptr);
  for (TouchButton* button : {save_, use_, remove_}) button->setEnabled(tool != nullptr);
  here_->setEnabled(tool != nullptr && alarming_);
  const auto unkept = typed_.find(row);
  const ToolEntry shown = unkept != typed_.end() ? unkept->second : tool != nullptr ? *tool : ToolEntry();
  name_->setText(shown.name);
  holder_->setText(shown.holder);
  teeth_->setText(tool != nullptr ? QString::number(shown.teeth) : QString());
  diameter_->setText(tool != nullptr
                         ? QString::number(lengthIn(Metres(shown.diameter_mm * 1e-3), tools_.units()), 'g', 5)
                         : QString());
  pitch_->setText(shown.pitch);
  modes_->setText(shown.modes);
  material_->setText(shown.material);
  response_->setText(shown.response);
  const auto length = [this](double mm) {
    return mm > 0.0 ? QString::number(lengthIn(Metres(mm * 1e-3), tools_.units()), 'g', 5) : QString();
  };
  stickOut_->setText(length(shown.stickOut_mm));
  deepest_->setText(length(shown.deepest_mm));
  slowest_->setText(shown.lowestSpeed_rpm > 0.0 ? QString::number(shown.lowestSpeed_rpm, 'f', 0) : QString());
  limit_->setText(shown.highestSpeed_rpm > 0.0 ? QString::number(shown.highestSpeed_rpm, 'f', 0) : QString());
  for (QLineEdit* edit : {name_, holder_, pitch_, modes_, response_})
    edit->setCursorPosition(0);  // what is too long shows its head
  notes_->setPlainText(shown.notes);
  QStringList lines;
  for (const ChatterNote& c : shown.chattered) {
    lines.push_back(tr("Chattered at %1 rpm, %2 Hz  %3").arg(number(c.speed_rpm), number(c.frequency_hz), c.note));
  }
  constexpr std::size_t kLatest = 3;
  for (std::size_t k = shown.history.size() - std::min(kLatest, shown.history.size()); k < shown.history.size(); ++k) {
    lines.push_back(QStringLiteral("%1  %2").arg(shown.history[k].day, shown.history[k].what));
  }
  chattered_->setText(lines.join(u'\n'));
  note_->setTone(Tone::Normal);
  note_->setText(tool == nullptr          ? tr("No tools yet: begin with NEW TOOL")
                 : unkept != typed_.end() ? tr("Not kept yet")
                                          : QString());
}

void SetupTools::keep(const QString& done) {
  const Status saved = controller_.saveTools(tools_.tools());
  showTool(list_->currentIndex().row());
  note_->setTone(saved ? Tone::Normal : Tone::Onset);
  if (!saved || !tools_.tools().empty()) note_->setText(saved ? done : sayError(saved.error()));
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
  take(tool);
  keep(tr("Noted"));
}

void SetupTools::applyTheme(const Theme& theme) {
  SetupTab::applyTheme(theme);
  list_->setFont(theme.font(type_size::kBody));
  notes_->setFont(theme.font(type_size::kBody));
}

}  // namespace stillcut::ui
