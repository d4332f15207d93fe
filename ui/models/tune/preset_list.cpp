#include "ui/models/tune/preset_list.h"

#include <QSettings>
#include <algorithm>
#include <cmath>

namespace stillcut::ui {
namespace {

AnalyseOptions orders() {
  AnalyseOptions o;
  o.axis = FrequencyAxis::Order;
  return o;
}

AnalyseOptions entry() {
  AnalyseOptions o;
  o.span = Seconds(1.0);
  return o;
}

AnalyseOptions shift() {
  AnalyseOptions o;
  o.span = Seconds(120.0);
  o.maxHold = true;
  return o;
}

}  // namespace

QVariantMap toVariant(const AnalyseOptions& o) {
  return {{QStringLiteral("waterfall"), o.form == SpectrogramForm::Waterfall},
          {QStringLiteral("linear"), o.level == LevelScale::Linear},
          {QStringLiteral("order"), o.axis == FrequencyAxis::Order},
          {QStringLiteral("max-hold"), o.maxHold},
          {QStringLiteral("events"), o.events},
          {QStringLiteral("channel"), o.channel},
          {QStringLiteral("span-s"), o.span.value},
          {QStringLiteral("low-hz"), o.low.value},
          {QStringLiteral("high-hz"), o.high.value}};
}

std::optional<AnalyseOptions> analyseOptionsFrom(const QVariantMap& map) {
  AnalyseOptions o;
  const auto flag = [&](const char* key) { return map.value(QLatin1String(key)).toBool(); };
  const auto real = [&](const char* key) { return map.value(QLatin1String(key)).toDouble(); };
  o.form = flag("waterfall") ? SpectrogramForm::Waterfall : SpectrogramForm::HeatMap;
  o.level = flag("linear") ? LevelScale::Linear : LevelScale::Decibel;
  o.axis = flag("order") ? FrequencyAxis::Order : FrequencyAxis::Hertz;
  o.maxHold = flag("max-hold");
  o.events = flag("events");
  o.channel = std::max(map.value(QStringLiteral("channel")).toInt(), 0);
  o.span = Seconds(real("span-s"));
  o.low = Hertz(real("low-hz"));
  o.high = Hertz(real("high-hz"));
  const bool sane = std::isfinite(o.span.value) && o.span.value > 0.0 && std::isfinite(o.low.value) &&
                    std::isfinite(o.high.value) && o.high > o.low && o.low.value >= 0.0;
  return sane ? std::optional(o) : std::nullopt;
}

PresetList::PresetList(QObject* parent) : QAbstractListModel(parent) {
  presets_ = {{tr("Last 10 s"), AnalyseOptions{}},
              {tr("Orders"), orders()},
              {tr("Entry, 1 s"), entry()},
              {tr("2 min, max hold"), shift()}};
  shipped_ = static_cast<int>(presets_.size());
}

int PresetList::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(presets_.size());
}

QVariant PresetList::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
  const bool text = role == Qt::DisplayRole || role == Qt::EditRole || role == Qt::AccessibleTextRole;
  return text ? QVariant(presets_[static_cast<std::size_t>(index.row())].name) : QVariant();
}

std::optional<AnalyseOptions> PresetList::options(int row) const {
  if (row < 0 || row >= rowCount()) return std::nullopt;
  return presets_[static_cast<std::size_t>(row)].options;
}

int PresetList::rowOf(const QString& name) const {
  const auto found = std::find_if(presets_.begin(), presets_.end(), [&](const Preset& p) { return p.name == name; });
  return found == presets_.end() ? -1 : static_cast<int>(found - presets_.begin());
}

bool PresetList::save(const QString& name, const AnalyseOptions& options) {
  const QString clean = name.simplified().left(40);
  const int row = rowOf(clean);
  if (clean.isEmpty() || (row >= 0 && row < shipped_)) return false;
  if (row >= 0) {
    presets_[static_cast<std::size_t>(row)].options = options;
    emit dataChanged(index(row), index(row));
    return true;
  }
  beginInsertRows({}, rowCount(), rowCount());
  presets_.push_back({clean, options});
  endInsertRows();
  return true;
}

bool PresetList::remove(int row) {
  if (!isOwn(row)) return false;
  beginRemoveRows({}, row, row);
  presets_.erase(presets_.begin() + row);
  endRemoveRows();
  return true;
}

void PresetList::keep(QSettings& settings) const {
  QVariantList list;
  for (auto p = presets_.begin() + shipped_; p != presets_.end(); ++p) {
    QVariantMap map = toVariant(p->options);
    map.insert(QStringLiteral("name"), p->name);
    list << map;
  }
  settings.setValue(QStringLiteral("presets"), list);
}

void PresetList::restore(const QSettings& settings) {
  const QVariantList list = settings.value(QStringLiteral("presets")).toList();
  for (const QVariant& entry : list) {
    const QVariantMap map = entry.toMap();
    if (const auto options = analyseOptionsFrom(map)) save(map.value(QStringLiteral("name")).toString(), *options);
  }
}

}  // namespace stillcut::ui
