// Named settings of the Analyse page: those that come with the program, which stay as they are, then the user's own.
// GUI thread.
#pragma once

#include <QAbstractListModel>
#include <QVariantMap>
#include <optional>
#include <vector>

#include "ui/models/history/analyse_view.h"

class QSettings;

namespace stillcut::ui {

// As settings keep them.
QVariantMap toVariant(const AnalyseOptions& options);
// None: it makes no sense.
std::optional<AnalyseOptions> analyseOptionsFrom(const QVariantMap& map);

class PresetList : public QAbstractListModel {
  Q_OBJECT
 public:
  explicit PresetList(QObject* parent = nullptr);

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

  std::optional<AnalyseOptions> options(int row) const;
  // Takes the place of the user's own of that name. False: the name is empty or one of the program's.
  bool save(const QString& name, const AnalyseOptions& options);
  // False: not the user's own.
  bool remove(int row);
  int rowOf(const QString& name) const;  // -1: none
  bool isOwn(int row) const { return row >= shipped_ && row < rowCount(); }

  void keep(QSettings& settings) const;
  // Entries that make no sense are left out.
  void restore(const QSettings& settings);

 private:
  struct Preset {
    QString name;
    AnalyseOptions options;
  };
  std::vector<Preset> presets_;
  int shipped_ = 0;
};

}  // namespace stillcut::ui
