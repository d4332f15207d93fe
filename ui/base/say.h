// The words of the free functions of the screens, translated. lupdate reads calls of say() in namespace stillcut::ui as
// messages of that context (see translations/update); classes with Q_OBJECT use tr(). GUI thread.
#pragma once

#include <QCoreApplication>
#include <QString>
#include <QStringList>
#include <string>
#include <vector>

#include "core/model/phrase.h"
#include "ui/base/core_sentence.h"

namespace stillcut::ui {

inline QString say(const char* text) {
  return QCoreApplication::translate("stillcut::ui", text);
}

// Words that core declares once for files, command line and screens: labels, units and meanings of parameters, names of
// detectors, strategies, links and devices. translations/core_texts.h lists them.
inline QString sayCore(const std::string& text) {
  return text.empty() ? QString() : QCoreApplication::translate("Core", text.c_str());
}

// Sentences of core with what they tell of; values that are words or sentences of core are translated too. Any thread.
inline QString sayCore(const Phrase& phrase) {
  Phrase told{sayCore(phrase.form).toStdString(), {}};
  for (const std::string& value : phrase.values) told.values.push_back(coreSentence(value).toStdString());
  return QString::fromStdString(stillcut::text(told));
}

inline QString sayCore(const std::vector<Phrase>& phrases) {
  QStringList all;
  for (const Phrase& phrase : phrases) all << sayCore(phrase);
  return all.join(QStringLiteral("; "));
}

inline QString sayError(const Error& error) {
  return sayCore(phraseOf(error));
}

}  // namespace stillcut::ui
