#include "ui/shell/window_state.h"

#include <QDir>
#include <QSettings>
#include <QVariant>
#include <algorithm>

#include "ui/pages/page.h"

namespace stillcut::ui {
namespace {

QVariant read(const QSettings* settings, const char* key) {
  return settings != nullptr ? settings->value(QLatin1String(key)) : QVariant();
}

void write(QSettings* settings, const char* key, const QVariant& value) {
  if (settings != nullptr) settings->setValue(QLatin1String(key), value);
}

}  // namespace

WindowState::WindowState(const QString& folder) {
  if (folder.isEmpty()) return;
  settings_ = std::make_unique<QSettings>(QDir(folder).filePath(QStringLiteral("window.ini")), QSettings::IniFormat);
}

WindowState::~WindowState() = default;

QByteArray WindowState::geometry() const {
  return read(settings_.get(), "window/geometry").toByteArray();
}

void WindowState::setGeometry(const QByteArray& geometry) {
  write(settings_.get(), "window/geometry", geometry);
}

std::optional<ThemeKind> WindowState::theme() const {
  const QVariant kept = read(settings_.get(), "window/theme");
  const int kind = kept.toInt();
  const bool known = kept.isValid() && kind >= 0 && kind <= static_cast<int>(ThemeKind::HighContrast);
  return known ? std::optional(static_cast<ThemeKind>(kind)) : std::nullopt;
}

void WindowState::setTheme(ThemeKind kind) {
  write(settings_.get(), "window/theme", static_cast<int>(kind));
}

TextSize WindowState::textSize() const {
  const int step = read(settings_.get(), "window/text").toInt();
  return static_cast<TextSize>(std::clamp(step, 0, static_cast<int>(TextSize::Largest)));
}

void WindowState::setTextSize(TextSize size) {
  write(settings_.get(), "window/text", static_cast<int>(size));
}

UnitSystem WindowState::units() const {
  const bool inch = read(settings_.get(), "window/units").toString() == QStringLiteral("inch");
  return inch ? UnitSystem::Inch : UnitSystem::Metric;
}

void WindowState::setUnits(UnitSystem units) {
  write(settings_.get(), "window/units", units == UnitSystem::Inch ? QStringLiteral("inch") : QStringLiteral("metric"));
}

std::optional<Language> WindowState::language() const {
  return languageFrom(read(settings_.get(), "window/language").toString());
}

void WindowState::setLanguage(Language language) {
  write(settings_.get(), "window/language", languageCode(language));
}

bool WindowState::guideSeen() const {
  return !settings_ || settings_->value(QStringLiteral("window/guide")).toString() == QStringLiteral("seen");
}

void WindowState::setGuideSeen() {
  write(settings_.get(), "window/guide", QStringLiteral("seen"));
}

QString WindowState::page() const {
  return read(settings_.get(), "window/page").toString();
}

void WindowState::setPage(const QString& id) {
  write(settings_.get(), "window/page", id);
}

void WindowState::restore(std::span<Page* const> pages) {
  if (!settings_) return;
  for (Page* page : pages) {
    settings_->beginGroup(page->objectName());
    page->restore(*settings_);
    settings_->endGroup();
  }
}

void WindowState::keep(std::span<Page* const> pages) {
  if (!settings_) return;
  for (const Page* page : pages) {
    settings_->beginGroup(page->objectName());
    page->keep(*settings_);
    settings_->endGroup();
  }
  settings_->sync();
}

}  // namespace stillcut::ui
