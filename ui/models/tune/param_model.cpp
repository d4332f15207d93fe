#include "ui/models/tune/param_model.h"

#include <algorithm>
#include <cmath>

#include "ui/base/format.h"
#include "ui/base/say.h"
#include "ui/models/tune/param_scale.h"

namespace stillcut::ui {
namespace {

using config::ParamDecl;
using config::ParamKind;

QString roleText(TunableComponent::Role role) {
  switch (role) {
    case TunableComponent::Role::Conditioner:
      return say("before every detector");
    case TunableComponent::Role::Detector:
      return say("detector");
    case TunableComponent::Role::Strategy:
      return say("strategy");
    case TunableComponent::Role::Gate:
      return say("limits of the machine");
    case TunableComponent::Role::Recording:
      return say("recording");
    case TunableComponent::Role::Active:
      return say("a loop of its own");  // which tells its state itself
  }
  return {};
}

// "detector, in charge"
QString placeText(const TunableComponent& part) {
  QString role = roleText(part.role);
  if (part.role == TunableComponent::Role::Active) return role;
  return say("%1, %2").arg(role, part.inCharge ? say("in charge") : part.running ? say("runs") : say("does not run"));
}

}  // namespace

ParamModel::ParamModel(TuningController& controller, QObject* parent) : QAbstractTableModel(parent) {
  work(controller);
}

void ParamModel::work(TuningController& controller) {
  if (controller_ != nullptr) controller_->disconnect(this);
  controller_ = &controller;
  connect(&controller, &TuningController::changed, this, [this] {
    if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
  });
}

void ParamModel::show(const TunableComponent* part) {
  beginResetModel();
  part_ = part;
  own_.clear();
  endResetModel();
}

bool ParamModel::setRunning(bool running) {
  if (running == running_) return false;
  running_ = running;
  if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
  return true;
}

QString ParamModel::lockReason(const ParamDecl& decl) const {
  if (!running_ || !decl.lockedWhileRunning) return {};
  switch (part_->role) {
    case TunableComponent::Role::Gate:
      return tr("Locked while the cut runs: the limits of the machine hold for a whole run");
    case TunableComponent::Role::Recording:
      return tr("Locked while the cut runs: a file keeps one way of recording");
    default:
      return tr("Locked while the cut runs: filters and windows are sized for it before the first block");
  }
}

const AutoReading* ParamModel::reading(const ParamDecl& decl) const {
  const auto own = std::find_if(own_.begin(), own_.end(), [&](const AutoReading& r) { return r.key == decl.key; });
  return own != own_.end() ? &*own : nullptr;
}

double ParamModel::ownValue(const ParamDecl& decl) const {
  if (const AutoReading* own = reading(decl)) return own->value;
  const auto found = part_->chosen.find(decl.key);
  return found != part_->chosen.end() ? found->second : config::kAutomatic;
}

QString ParamModel::otherOwnText() const {
  QStringList lines;
  for (const AutoReading& own : own_) {
    const auto isParam = [&](const ParamDecl* d) { return d->key == own.key; };
    if (std::any_of(part_->params.begin(), part_->params.end(), isParam)) continue;
    const QString label = sayCore(own.label.toStdString()), why = sayCore(own.why.toStdString());
    const QString value = join(significant(own.value, 3), sayCore(own.unit.toStdString()));
    lines << (std::isfinite(own.value) ? tr("%1: %2 (%3)").arg(label, value, why) : tr("%1: %2").arg(label, why));
  }
  return lines.join(u'\n');
}

QString ParamModel::automaticText(const ParamDecl& decl) const {
  if (!decl.mayBeAutomatic || std::isfinite(controller_->value(decl))) return {};
  if (const AutoReading* own = reading(decl)) {
    const QString why = sayCore(own->why.toStdString());
    if (!std::isfinite(own->value)) return why;
    return tr("chose %1 (%2)").arg(join(significant(own->value, 3), sayCore(std::string(decl.unit))), why);
  }
  const auto found = part_->chosen.find(decl.key);
  if (found == part_->chosen.end() || !std::isfinite(found->second)) {
    return part_->running && part_->role == TunableComponent::Role::Detector
               ? tr("follows what is learned from the cut")
               : QString();
  }
  return tr("chose %1").arg(join(valueText(decl, found->second), sayCore(std::string(decl.unit))));
}

ParamView ParamModel::view(int row) const {
  const ParamDecl& d = decl(row);
  const double value = controller_->value(d);
  ParamView view;
  view.label = sayCore(std::string(d.label));
  view.meaning = sayCore(std::string(d.meaning));
  view.unit = sayCore(std::string(d.unit));
  view.value = valueText(d, value);
  view.range = rangeText(d);
  view.automatic = automaticText(d);
  view.locked = lockReason(d);
  view.fallback = valueText(d, d.fallback);
  view.fraction = fractionOf(d, value);
  view.fallbackFraction = fractionOf(d, d.fallback);
  view.mayBeAutomatic = d.mayBeAutomatic;
  view.isAutomatic = d.mayBeAutomatic && std::isnan(value);
  view.changed = view.value != view.fallback;
  view.otherSide = valueText(d, controller_->value(d, TuningController::A)) !=
                   valueText(d, controller_->value(d, TuningController::B));
  if (d.kind == ParamKind::Boolean) view.choices = {tr("off"), tr("on")};
  if (d.kind == ParamKind::Choice) {
    for (const std::string_view word : d.choices) view.choices.push_back(sayCore(std::string(word)));
  }
  if (!view.choices.isEmpty()) view.chosen = static_cast<int>(value);
  return view;
}

int ParamModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || part_ == nullptr ? 0 : static_cast<int>(part_->params.size());
}

int ParamModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : ColumnCount;
}

QVariant ParamModel::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
  const ParamView shown = view(index.row());
  if (role == Qt::ToolTipRole) return shown.locked.isEmpty() ? shown.meaning : shown.locked;
  if (role == Qt::EditRole && index.column() == Value) return controller_->value(decl(index.row()));
  if (role != Qt::DisplayRole) return {};
  switch (index.column()) {
    case Name:
      return shown.label;
    case Value:
      return shown.value;
    case Unit:
      return shown.unit;
    default:
      return shown.fallback;
  }
}

bool ParamModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid) || index.column() != Value || role != Qt::EditRole)
    return false;
  const ParamDecl& d = decl(index.row());
  if (!lockReason(d).isEmpty()) return false;
  const std::optional<double> wanted =
      value.metaType().id() == QMetaType::Double ? std::optional(value.toDouble()) : valueFrom(d, value.toString());
  if (!wanted || !config::isLegal(d, *wanted)) return false;
  controller_->set(d, *wanted);
  return true;
}

Qt::ItemFlags ParamModel::flags(const QModelIndex& index) const {
  Qt::ItemFlags flags = QAbstractTableModel::flags(index);
  if (index.isValid() && index.column() == Value && lockReason(decl(index.row())).isEmpty()) {
    flags |= Qt::ItemIsEditable;
  }
  return flags;
}

QVariant ParamModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  const QStringList titles{tr("Parameter"), tr("Value"), tr("Unit"), tr("Default")};
  return section >= 0 && section < ColumnCount ? QVariant(titles[section]) : QVariant();
}

void ComponentListModel::show(const std::vector<TunableComponent>& parts) {
  beginResetModel();
  parts_.clear();
  for (const TunableComponent& part : parts) {
    if (!part.params.empty()) parts_.push_back(&part);
  }
  const auto rank = [](const TunableComponent* p) { return p->inCharge ? 0 : p->running ? 1 : 2; };
  std::stable_sort(parts_.begin(), parts_.end(), [&](const auto* a, const auto* b) { return rank(a) < rank(b); });
  endResetModel();
}

const TunableComponent* ComponentListModel::part(int row) const {
  return row >= 0 && row < rowCount() ? parts_[static_cast<std::size_t>(row)] : nullptr;
}

int ComponentListModel::rowOf(const QString& id) const {
  const auto found = std::find_if(parts_.begin(), parts_.end(), [&](const TunableComponent* p) { return p->id == id; });
  return found == parts_.end() ? -1 : static_cast<int>(found - parts_.begin());
}

int ComponentListModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(parts_.size());
}

QVariant ComponentListModel::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
  const TunableComponent& part = *parts_[static_cast<std::size_t>(index.row())];
  const QString name = sayCore(part.label.toStdString());
  switch (role) {
    case Qt::DisplayRole:
      return name + u'\n' + placeText(part);
    case Qt::ToolTipRole:
      return part.source;
    case Qt::AccessibleTextRole:
      return tr("%1, %2").arg(name, placeText(part));
    default:
      return {};
  }
}

}  // namespace stillcut::ui
