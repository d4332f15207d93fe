#include "ui/base/typed_number.h"

#include <cmath>

namespace stillcut::ui {

QString plainSpeed(QString text) {
  constexpr QChar kNarrow(0x202f), kNoBreak(0xa0);
  text = text.trimmed();
  text.remove(u' ').remove(kNarrow).remove(kNoBreak).remove(u'\'');
  const qsizetype comma = text.lastIndexOf(u',');
  if (comma > 0 && text.size() - comma == 4) {
    text.remove(u',');
  } else {
    text.replace(u',', u'.');
  }
  return text;
}

double typedSpeed(QString text, bool* isNumber) {
  bool ok = false;
  const double value = plainSpeed(std::move(text)).toDouble(&ok);
  ok = ok && std::isfinite(value);
  if (isNumber != nullptr) *isNumber = ok;
  return ok ? value : 0.0;
}

}  // namespace stillcut::ui
