#include "ui/pages/lobes/cut_form.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QSettings>
#include <QSignalBlocker>
#include <QTableWidget>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "ui/base/format.h"
#include "ui/base/say.h"
#include "ui/widgets/painting.h"
#include "ui/widgets/text_label.h"
#include "ui/widgets/tool_button.h"

namespace stillcut::ui {
namespace {

constexpr int kColumns = 5;         // of fields
constexpr double kPerMm2 = 1e6;     // N/m2 in N/mm2
constexpr double kPerMicron = 1e6;  // N/m in N/um
constexpr double kDegree = std::numbers::pi / 180.0;
constexpr int kMostModes = 12;

enum ModeColumn { Along, Frequency, Damping, Stiffness, kModeColumns };

QString alongText(const std::array<double, 2>& direction) {
  const bool x = direction[0] != 0.0, y = direction[1] != 0.0;
  return x && y ? QStringLiteral("x, y") : y ? QStringLiteral("y") : QStringLiteral("x");
}

double numberOf(const QTableWidget& table, int row, int column) {
  const QTableWidgetItem* item = table.item(row, column);
  return item != nullptr ? item->text().simplified().replace(u',', u'.').remove(u' ').toDouble() : 0.0;
}

}  // namespace

CutForm::CutForm(LobeEntryController& entry, QWidget* parent) : Panel(parent), entry_(entry), grid_(new QGridLayout) {
  auto* column = new QVBoxLayout(this);
  auto* head = new QHBoxLayout;
  file_ = new TextLabel({type_size::kBody, true, false, true});
  open_ = makeToolButton(tr("OPEN FILE"), tr("Take a cut, a scenario, a profile or modes from a file"), "cut-open");
  head->addWidget(file_, 1);
  head->addWidget(open_);
  column->addLayout(head);
  const QString rpm = QChar(0xa0) + rpmUnit(), force = QStringLiteral("\u00a0N/mm\u00b2");
  material_ = makeChoice(tr("Material"), "cut-material");
  tangential_ = makeNumber(tr("Cutting force, along"), "cut-tangential", 0, 0, 20'000, force);
  radial_ = makeNumber(tr("Cutting force, across"), "cut-radial", 0, 0, 20'000, force);
  side_ = makeChoice(tr("Milling direction"), "cut-side");
  teeth_ = makeNumber(tr("Flutes"), "cut-teeth", 0, 1, 200, {});
  diameter_ = makeNumber(tr("Diameter"), "cut-diameter", 2, 0, 0, {});
  helix_ = makeNumber(tr("Helix angle"), "cut-helix", 1, 0, 70, QStringLiteral("\u00b0"));
  width_ = makeNumber(tr("Width of cut"), "cut-width", 2, 0, 0, {});
  feed_ = makeNumber(tr("Feed per tooth"), "cut-feed", 3, 0, 0, {});
  depth_ = makeNumber(tr("Depth of cut"), "cut-depth", 2, 0, 0, {});
  deepest_ = makeNumber(tr("Deepest cut"), "cut-deepest", 2, 0, 0, {});
  lowest_ = makeNumber(tr("Lowest speed"), "cut-lowest", 0, 0, 200'000, rpm);
  highest_ = makeNumber(tr("Highest speed"), "cut-highest", 0, 0, 200'000, rpm);
  for (QDoubleSpinBox* box : {lowest_, highest_, tangential_, radial_}) box->setSpecialValueText(tr("not told"));
  feed_->setSpecialValueText(tr("not told"));
  for (int k = 0; k < kColumns; ++k) grid_->setColumnStretch(k, 1);
  column->addLayout(grid_);
  makeTable();
  column->addWidget(modes_, 1);
  said_ = new TextLabel({type_size::kBody, false, false, true});
  said_->setObjectName(QStringLiteral("cut-said"));
  said_->hide();
  column->addWidget(said_);
  auto* foot = new QHBoxLayout;
  add_ = makeToolButton(tr("ADD MODE"), tr("Add a row for a mode"), "cut-add-mode");
  remove_ = makeToolButton(tr("REMOVE MODE"), tr("Remove the chosen mode"), "cut-remove-mode");
  enter_ = new TouchButton(tr("SHOW LOBES"), TouchButton::Look::Advice);
  enter_->setObjectName(QStringLiteral("cut-enter"));
  enter_->setBaseHeight(48);
  foot->addWidget(add_);
  foot->addWidget(remove_);
  foot->addStretch(1);
  foot->addWidget(enter_);
  column->addLayout(foot);
  lines_ = {head, foot};
  side_->addItems({tr("climb"), tr("conventional")});
  fillMaterials();
  connect(open_, &TouchButton::clicked, this, &CutForm::browse);
  connect(add_, &TouchButton::clicked, this, &CutForm::addMode);
  connect(remove_, &TouchButton::clicked, this, &CutForm::removeMode);
  connect(enter_, &TouchButton::clicked, this, &CutForm::enter);
  connect(material_, &QComboBox::activated, this, &CutForm::takeMaterial);
  for (QDoubleSpinBox* box : {tangential_, radial_}) {
    connect(box, &QDoubleSpinBox::valueChanged, this, [this] { material_->setCurrentIndex(0); });
  }
  setLengthRanges();
  fill({});
}

QDoubleSpinBox* CutForm::makeNumber(const QString& label, const char* name, int decimals, double least, double most,
                                    const QString& suffix) {
  auto* box = new QDoubleSpinBox;
  box->setDecimals(decimals);
  box->setRange(least, most);
  box->setSuffix(suffix);
  box->setButtonSymbols(QAbstractSpinBox::NoButtons);  // too small for a glove
  box->setKeyboardTracking(false);
  box->setObjectName(QLatin1String(name));
  place(label, box);
  return box;
}

QComboBox* CutForm::makeChoice(const QString& label, const char* name) {
  auto* choice = new QComboBox;
  choice->setObjectName(QLatin1String(name));
  choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  choice->setMinimumContentsLength(6);
  place(label, choice);
  return choice;
}

void CutForm::place(const QString& label, QWidget* field) {
  field->setAccessibleName(label);
  const auto at = static_cast<int>(fields_.size());
  auto* shown = new TextLabel(TextLabel::Look{type_size::kLabel}, label);
  shown->setMinimumWidth(1);
  grid_->addWidget(shown, at / kColumns * 2, at % kColumns);
  grid_->addWidget(field, at / kColumns * 2 + 1, at % kColumns);
  fields_.push_back(field);
}

void CutForm::makeTable() {
  modes_ = new QTableWidget(0, kModeColumns);
  modes_->setObjectName(QStringLiteral("cut-modes"));
  modes_->setAccessibleName(tr("Modes of tool and holder at the tip"));
  modes_->setHorizontalHeaderLabels({tr("along"), tr("frequency, Hz"), tr("damping, %"), tr("stiffness, N/\u00b5m")});
  modes_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  modes_->verticalHeader()->hide();
  modes_->setSelectionBehavior(QAbstractItemView::SelectRows);
  modes_->setSelectionMode(QAbstractItemView::SingleSelection);
  modes_->setEditTriggers(QAbstractItemView::AllEditTriggers);
  modes_->setTabKeyNavigation(false);
  modes_->setMinimumHeight(1);  // it scrolls
}

void CutForm::fillMaterials() {
  material_->addItem(tr("by its forces"), QString());
  for (const EnteredMaterial& material : entry_.materials()) {
    material_->addItem(material.id, material.id);
    material_->setItemData(material_->count() - 1, sayCore(material.what.toStdString()), Qt::ToolTipRole);
  }
}

void CutForm::takeMaterial() {
  const auto& materials = entry_.materials();
  const QString id = material_->currentData().toString();
  const auto found = std::ranges::find_if(materials, [&id](const EnteredMaterial& m) { return m.id == id; });
  if (found == materials.end()) return;
  const QSignalBlocker quietTangential(tangential_), quietRadial(radial_);
  tangential_->setValue(found->tangential / kPerMm2);
  radial_->setValue(found->radial / kPerMm2);
}

void CutForm::setLengthRanges() {
  const bool inch = units_ == UnitSystem::Inch;
  const struct {
    QDoubleSpinBox* box;
    int decimals;
    double least, most;  // [m]
  } lengths[] = {{diameter_, inch ? 4 : 2, 0.1e-3, 0.5},
                 {width_, inch ? 4 : 2, 0.01e-3, 0.5},
                 {feed_, inch ? 5 : 3, 0.0, 5e-3},
                 {depth_, inch ? 4 : 2, 0.01e-3, 0.2},
                 {deepest_, inch ? 4 : 2, 0.1e-3, 0.5}};
  for (const auto& length : lengths) {
    length.box->setDecimals(length.decimals);
    length.box->setSuffix(QChar(0xa0) + lengthUnit(units_));
    length.box->setRange(lengthIn(Metres(length.least), units_), lengthIn(Metres(length.most), units_));
  }
}

void CutForm::setUnits(UnitSystem units) {
  if (units == units_) return;
  const EnteredCut now = cut();
  units_ = units;
  setLengthRanges();
  fill(now);
}

// A field that shows what it was given gives exactly that back: its digits are fewer.
EnteredCut CutForm::cut() const {
  EnteredCut cut = begun_;
  const auto changed = [](const QDoubleSpinBox* box, double shown) {
    return std::abs(box->value() - shown) > 0.51 * std::pow(10.0, -box->decimals());
  };
  const auto length = [&](const QDoubleSpinBox* box, Metres& value) {
    if (changed(box, lengthIn(value, units_))) value = lengthFrom(box->value(), units_);
  };
  cut.teeth = static_cast<int>(teeth_->value());
  length(diameter_, cut.diameter);
  if (changed(helix_, cut.helix / kDegree)) cut.helix = helix_->value() * kDegree;
  cut.material = material_->currentData().toString();
  if (changed(tangential_, cut.tangential / kPerMm2)) cut.tangential = tangential_->value() * kPerMm2;
  if (changed(radial_, cut.radial / kPerMm2)) cut.radial = radial_->value() * kPerMm2;
  Metres width = begun_.diameter * begun_.immersion;
  length(width_, width);
  cut.immersion = std::clamp(width / cut.diameter, 1e-4, 1.0);
  cut.upMilling = side_->currentIndex() == 1;
  length(feed_, cut.feedPerTooth);
  length(depth_, cut.depth);
  length(deepest_, cut.deepest);
  if (changed(lowest_, cut.lowest.value)) cut.lowest = Rpm(lowest_->value());
  if (changed(highest_, cut.highest.value)) cut.highest = Rpm(highest_->value());
  cut.modes.clear();
  for (int row = 0; row < modes_->rowCount(); ++row) {
    EnteredMode mode =
        row < static_cast<int>(begun_.modes.size()) ? begun_.modes[static_cast<std::size_t>(row)] : EnteredMode{};
    const QString along = modes_->item(row, Along)->text().trimmed().toLower();
    if (along != alongText(mode.direction)) {
      mode.direction = along == QStringLiteral("y") ? std::array{0.0, 1.0} : std::array{1.0, 0.0};
    }
    const auto take = [&](int column, double& value, double unit, int decimals) {
      const double typed = numberOf(*modes_, row, column);
      if (std::abs(typed - value / unit) > 0.51 * std::pow(10.0, -decimals)) value = typed * unit;
    };
    take(Frequency, mode.frequency.value, 1.0, 1);
    take(Damping, mode.damping, 0.01, 3);
    take(Stiffness, mode.stiffness, kPerMicron, 3);
    cut.modes.push_back(mode);
  }
  return cut;
}

void CutForm::fill(const EnteredCut& cut) {
  begun_ = cut;
  file_->setText(cut.file.isEmpty() ? tr("Your own cut: type it, or open a file")
                                    : breakable(QFileInfo(cut.file).fileName()));
  const QSignalBlocker quietTangential(tangential_), quietRadial(radial_);
  teeth_->setValue(cut.teeth);
  diameter_->setValue(lengthIn(cut.diameter, units_));
  helix_->setValue(cut.helix / kDegree);
  material_->setCurrentIndex(std::max(material_->findData(cut.material), 0));
  tangential_->setValue(cut.tangential / kPerMm2);
  radial_->setValue(cut.radial / kPerMm2);
  if (!cut.material.isEmpty()) takeMaterial();
  width_->setValue(lengthIn(cut.diameter * cut.immersion, units_));
  side_->setCurrentIndex(cut.upMilling ? 1 : 0);
  feed_->setValue(lengthIn(cut.feedPerTooth, units_));
  depth_->setValue(lengthIn(cut.depth, units_));
  deepest_->setValue(lengthIn(cut.deepest, units_));
  lowest_->setValue(cut.lowest.value);
  highest_->setValue(cut.highest.value);
  modes_->setRowCount(0);
  for (const EnteredMode& mode : cut.modes) {
    appendRow({alongText(mode.direction), QString::number(mode.frequency.value, 'f', 1),
               QString::number(100.0 * mode.damping, 'f', 3), QString::number(mode.stiffness / kPerMicron, 'f', 3)});
  }
  if (cut.modes.empty()) addMode();
}

void CutForm::appendRow(const std::array<QString, 4>& texts) {
  const int row = modes_->rowCount();
  modes_->insertRow(row);
  for (int column = 0; column < kModeColumns; ++column) {
    auto* item = new QTableWidgetItem(texts[static_cast<std::size_t>(column)]);
    if (column != Along) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    modes_->setItem(row, column, item);
  }
  remove_->setEnabled(modes_->rowCount() > 1);
}

void CutForm::addMode() {
  if (modes_->rowCount() >= kMostModes) return;
  appendRow({QStringLiteral("x"), {}, QStringLiteral("3"), {}});
}

// The row's place in what was begun goes with it.
void CutForm::removeMode() {
  const int row = modes_->currentRow() >= 0 ? modes_->currentRow() : modes_->rowCount() - 1;
  EnteredCut left = cut();
  if (left.modes.size() < 2 || row < 0 || row >= static_cast<int>(left.modes.size())) return;
  left.modes.erase(left.modes.begin() + row);
  fill(left);
}

void CutForm::browse() {
  // Not modal: what commands the machine stays within reach.
  auto* dialog = new QFileDialog(this, tr("A cut, a scenario, a profile or modes"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setModal(false);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, &CutForm::openFile);
  dialog->show();
}

void CutForm::openFile(const QString& path) {
  const auto read = entry_.read(cut(), path);
  if (!read) return tell(sayError(read.error()), Tone::Onset);
  fill(*read);
  enter();
}

void CutForm::enter() {
  const EnteredCut now = cut();
  const Status done = entry_.enter(now);
  if (!done) return tell(sayError(done.error()), Tone::Onset);
  begun_ = now;
  said_->hide();
  emit stateChanged();
  emit entered();
}

void CutForm::tell(const QString& text, Tone tone) {
  said_->setTone(tone);
  said_->setText(text);
  said_->setVisible(!text.isEmpty());
}

void CutForm::keep(QSettings& settings) const {
  const EnteredCut& c = begun_;
  settings.setValue(QStringLiteral("cut-file"), c.file);
  QVariantList modes;
  for (const EnteredMode& m : c.modes) {
    modes << QVariant(QVariantList{m.frequency.value, m.damping, m.stiffness, m.direction[0], m.direction[1]});
  }
  settings.setValue(QStringLiteral("cut-modes"), modes);
  settings.setValue(QStringLiteral("cut-material"), c.material);
  settings.setValue(
      QStringLiteral("cut-numbers"),
      QVariantList{c.teeth, c.diameter.value, c.helix, c.tangential, c.radial, c.immersion, c.upMilling ? 1 : 0,
                   c.feedPerTooth.value, c.depth.value, c.deepest.value, c.lowest.value, c.highest.value});
}

void CutForm::restore(const QSettings& settings) {
  const QVariantList n = settings.value(QStringLiteral("cut-numbers")).toList();
  constexpr qsizetype kNumbers = 12;
  if (n.size() != kNumbers) return;
  EnteredCut c;
  c.file = settings.value(QStringLiteral("cut-file")).toString();
  if (!QFileInfo::exists(c.file)) c.file.clear();
  for (const QVariant& row : settings.value(QStringLiteral("cut-modes")).toList()) {
    const QVariantList m = row.toList();
    if (m.size() != 5) continue;
    c.modes.push_back({Hertz(m[0].toDouble()), m[1].toDouble(), m[2].toDouble(), {m[3].toDouble(), m[4].toDouble()}});
  }
  c.material = settings.value(QStringLiteral("cut-material")).toString();
  c.teeth = n[0].toInt();
  c.diameter = Metres(n[1].toDouble());
  c.helix = n[2].toDouble();
  c.tangential = n[3].toDouble();
  c.radial = n[4].toDouble();
  c.immersion = n[5].toDouble();
  c.upMilling = n[6].toInt() != 0;
  c.feedPerTooth = Metres(n[7].toDouble());
  c.depth = Metres(n[8].toDouble());
  c.deepest = Metres(n[9].toDouble());
  c.lowest = Rpm(n[10].toDouble());
  c.highest = Rpm(n[11].toDouble());
  fill(c);
  if (!c.modes.empty()) (void)entry_.enter(c).ok();
}

void CutForm::applyTheme(const Theme& theme) {
  Panel::applyTheme(theme);
  const int high = touchHeight(theme, this), gap = std::max(theme.px(10), pixelsFor(kTouchGapMm, this));
  for (QWidget* field : fields_) {
    field->setFont(theme.font(type_size::kBody));
    field->setFixedHeight(high);
  }
  modes_->setFont(theme.font(type_size::kBody));
  modes_->horizontalHeader()->setFont(theme.font(type_size::kLabel));
  modes_->verticalHeader()->setDefaultSectionSize(high);
  layout()->setContentsMargins(theme.px(14), theme.px(10), theme.px(14), theme.px(10));
  layout()->setSpacing(gap);
  grid_->setHorizontalSpacing(gap);
  grid_->setVerticalSpacing(theme.px(4));
  for (QBoxLayout* line : lines_) line->setSpacing(gap);
}

}  // namespace stillcut::ui
