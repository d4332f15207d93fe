#include "ui/base/reason_text.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include "ui/base/format.h"
#include "ui/base/say.h"

namespace stillcut::ui {
namespace {

// Some numbers stand for words.
QString valueText(const Reason& reason, std::size_t index, int decimals) {
  const double value = reason.n[index];
  if (reason.code != ReasonCode::AuthorityChanged) return number(value, decimals);
  if (value > 1.5) return QCoreApplication::translate("Reason", "Auto");
  return value > 0.5 ? QCoreApplication::translate("Reason", "Advise") : QCoreApplication::translate("Reason", "Off");
}

}  // namespace

QString reasonWords(const Reason& reason) {
  const std::string english(pattern(reason.code));
  QString text = QCoreApplication::translate("Reason", english.c_str());
  static const QRegularExpression kPlace(QStringLiteral("\\{(\\d)\\.(\\d)\\}"));
  QRegularExpressionMatch match = kPlace.match(text);
  while (match.hasMatch()) {
    const auto index = static_cast<std::size_t>(match.capturedView(1).toInt()) % reason.n.size();
    text.replace(match.capturedStart(), match.capturedLength(),
                 valueText(reason, index, match.capturedView(2).toInt()));
    match = kPlace.match(text);
  }
  return text;
}

QString reasonText(const Reason& reason) {
  QString text = reasonWords(reason);
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

QString onsetText(const Reason& reason) {
  return say("Onset at %1, energy ratio %2")
      .arg(join(number(reason.n[0]), QStringLiteral("Hz")), number(reason.n[1], 2));
}

}  // namespace stillcut::ui
