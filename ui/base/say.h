// The words of the free functions of the screens, translated. lupdate reads calls of say() in namespace stillcut::ui as
// messages of that context (see translations/update); classes with Q_OBJECT use tr(). GUI thread.
#pragma once

#include <QCoreApplication>
#include <QString>
#include <QStringList>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace stillcut::ui {

inline QString say(const char* text) {
  return QCoreApplication::translate("stillcut::ui", text);
}

// Words that core declares once for files, command line and screens: labels, units and meanings of parameters, names of
// detectors, strategies, links and devices. The program core_texts (tests/ui) lists them for lupdate.
inline QString sayCore(const std::string& text) {
  return text.empty() ? QString() : QCoreApplication::translate("Core", text.c_str());
}

// Messages of core in the reader's language: forms are translated, and arguments that are messages; what is echoed
// stays as it is. Any thread.
QString sayCore(const Message& message);
QString sayCore(const std::vector<Message>& messages, const QString& separator = QStringLiteral("; "));
inline QString sayError(const Error& error) {
  return sayCore(error.asMessage());
}

}  // namespace stillcut::ui
