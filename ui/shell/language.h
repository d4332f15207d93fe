// The languages of the screens and the translator that is installed for one. GUI thread.
#pragma once

#include <QString>
#include <QTranslator>
#include <array>
#include <memory>
#include <optional>

namespace stillcut::ui {

enum class Language { English, German, Chinese };
inline constexpr std::array kLanguages{Language::English, Language::German, Language::Chinese};

QString languageCode(Language language);                    // "en", "de", "zh"
QString nameOfItself(Language language);                    // "English", "Deutsch", "\u4e2d\u6587"
std::optional<Language> languageFrom(const QString& code);  // the first two letters count
Language desktopLanguage();                                 // English where the desktop's is none of ours

// While it lives, the application speaks the language it was last told.
class Speaker {
 public:
  explicit Speaker(Language language) { speak(language); }
  ~Speaker();
  Speaker(const Speaker&) = delete;
  Speaker& operator=(const Speaker&) = delete;

  void speak(Language language);
  Language language() const { return language_; }

 private:
  Language language_ = Language::English;
  std::unique_ptr<QTranslator> translator_, dialogs_;
};

}  // namespace stillcut::ui
