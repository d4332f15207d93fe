#include "ui/widgets/settings_form.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <algorithm>

#include "ui/base/say.h"
#include "ui/models/setup_draft.h"
#include "ui/widgets/painting.h"
#include "ui/widgets/text_label.h"
#include "ui/widgets/touch_button.h"

namespace stillcut::ui {
namespace {

using Kind = config::SettingDecl::Kind;

bool sameQuestions(const std::vector<config::SettingDecl>& a, const std::vector<config::SettingDecl>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    return x.key == y.key && x.kind == y.kind && x.words == y.words && x.fallback == y.fallback;
  });
}

// What is a file by its key.
bool isFile(const config::SettingDecl& setting) {
  return setting.kind == Kind::Text && (setting.key == "file" || setting.key == "scenario");
}

}  // namespace

SettingsForm::SettingsForm(QWidget* parent)
    : QWidget(parent), theme_(makeTheme(ThemeKind::Light, 1.0)), rows_(new QVBoxLayout(this)) {
  rows_->setContentsMargins(0, 0, 0, 0);
}

void SettingsForm::show(const std::vector<config::SettingDecl>& asked, const std::map<std::string, std::string>& values,
                        const QString& prefix) {
  const bool same = sameQuestions(asked, asked_) && prefix == prefix_;
  if (same && values == values_) return;
  asked_ = asked;
  values_ = values;
  prefix_ = prefix;
  if (same) {  // the editors stay, and with them the focus
    for (const config::SettingDecl& setting : asked_) showValue(setting);
    return;
  }
  while (QLayoutItem* item = rows_->takeAt(0)) {
    if (item->widget() != nullptr) item->widget()->deleteLater();
    delete item;
  }
  for (const config::SettingDecl& setting : asked_) {
    auto* row = new QWidget(this);
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    auto* label = new TextLabel(TextLabel::Look{type_size::kBody}, settingLabel(setting.key));
    label->applyTheme(theme_);
    label->setMinimumWidth(theme_.px(190));
    const QString name = prefix + QString::fromStdString(setting.key);
    line->addWidget(label);
    line->addWidget(makeEditor(setting, valueOf(setting), name), 1);
    rows_->addWidget(row);
  }
}

QString SettingsForm::valueOf(const config::SettingDecl& setting) const {
  const auto value = values_.find(setting.key);
  return value != values_.end() ? QString::fromStdString(value->second) : QString();
}

void SettingsForm::showValue(const config::SettingDecl& setting) {
  const QString name = prefix_ + QString::fromStdString(setting.key), value = valueOf(setting);
  if (auto* edit = findChild<QLineEdit*>(name)) edit->setText(value);
  const QString shown = value.isEmpty() ? QString::fromStdString(setting.fallback) : value;
  for (TouchButton* button : findChildren<TouchButton*>()) {
    if (button->objectName().startsWith(name + u'-')) button->setChecked(button->objectName() == name + u'-' + shown);
  }
}

QWidget* SettingsForm::makeEditor(const config::SettingDecl& setting, const QString& value, const QString& name) {
  const QString key = QString::fromStdString(setting.key);
  const QString fallback = QString::fromStdString(setting.fallback);
  if (setting.kind == Kind::Flag || setting.kind == Kind::Choice) {
    QStringList words{QStringLiteral("false"), QStringLiteral("true")};
    if (setting.kind == Kind::Choice) {
      words.clear();
      for (const std::string& word : setting.words) words.push_back(QString::fromStdString(word));
    }
    auto* box = new QWidget;
    auto* line = new QHBoxLayout(box);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(pixelsFor(kTouchGapMm, this));
    for (const QString& word : words) {
      const QString shown = setting.kind == Kind::Choice     ? sayCore(word.toStdString())
                            : word == QStringLiteral("true") ? tr("yes")
                                                             : tr("no");
      auto* button = new TouchButton(shown);
      button->setObjectName(name + u'-' + word);
      button->setAccessibleName(QStringLiteral("%1: %2").arg(settingLabel(setting.key), shown));
      button->setCheckable(true);
      button->setChecked((value.isEmpty() ? fallback : value) == word);
      button->setBaseHeight(46);
      button->applyTheme(theme_);
      line->addWidget(button);
      connect(button, &TouchButton::clicked, this,
              [this, key, word, fallback] { emit edited(key, word == fallback ? QString() : word); });
    }
    line->addStretch(1);
    return box;
  }
  auto* edit = new QLineEdit(value);
  edit->setObjectName(name);
  edit->setAccessibleName(settingLabel(setting.key));
  edit->setFont(theme_.font(type_size::kBody));
  edit->setFixedHeight(std::max(theme_.px(46), pixelsFor(kTouchMm, this)));
  edit->setPlaceholderText(fallback.isEmpty() ? tr("not set") : fallback);
  if (setting.key.find("password") != std::string::npos) edit->setEchoMode(QLineEdit::PasswordEchoOnEdit);
  if (setting.highest > setting.lowest) {
    edit->setToolTip(tr("%1 to %2").arg(setting.lowest).arg(setting.highest));
  }
  connect(edit, &QLineEdit::editingFinished, this, [this, edit, setting, key] {
    if (edit->text() != valueOf(setting)) emit edited(key, edit->text());
  });
  return isFile(setting) ? withBrowse(edit, setting) : edit;
}

// Beside the field: nobody has to know how a path is written.
QWidget* SettingsForm::withBrowse(QLineEdit* edit, const config::SettingDecl& setting) {
  auto* box = new QWidget;
  auto* line = new QHBoxLayout(box);
  line->setContentsMargins(0, 0, 0, 0);
  auto* browse = new TouchButton(tr("BROWSE"));
  browse->setObjectName(edit->objectName() + QStringLiteral("-browse"));
  browse->setAccessibleName(tr("Choose a file: %1").arg(settingLabel(setting.key)));
  browse->setBaseHeight(46);
  browse->applyTheme(theme_);
  line->addWidget(edit, 1);
  line->addWidget(browse);
  connect(browse, &TouchButton::clicked, this,
          [this, key = QString::fromStdString(setting.key)] { emit fileWanted(key); });
  return box;
}

void SettingsForm::applyTheme(const Theme& theme) {
  theme_ = theme;
  rows_->setSpacing(theme.px(8));
}

}  // namespace stillcut::ui
