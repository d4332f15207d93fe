// What the window keeps over restarts, in one file of the session's folder. Without a folder nothing is kept. GUI
// thread.
#pragma once

#include <QByteArray>
#include <QString>
#include <memory>
#include <optional>
#include <span>

#include "ui/base/theme.h"
#include "ui/base/units.h"
#include "ui/shell/language.h"

class QSettings;

namespace stillcut::ui {

class Page;

class WindowState {
 public:
  explicit WindowState(const QString& folder);
  ~WindowState();

  QByteArray geometry() const;
  void setGeometry(const QByteArray& geometry);
  std::optional<ThemeKind> theme() const;
  void setTheme(ThemeKind kind);
  TextSize textSize() const;
  void setTextSize(TextSize size);
  UnitSystem units() const;
  void setUnits(UnitSystem units);
  std::optional<Language> language() const;
  void setLanguage(Language language);
  bool guideSeen()
      const;  // the guide of a first start has been answered; where nothing is kept, there is no first start
  void setGuideSeen();
  QString page() const;  // id; empty: none kept
  void setPage(const QString& id);

  // Every page has the group of its object name to itself.
  void restore(std::span<Page* const> pages);
  void keep(std::span<Page* const> pages);

 private:
  std::unique_ptr<QSettings> settings_;  // null: nothing is kept
};

}  // namespace stillcut::ui
