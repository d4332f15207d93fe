#include "ui/base/core_sentence.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <algorithm>
#include <vector>

#include "translations/core_sentences.h"

namespace stillcut::ui {
namespace {

constexpr int kDeepest = 4;  // a value in a sentence in a sentence

struct Form {
  const char* english;
  QRegularExpression pattern;  // a group per place, and one before it where it continues something
  bool continues = false;      // ", or auto"
  qsizetype letters = 0;
};

QString inLanguage(const QString& english) {
  return QCoreApplication::translate("Core", english.toUtf8().constData());
}

Form formOf(const char* english) {
  Form form;
  form.english = english;
  const QString text = QString::fromUtf8(english);
  static const QRegularExpression kPlace(QStringLiteral("%\\d"));
  const QStringList between = text.split(kPlace);
  QStringList literal;
  for (const QString& part : between) {
    literal << QRegularExpression::escape(part);
    form.letters += part.size();
  }
  form.continues = QStringLiteral(",;:/ ").contains(text.front());
  const QString head = form.continues ? QStringLiteral("(.+?)") : QString();
  form.pattern.setPattern(QRegularExpression::anchoredPattern(head + literal.join(QStringLiteral("(.*?)"))));
  form.pattern.setPatternOptions(QRegularExpression::DotMatchesEverythingOption);
  return form;
}

// What says the most first: "has no channel %1" before "%1 channels".
std::vector<Form> madeForms() {
  std::vector<Form> forms;
  for (const char* const english : kCoreSentences) {
    const QString text = QString::fromUtf8(english);
    if (text.contains(u'%') || QStringLiteral(",;:/ ").contains(text.front())) forms.push_back(formOf(english));
  }
  std::stable_sort(forms.begin(), forms.end(), [](const Form& a, const Form& b) { return a.letters > b.letters; });
  return forms;
}

QString translated(const QString& english, int depth);

QString filled(const Form& form, const QRegularExpressionMatch& match, int depth) {
  const int before = form.continues ? 1 : 0;
  QString text;
  const QString sentence = inLanguage(QString::fromUtf8(form.english));
  for (qsizetype k = 0; k < sentence.size(); ++k) {
    const int place = k + 1 < sentence.size() ? sentence[k + 1].digitValue() : -1;
    if (sentence[k] != u'%' || place < 1 || place + before > match.lastCapturedIndex()) {
      text += sentence[k];
      continue;
    }
    text += translated(match.captured(place + before), depth + 1);
    ++k;
  }
  return before > 0 ? translated(match.captured(1), depth + 1) + text : text;
}

// "helix angle, process damping": where each is known.
QString inList(const QString& english, int depth) {
  QStringList items = english.split(QStringLiteral(", "));
  for (QString& item : items) {
    const QString said = translated(item, depth + 1);
    if (said == item) return english;
    item = said;
  }
  return items.join(QStringLiteral(", "));
}

// "'machine' is not a text": the key and what is wrong with it were put together before.
QString inKey(const QString& english, int depth) {
  static const QRegularExpression kOfKey(QRegularExpression::anchoredPattern(QStringLiteral("('[^']*') (.+)")));
  const QRegularExpressionMatch of = kOfKey.match(english);
  if (!of.hasMatch()) return english;
  const QString said = translated(of.captured(2), depth + 1);
  return said != of.captured(2) ? of.captured(1) + u' ' + said : english;
}

// "where: what (why)", as Error::line() writes it.
QString inParts(const QString& english, int depth) {
  static const QRegularExpression kLine(
      QRegularExpression::anchoredPattern(QStringLiteral("(?:(.+?): )?([^()]+?)(?: \\((.+)\\))?")));
  const QRegularExpressionMatch line = kLine.match(english);
  const bool parts = line.hasMatch() && !(line.captured(1).isEmpty() && line.captured(3).isEmpty());
  if (!parts) return english;
  QString text = translated(line.captured(2), depth + 1);
  if (!line.captured(1).isEmpty()) {
    text = QStringLiteral("%1: ").arg(translated(line.captured(1), depth + 1)) + text;
  }
  if (!line.captured(3).isEmpty()) text += QStringLiteral(" (") + translated(line.captured(3), depth + 1) + u')';
  return text;
}

QString translated(const QString& english, int depth) {
  if (english.isEmpty() || depth > kDeepest) return english;
  QString whole = inLanguage(english);
  if (whole != english) return whole;
  static const std::vector<Form> kForms = madeForms();
  for (const Form& form : kForms) {
    const QRegularExpressionMatch match = form.pattern.match(english);
    if (match.hasMatch()) return filled(form, match, depth);
  }
  QString list = english.contains(QStringLiteral(", ")) ? inList(english, depth) : english;
  if (list != english) return list;
  const QString ofKey = inKey(english, depth);
  return ofKey != english ? ofKey : inParts(english, depth);
}

}  // namespace

QString coreSentence(const std::string& english) {
  return translated(QString::fromStdString(english), 0);
}

}  // namespace stillcut::ui
