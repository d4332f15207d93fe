#include "ui/models/plain_words.h"

#include <QRegularExpression>

#include "ui/base/say.h"
#include "ui/models/setup_draft.h"

namespace stillcut::ui {

QString withoutKeys(const QString& description) {
  static const QRegularExpression kKeys(QStringLiteral(R"(: (?=[^:]*$)([a-z0-9_]+)(,| [^:]*,|$)[^:]*$)"));
  const QRegularExpressionMatch keys = kKeys.match(description);
  if (!keys.hasMatch()) return description;
  const QString list = description.mid(keys.capturedStart());
  const bool several = list.contains(u',') || list.contains(u'_');
  return several ? description.left(keys.capturedStart()) : description;
}

QString plainWords(const QString& sentence) {
  QString words = sentence;
  words.replace(QStringLiteral("[[channels]]"), say("channels"));
  static const QRegularExpression kPart(QStringLiteral(R"(\bsource '([a-z-]+)')"));
  for (auto part = kPart.match(words); part.hasMatch(); part = kPart.match(words)) {
    words.replace(part.capturedStart(), part.capturedLength(), sourceCaption(part.captured(1)));
  }
  static const QRegularExpression kKey(QStringLiteral(R"(\b[a-z][a-z0-9]*(?:_[a-z0-9]+)+\b)"));
  for (auto key = kKey.match(words); key.hasMatch(); key = kKey.match(words)) {
    QString label = settingLabel(key.captured().toStdString());
    label.replace(u'_', u' ');
    words.replace(key.capturedStart(), key.capturedLength(), QStringLiteral("\u201c%1\u201d").arg(label));
  }
  return words;
}

QString sourceCaption(const QString& id) {
  const struct {
    const char* id;
    QString caption;
  } known[] = {{"simulated", say("SIMULATED")}, {"replay", say("RECORDING")}, {"alsa", say("AUDIO")},
               {"comedi", say("DAQ CARD")},     {"iio", say("IIO")},          {"serial", say("SERIAL")},
               {"joined", say("JOINED")},       {"tcp", say("NETWORK")}};
  for (const auto& kind : known) {
    if (id == QLatin1String(kind.id)) return kind.caption;
  }
  return id.toUpper();
}

}  // namespace stillcut::ui
