#include "ui/shell/apply_theme.h"

#include <QApplication>
#include <QFile>
#include <QPalette>
#include <QWidget>
#include <utility>
#include <vector>

#include "ui/base/themed.h"
#include "ui/widgets/painting.h"

static void loadStyleResource() {
  Q_INIT_RESOURCE(style);  // a static library's resources are not registered by themselves
}

namespace stillcut::ui {
namespace {

QString styleSheet(const Theme& theme, int touch) {
  loadStyleResource();
  QFile file(QStringLiteral(":/style/stillcut.qss"));
  if (!file.open(QIODevice::ReadOnly)) return {};
  QString sheet = QString::fromUtf8(file.readAll());
  const std::vector<std::pair<QString, QString>> values{
      {QStringLiteral("@window"), theme.colors.window.name()},
      {QStringLiteral("@raised"), theme.colors.raised.name()},
      {QStringLiteral("@text"), theme.colors.text.name()},
      {QStringLiteral("@border"), theme.colors.border.name()},
      {QStringLiteral("@panel"), theme.colors.panel.name()},
      {QStringLiteral("@track"), theme.colors.track.name()},
      {QStringLiteral("@faint"), theme.colors.faint.name()},
      {QStringLiteral("@accentText"), theme.colors.onAdvice.name()},
      {QStringLiteral("@advice"), theme.colors.advice.name()},
      {QStringLiteral("@body"), QStringLiteral("%1px").arg(theme.textPx(type_size::kBody))},
      {QStringLiteral("@fill"), theme.colors.fill.name()},
      {QStringLiteral("@touch"), QStringLiteral("%1px").arg(touch)},
      {QStringLiteral("@bar"), QStringLiteral("%1px").arg(theme.px(18))},
      {QStringLiteral("@label"), QStringLiteral("%1px").arg(theme.textPx(type_size::kLabel))}};
  for (const auto& [name, value] : values) sheet.replace(name, value);
  return sheet;
}

QPalette paletteOf(const ThemeColors& c) {
  QPalette palette;
  palette.setColor(QPalette::Window, c.window);
  palette.setColor(QPalette::WindowText, c.text);
  palette.setColor(QPalette::Base, c.panel);
  palette.setColor(QPalette::AlternateBase, c.track);
  palette.setColor(QPalette::Text, c.text);
  palette.setColor(QPalette::Button, c.raised);
  palette.setColor(QPalette::ButtonText, c.text);
  palette.setColor(QPalette::Highlight, c.advice);
  palette.setColor(QPalette::HighlightedText, c.onAdvice);
  return palette;
}

}  // namespace

void applyTheme(QWidget& window, const Theme& theme) {
  window.setPalette(paletteOf(theme.colors));
  window.setStyleSheet(styleSheet(theme, touchHeight(theme, &window)));
  if (auto* self = dynamic_cast<Themed*>(&window)) self->applyTheme(theme);
  const QList<QWidget*> children = window.findChildren<QWidget*>();
  for (QWidget* child : children) {
    if (auto* themed = dynamic_cast<Themed*>(child)) themed->applyTheme(theme);
  }
}

ThemeKind desktopTheme() {
  return QApplication::palette().color(QPalette::Window).lightnessF() < 0.5 ? ThemeKind::Dark : ThemeKind::Light;
}

}  // namespace stillcut::ui
