// SetupDraft: the profile that is being put together, and whether each part of it is ready. Knows no widget. GUI
// thread.
#pragma once

#include <QAbstractTableModel>
#include <QObject>
#include <optional>
#include <vector>

#include "ui/base/units.h"
#include "ui/facade/setup_controller.h"

namespace stillcut::ui {

// The tool's pitch as one angle a tooth, in degrees; empty: even. Nothing: it does not go once around.
std::optional<std::vector<double>> pitchAngles(const ToolEntry& tool);

// Depths of cut that a profile can hold.
inline constexpr Metres kShallowestCut{1e-6}, kDeepestCut{1.0};

class SetupDraft : public QObject {
  Q_OBJECT
 public:
  explicit SetupDraft(QObject* parent = nullptr) : QObject(parent) {}

  const config::Profile& profile() const { return profile_; }
  const QString& name() const { return name_; }
  void open(const config::Profile& profile, const QString& name);
  void setName(const QString& name);
  // How lengths and feeds are shown and typed; the profile is SI.
  UnitSystem units() const { return units_; }
  void setUnits(UnitSystem units);
  // Changes the profile by `edit` and tells of it.
  template <class Edit>
  void edit(Edit&& edit) {
    edit(profile_);
    emit changed();
  }
  void setSource(const QString& id);
  // With its first input as the only channel, unless channels of what it measures are set up already.
  void useDevice(const FoundDevice& device);
  void setLink(const QString& id);
  // Empty: as if it had not been said.
  void setSourceSetting(const QString& key, const QString& value);
  void setLinkSetting(const QString& key, const QString& value);
  // With its modes, its pitch and its highest speed; what it does not say is not known, or has no limit.
  void useTool(const ToolEntry& tool);

  enum class Part { Machine, Sensors, Tool };
  // What is still missing; empty: it is ready.
  QString missing(Part part) const;

 signals:
  void changed();

 private:
  config::Profile profile_;
  QString name_;
  UnitSystem units_ = UnitSystem::Metric;
};

// The channels of the draft: name, quantity, SI units per device unit, axis.
class ChannelModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { Name, Quantity, Scale, Axis, ColumnCount };
  explicit ChannelModel(SetupDraft& draft, QObject* parent = nullptr);
  void add();
  void remove(int row);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  SetupDraft& draft_;
  int rows_ = 0;
};

// The shop's tools as a list.
class ToolModel : public QAbstractListModel {
  Q_OBJECT
 public:
  using QAbstractListModel::QAbstractListModel;
  void show(std::vector<ToolEntry> tools);
  UnitSystem units() const { return units_; }
  void setUnits(UnitSystem units);
  const std::vector<ToolEntry>& tools() const { return tools_; }
  const ToolEntry* tool(int row) const;
  void put(int row, const ToolEntry& tool);
  int add(const ToolEntry& tool);
  void insert(int row, const ToolEntry& tool);
  void remove(int row);

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

 private:
  std::vector<ToolEntry> tools_;
  UnitSystem units_ = UnitSystem::Metric;
};

// "hal_port" as a label: "Hal port"; a unit at its end ("_percent", "_mm") in brackets.
QString settingLabel(const std::string& key);

}  // namespace stillcut::ui
