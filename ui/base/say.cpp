#include "ui/base/say.h"

namespace stillcut::ui {
namespace {

QString said(const Message::Argument& argument) {
  if (argument.messages.empty()) return QString::fromStdString(argument.verbatim);
  const std::string_view between = argument.separator;
  return sayCore(argument.messages, QString::fromUtf8(between.data(), static_cast<qsizetype>(between.size())));
}

}  // namespace

QString sayCore(const Message& message) {
  const QString form = sayCore(message.form);
  QString out;
  for (qsizetype k = 0; k < form.size(); ++k) {
    const int place = form[k] == u'%' && k + 1 < form.size() ? form[k + 1].digitValue() : -1;
    if (place < 1 || static_cast<std::size_t>(place) > message.arguments.size()) {
      out += form[k];
      continue;
    }
    out += said(message.arguments[static_cast<std::size_t>(place - 1)]);
    ++k;
  }
  return out;
}

QString sayCore(const std::vector<Message>& messages, const QString& separator) {
  QStringList all;
  for (const Message& message : messages) all << sayCore(message);
  return all.join(separator);
}

}  // namespace stillcut::ui
