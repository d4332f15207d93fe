#include "ui/models/setup_draft.h"

#include <cmath>
#include <utility>

#include "core/config/override_limits.h"
#include "ui/base/format.h"
#include "ui/base/say.h"

namespace stillcut::ui {
namespace {

QString fromUtf8(std::string_view s) {
  return QString::fromUtf8(s.data(), static_cast<qsizetype>(s.size()));
}

void put(std::map<std::string, std::string>& settings, const QString& key, const QString& value) {
  if (value.trimmed().isEmpty()) {
    settings.erase(key.toStdString());
  } else {
    settings[key.toStdString()] = value.trimmed().toStdString();
  }
}

}  // namespace

std::optional<std::vector<double>> pitchAngles(const ToolEntry& tool) {
  constexpr double kClosed = 0.05;  // degrees; as a catalogue rounds them
  std::vector<double> angles;
  double sum = 0.0;
  for (QString text : tool.pitch.split(u' ', Qt::SkipEmptyParts)) {
    bool isNumber = false;
    angles.push_back(text.replace(u',', u'.').toDouble(&isNumber));
    if (!isNumber || !(angles.back() > 0.0)) return std::nullopt;
    sum += angles.back();
  }
  if (angles.empty()) return angles;
  if (static_cast<int>(angles.size()) != tool.teeth || !(std::abs(sum - 360.0) < kClosed)) return std::nullopt;
  return angles;
}

void SetupDraft::open(const config::Profile& profile, const QString& name) {
  profile_ = profile;
  name_ = name;
  emit changed();
}

void SetupDraft::setUnits(UnitSystem units) {
  if (units == units_) return;
  units_ = units;
  emit changed();
}

void SetupDraft::setName(const QString& name) {
  if (name == name_) return;
  name_ = name;
  emit changed();
}

void SetupDraft::setSource(const QString& id) {
  if (fromUtf8(profile_.source.id) == id) return;
  edit([&](config::Profile& p) { p.source = {id.toStdString(), {}}; });
}

void SetupDraft::useDevice(const FoundDevice& device) {
  edit([&](config::Profile& p) {
    p.source = device.source;
    const auto& channels = p.cut.channels;
    const bool known = std::ranges::any_of(
        channels, [&](const ChannelInfo& channel) { return channel.quantity == device.channel.quantity; });
    if (!known) p.cut.channels = {device.channel};
  });
}

void SetupDraft::setLink(const QString& id) {
  if (fromUtf8(profile_.link.id) == id) return;
  edit([&](config::Profile& p) { p.link = {id.toStdString(), {}}; });
}

void SetupDraft::setSourceSetting(const QString& key, const QString& value) {
  edit([&](config::Profile& p) { put(p.source.settings, key, value); });
}

void SetupDraft::setLinkSetting(const QString& key, const QString& value) {
  edit([&](config::Profile& p) { put(p.link.settings, key, value); });
}

void SetupDraft::useTool(const ToolEntry& tool) {
  edit([&](config::Profile& p) {
    p.cut.tool = tool.name.toStdString();
    p.holder = tool.holder.toStdString();
    p.stickOut = Metres(tool.stickOut_mm * 1e-3);
    p.cut.teeth = tool.teeth;
    p.cut.toolDiameter = Metres(tool.diameter_mm * 1e-3);
    p.model = tool.modes.toStdString();  // none: the modes are not known, least of all those of the tool before
    p.pitch = pitchAngles(tool).value_or(std::vector<double>());
    p.params.unset(config::kToolSpeed);
    if (tool.highestSpeed_rpm > 0.0) (void)p.params.set(config::kToolSpeed, tool.highestSpeed_rpm, "tool").ok();
  });
}

QString SetupDraft::missing(Part part) const {
  switch (part) {
    case Part::Machine:
      return profile_.link.id.empty() ? tr("no machine link is chosen: the program will only watch") : QString();
    case Part::Sensors:
      return profile_.source.id.empty() ? tr("no device is chosen") : QString();
    case Part::Tool:
      if (profile_.cut.teeth == 0) return tr("the number of flutes is not known");
      return profile_.cut.nominalSpeed.value > 0.0 ? QString() : tr("the programmed speed is not known");
  }
  return {};
}

ChannelModel::ChannelModel(SetupDraft& draft, QObject* parent) : QAbstractTableModel(parent), draft_(draft) {
  rows_ = static_cast<int>(draft.profile().cut.channels.size());
  connect(&draft, &SetupDraft::changed, this, [this] {
    if (rows_ != static_cast<int>(draft_.profile().cut.channels.size())) {
      beginResetModel();
      rows_ = static_cast<int>(draft_.profile().cut.channels.size());
      endResetModel();
    } else if (rows_ > 0) {
      emit dataChanged(index(0, 0), index(rows_ - 1, ColumnCount - 1));
    }
  });
}

void ChannelModel::add() {
  draft_.edit([](config::Profile& p) {
    ChannelInfo channel;
    channel.name = std::string(1, "xyz"[p.cut.channels.size() % 3]);
    channel.axis = channel.name;
    p.cut.channels.push_back(channel);
  });
}

void ChannelModel::remove(int row) {
  if (row < 0 || row >= rows_) return;
  draft_.edit([row](config::Profile& p) { p.cut.channels.erase(p.cut.channels.begin() + row); });
}

int ChannelModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : rows_;
}

int ChannelModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : ColumnCount;
}

QVariant ChannelModel::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
  if (role != Qt::DisplayRole && role != Qt::EditRole) return {};
  const ChannelInfo& channel = draft_.profile().cut.channels[static_cast<std::size_t>(index.row())];
  switch (index.column()) {
    case Name:
      return fromUtf8(channel.name);
    case Quantity:
      return role == Qt::EditRole ? fromUtf8(name(channel.quantity)) : sayCore(std::string(name(channel.quantity)));
    case Scale:
      return role == Qt::EditRole ? QString::number(channel.scale, 'g', 6)
                                  : join(QString::number(channel.scale, 'g', 6), fromUtf8(siUnit(channel.quantity)));
    default:
      return fromUtf8(channel.axis);
  }
}

bool ChannelModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid) || role != Qt::EditRole) return false;
  const std::string text = value.toString().trimmed().toStdString();
  bool taken = true;
  draft_.edit([&](config::Profile& p) {
    ChannelInfo& channel = p.cut.channels[static_cast<std::size_t>(index.row())];
    if (index.column() == Name && !text.empty()) {
      channel.name = text;
    } else if (index.column() == Quantity && sensorQuantityFromName(text)) {
      channel.quantity = *sensorQuantityFromName(text);
    } else if (index.column() == Axis && text.size() <= 1) {
      channel.axis = text;
    } else if (index.column() == Scale) {
      const double scale = QString::fromStdString(text).replace(u',', u'.').toDouble(&taken);
      taken = taken && std::isfinite(scale) && scale != 0.0;
      if (taken) channel.scale = scale;
    } else {
      taken = false;
    }
  });
  return taken;
}

Qt::ItemFlags ChannelModel::flags(const QModelIndex& index) const {
  const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
  return index.isValid() ? flags | Qt::ItemIsEditable : flags;
}

QVariant ChannelModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  const QStringList titles{tr("Channel"), tr("Quantity"), tr("Per device unit"), tr("Axis")};
  return section >= 0 && section < ColumnCount ? QVariant(titles[section]) : QVariant();
}

void ToolModel::show(std::vector<ToolEntry> tools) {
  beginResetModel();
  tools_ = std::move(tools);
  endResetModel();
}

const ToolEntry* ToolModel::tool(int row) const {
  return row >= 0 && row < rowCount() ? &tools_[static_cast<std::size_t>(row)] : nullptr;
}

void ToolModel::put(int row, const ToolEntry& tool) {
  if (row < 0 || row >= rowCount()) return;
  tools_[static_cast<std::size_t>(row)] = tool;
  emit dataChanged(index(row), index(row));
}

int ToolModel::add(const ToolEntry& tool) {
  const int row = rowCount();
  insert(row, tool);
  return row;
}

void ToolModel::insert(int row, const ToolEntry& tool) {
  if (row < 0 || row > rowCount()) return;
  beginInsertRows({}, row, row);
  tools_.insert(tools_.begin() + row, tool);
  endInsertRows();
}

void ToolModel::remove(int row) {
  if (row < 0 || row >= rowCount()) return;
  beginRemoveRows({}, row, row);
  tools_.erase(tools_.begin() + row);
  endRemoveRows();
}

void ToolModel::setUnits(UnitSystem units) {
  units_ = units;
  if (!tools_.empty()) emit dataChanged(index(0), index(static_cast<int>(tools_.size()) - 1));
}

int ToolModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(tools_.size());
}

QVariant ToolModel::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
  if (role != Qt::DisplayRole && role != Qt::AccessibleTextRole) return {};
  const ToolEntry& t = tools_[static_cast<std::size_t>(index.row())];
  const QString diameter =
      join(QString::number(lengthIn(Metres(t.diameter_mm * 1e-3), units_), 'g', 4), lengthUnit(units_));
  QString facts = tr("D %1, %2 flutes").arg(diameter).arg(t.teeth);
  if (!t.chattered.empty()) facts += u'\n' + tr("chattered here before: %1").arg(t.chattered.size());
  return t.name + u'\n' + facts;
}

QString settingLabel(const std::string& key) {
  const config::SettingName name = config::settingName(key);
  return sayCore(name.words) + (name.unit.empty() ? QString() : QStringLiteral(" [%1]").arg(fromUtf8(name.unit)));
}

}  // namespace stillcut::ui
