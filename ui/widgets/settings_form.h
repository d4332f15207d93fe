// A form made from what a part asks for: text, numbers, switches and choices, one row each; what is wrong is told
// beside the row. GUI thread.
#pragma once

#include <QWidget>
#include <map>
#include <string>
#include <vector>

#include "core/config/component_settings.h"
#include "ui/base/themed.h"

class QLineEdit;
class QVBoxLayout;

namespace stillcut::ui {

class SettingsForm : public QWidget, public Themed {
  Q_OBJECT
 public:
  explicit SettingsForm(QWidget* parent = nullptr);

  // `prefix`: of the editors' object names.
  void show(const std::vector<config::SettingDecl>& asked, const std::map<std::string, std::string>& values,
            const QString& prefix);
  void applyTheme(const Theme& theme) override;

 signals:
  // An empty value: as the part has it.
  void edited(const QString& key, const QString& value);
  void fileWanted(const QString& key);  // somebody wants to choose it

 private:
  QString valueOf(const config::SettingDecl& setting) const;
  void showValue(const config::SettingDecl& setting);
  QWidget* withBrowse(QLineEdit* edit, const config::SettingDecl& setting);
  QWidget* makeEditor(const config::SettingDecl& setting, const QString& value, const QString& name);

  Theme theme_;
  QVBoxLayout* rows_;
  std::vector<config::SettingDecl> asked_;
  std::map<std::string, std::string> values_;
  QString prefix_;
};

}  // namespace stillcut::ui
