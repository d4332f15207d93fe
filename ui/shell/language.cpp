#include "ui/shell/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
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
  for (auto* translator : {&translator_, &dialogs_}) {
    if (*translator) QCoreApplication::removeTranslator(translator->get());
  }
}

void Speaker::speak(Language language) {
  for (auto* translator : {&translator_, &dialogs_}) {
    if (*translator) QCoreApplication::removeTranslator(translator->get());
    translator->reset();
  }
  language_ = language;
  // Numbers are typed as the language writes them. A point that separates thousands is refused: 0.05 is not 5.
  QLocale numbers(languageCode(language));
  numbers.setNumberOptions(QLocale::OmitGroupSeparator | QLocale::RejectGroupSeparator);
  QLocale::setDefault(numbers);
  auto dialogs = std::make_unique<QTranslator>();  // the toolkit's own words: the dialog of files
  const QString folder = QLibraryInfo::path(QLibraryInfo::TranslationsPath);
  const QString file = language == Language::Chinese ? QStringLiteral("qtbase_zh_CN")
                                                     : QStringLiteral("qtbase_") + languageCode(language);
  if (dialogs->load(file, folder)) {
    QCoreApplication::installTranslator(dialogs.get());
    dialogs_ = std::move(dialogs);
  }
  auto translator = std::make_unique<QTranslator>();
  if (!translator->load(QStringLiteral(":/translations/stillcut_%1.qm").arg(languageCode(language)))) return;
  QCoreApplication::installTranslator(translator.get());
  translator_ = std::move(translator);
}

}  // namespace stillcut::ui
