#include "ui/pages/setup/setup_recording.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QLineEdit>
#include <string_view>

#include "ui/base/say.h"
#include "ui/widgets/painting.h"
#include "ui/widgets/text_label.h"
#include "ui/widgets/touch_button.h"

namespace stillcut::ui {
namespace {

constexpr std::string_view kMode = "record.mode";

// Which of the declared numbers speak of one way of recording alone.
bool matters(std::string_view key, std::string_view mode) {
  if (key == "record.before" || key == "record.after") return mode == "around-events";
  if (key == "record.interval" || key == "record.history") return mode == "features";
  return true;
}

QString fromUtf8(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QString shown(std::string_view text) {
  return sayCore(std::string(text));
}

}  // namespace

SetupRecording::SetupRecording(SetupController& controller, SetupDraft& draft, QWidget* parent)
    : SetupTab(controller, draft, parent),
      operator_(makeEdit(tr("Who is at the machine"), QStringLiteral("record-operator"))),
      job_(makeEdit(tr("Job: what is being made"), QStringLiteral("record-job"))),
      folder_(makeEdit(tr("Folder of the recordings"), QStringLiteral("record-folder"))),
      record_(
          makeButton(tr("RECORD EVERY CUT"), tr("Record every cut of this machine"), QStringLiteral("record-every"))),
      about_(new TextLabel({type_size::kBody, false, true, true})),
      names_(new TextLabel({type_size::kBody, false, true, true})),
      problem_(new TextLabel({type_size::kBody, true, false, true})),
      now_(new TextLabel({type_size::kBody, false, false, true})) {
  catalog_.add(controller.recordParams());
  mode_ = catalog_.find(kMode);
  auto* column = new QVBoxLayout(this);
  addNames(column);
  addModes(column);
  addFields(column);
  problem_->setTone(Tone::Onset);
  for (TextLabel* label : {names_, problem_}) column->addWidget(label);
  column->addStretch(1);
  column->addWidget(new TextLabel({type_size::kLabel, true, true}, tr("WHAT RUNS NOW")));
  column->addWidget(now_);
  refresh();
}

void SetupRecording::addNames(QVBoxLayout* column) {
  auto* who = new QHBoxLayout;
  who->addWidget(new TextLabel({type_size::kBody}, tr("Operator")));
  who->addWidget(operator_, 1);
  who->addWidget(new TextLabel({type_size::kBody}, tr("Job")));
  who->addWidget(job_, 1);
  auto* where = new QHBoxLayout;
  record_->setCheckable(true);
  where->addWidget(record_);
  where->addWidget(folder_, 1);
  column->addLayout(who);
  column->addLayout(where);
  connect(operator_, &QLineEdit::editingFinished, this, [this] {
    draft_.edit([this](config::Profile& p) { p.operatorName = operator_->text().trimmed().toStdString(); });
  });
  connect(job_, &QLineEdit::editingFinished, this, [this] {
    draft_.edit([this](config::Profile& p) { p.recording.job = job_->text().trimmed().toStdString(); });
  });
  connect(folder_, &QLineEdit::editingFinished, this, [this] {
    draft_.edit([this](config::Profile& p) { p.recording.folder = folder_->text().trimmed().toStdString(); });
  });
  connect(record_, &TouchButton::clicked, this, [this] {
    const QString folder = record_->isChecked() ? controller_.usualRecordings() : QString();
    draft_.edit([&folder](config::Profile& p) { p.recording.folder = folder.toStdString(); });
  });
}

void SetupRecording::addModes(QVBoxLayout* column) {
  column->addWidget(new TextLabel({type_size::kLabel, true, true}, tr("WHAT IS KEPT")));
  auto* line = new QHBoxLayout;
  for (const std::string_view word : mode_->choices) {
    const QString name = shown(word).replace(u'-', u' ');
    TouchButton* button = makeButton(name.toUpper(), name, QStringLiteral("record-mode-") + fromUtf8(word));
    button->setCheckable(true);
    modes_.push_back(button);
    line->addWidget(button);
    connect(button, &TouchButton::clicked, this, [this, word] { setParam(*mode_, fromUtf8(word)); });
  }
  line->addStretch(1);
  column->addLayout(line);
  column->addWidget(about_);
}

// Two in a line, as they are declared: they belong together.
void SetupRecording::addFields(QVBoxLayout* column) {
  QHBoxLayout* line = nullptr;
  for (const config::ParamDecl* decl : catalog_.all()) {
    if (decl == mode_) continue;
    if (fields_.size() % 2 == 0) {
      auto* row = new QWidget;
      line = new QHBoxLayout(row);
      line->setContentsMargins(0, 0, 0, 0);
      line->setSpacing(pixelsFor(kTouchGapMm, this));
      column->addWidget(row);
    }
    Field field{decl, line->parentWidget(), makeEdit(shown(decl->label), fromUtf8(decl->key))};
    field.edit->setToolTip(shown(decl->meaning));
    const QString label = QStringLiteral("%1, %2").arg(shown(decl->label), shown(decl->unit));
    line->addWidget(new TextLabel(TextLabel::Look{type_size::kBody}, label), 3);
    line->addWidget(field.edit, 2);
    connect(field.edit, &QLineEdit::editingFinished, this, [this, field] {
      if (field.edit->isModified()) setParam(*field.decl, field.edit->text());
    });
    fields_.push_back(field);
  }
}

void SetupRecording::setParam(const config::ParamDecl& decl, const QString& text) {
  QString number = text.trimmed();
  number.replace(u',', u'.');
  Status set = Done{};
  draft_.edit([&](config::Profile& p) {
    if (number.isEmpty()) {
      p.params.unset(decl);
    } else {
      set = p.params.set(catalog_, decl.key, number.toStdString(), shown(decl.label).toStdString());
    }
  });
  problem_->setText(set ? QString() : sayError(set.error()));
}

void SetupRecording::refresh() {
  const config::Profile& profile = draft_.profile();
  const auto show = [](QLineEdit* edit, const std::string& text) {
    if (!edit->hasFocus() || !edit->isModified()) edit->setText(QString::fromStdString(text));
  };
  show(operator_, profile.operatorName);
  show(job_, profile.recording.job);
  show(folder_, profile.recording.folder);
  const bool on = !profile.recording.folder.empty();
  record_->setChecked(on);
  folder_->setPlaceholderText(tr("nothing is recorded"));
  const auto mode = static_cast<std::size_t>(profile.params.choice(*mode_));
  for (std::size_t k = 0; k < modes_.size(); ++k) modes_[k]->setChecked(k == mode);
  const QString kept[] = {
      tr("Every sample, from the beginning of the cut to its end."),
      tr("What surrounds alarms, faults and touches; the time before is held in memory until then."),
      tr("Verdicts and indicators without samples, as a history.")};
  about_->setText(kept[mode]);
  for (const Field& field : fields_) {
    show(field.edit, profile.params.text(*field.decl));
    field.row->setVisible(matters(field.decl->key, mode_->choices[mode]));
  }
  const QString job = profile.recording.job.empty() ? tr("job") : QString::fromStdString(profile.recording.job);
  const QString tool = profile.cut.tool.empty() ? tr("tool") : QString::fromStdString(profile.cut.tool);
  names_->setText(tr("Files are named by job, tool and time: %1")
                      .arg(QStringLiteral("%1/%2/2026-11-22_08-30-00.h5").arg(job, tool)));
}

void SetupRecording::display(const Picture&) {
  const RecordingNow now = controller_.recordingNow();
  QStringList lines;
  switch (now.state) {
    case RecordingNow::State::Off:
      lines << tr("Nothing is recorded. What is chosen here begins with START on the page PROFILE.");
      break;
    case RecordingNow::State::Waits:
      lines << tr("Recording begins with the next event, and with what was before it.");
      break;
    case RecordingNow::State::Writes:
      lines << tr("Writes %1").arg(now.path);
      break;
    case RecordingNow::State::Stopped:
      lines << tr("Recording has stopped; what was recorded is in %1").arg(now.path);
      break;
  }
  if (now.deleted > 0) {
    lines << tr("Deleted because of the limits: %1, the last one %2")
                 .arg(now.deleted)
                 .arg(QFileInfo(now.lastDeleted).fileName());
  }
  if (!now.notDeleted.isEmpty()) {
    constexpr qsizetype kNamed = 3;
    QStringList named = now.notDeleted.mid(0, kNamed);
    if (now.notDeleted.size() > kNamed) named << QStringLiteral("\u2026");
    lines << tr("Too old or too large, but could not be deleted: %1. Free the room by hand: %2")
                 .arg(now.notDeleted.size())
                 .arg(named.join(QStringLiteral(", ")));
  }
  const bool trouble = now.state == RecordingNow::State::Stopped || !now.notDeleted.isEmpty();
  now_->setTone(trouble ? Tone::Onset : Tone::Normal);
  now_->setText(lines.join(u'\n'));
}

}  // namespace stillcut::ui
