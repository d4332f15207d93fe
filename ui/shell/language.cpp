#include "ui/shell/language.h"

#include <QCoreApplication>
#include <QLocale>

namespace stillcut::ui {

QString languageCode(Language language) {
  switch (language) {
    case Language::English:
      return QStringLiteral("en");
    case Language::German:
      return QStringLiteral("de");
    case Language::Chinese:
      return QStringLiteral("zh");
  }
  return {};
}

QString nameOfItself(Language language) {
  switch (language) {
    case Language::English:
      return QStringLiteral("English");
    case Language::German:
      return QStringLiteral("Deutsch");
    case Language::Chinese:
      return QStringLiteral("\u4e2d\u6587");
  }
  return {};
}

std::optional<Language> languageFrom(const QString& code) {
  for (const Language language : kLanguages) {
    if (code.left(2).toLower() == languageCode(language)) return language;
  }
  return std::nullopt;
}

Language desktopLanguage() {
  return languageFrom(QLocale::system().name()).value_or(Language::English);
}

Speaker::~Speaker() {
  if (translator_) QCoreApplication::removeTranslator(translator_.get());
}

void Speaker::speak(Language language) {
  if (translator_) QCoreApplication::removeTranslator(translator_.get());
  translator_.reset();
  language_ = language;
  auto translator = std::make_unique<QTranslator>();
  if (!translator->load(QStringLiteral(":/translations/stillcut_%1.qm").arg(languageCode(language)))) return;
  QCoreApplication::installTranslator(translator.get());
  translator_ = std::move(translator);
}

}  // namespace stillcut::ui
