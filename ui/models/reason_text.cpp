#include "ui/models/reason_text.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include "ui/models/format.h"

namespace stillcut::ui {

QString reasonText(const Reason& reason) {
  const std::string english(pattern(reason.code));
  QString text = QCoreApplication::translate("Reason", english.c_str());
  static const QRegularExpression kPlace(QStringLiteral("\\{(\\d)\\.(\\d)\\}"));
  QRegularExpressionMatch match = kPlace.match(text);
  while (match.hasMatch()) {
    const auto index = static_cast<std::size_t>(match.capturedView(1).toInt()) % reason.n.size();
    text.replace(match.capturedStart(), match.capturedLength(), number(reason.n[index], match.capturedView(2).toInt()));
    match = kPlace.match(text);
  }
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

}  // namespace stillcut::ui
