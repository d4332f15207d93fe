#include "app/desktop/report_mode.h"

#include "app/session/file/file_judgement.h"
#include "core/evaluate/session_summary_builder.h"
#include "ui/report/report_files.h"

namespace stillcut::app {

Status makeReport(const QStringList& files, QSize pictureSize, ui::UnitSystem units) {
  if (files.size() != 2)
    return Error{"--report", message("needs a recording and a file to write"), message("--report IN OUT.pdf")};
  const QString& out = files[1];
  const bool pdf = out.endsWith(QStringLiteral(".pdf")) || out.endsWith(QStringLiteral(".html"));
  if (!pdf && !out.endsWith(QStringLiteral(".png")) && !out.endsWith(QStringLiteral(".svg"))) {
    return Error{out.toStdString(), message("cannot be written"),
                 message("the suffix must be .pdf, .html, .png or .svg")};
  }
  const std::string file = files[0].toStdString();
  auto summary = evaluate::summarizeRecording(file);
  if (!summary) return summary.error();
  if (!summary->session && pdf) {
    BackgroundTask::Progress nobodyWaits;
    const auto judged = judgeFile(file, {}, nobodyWaits);
    if (!judged) return judged.error();
    summary->answer = sentencesOf(*judged);
  }
  return pdf ? ui::writeByName(*summary, out, units) : ui::writePicture(*summary, out, pictureSize);
}

}  // namespace stillcut::app
