#include "app/desktop/report_mode.h"

#include "core/evaluate/session_summary_builder.h"
#include "ui/report/report_files.h"

namespace stillcut::app {

Status makeReport(const QStringList& files, QSize pictureSize, ui::UnitSystem units) {
  if (files.size() != 2)
    return Error{"--report", message("needs a recording and a file to write"), message("--report IN OUT.pdf")};
  const QString& out = files[1];
  const bool pdf = out.endsWith(QStringLiteral(".pdf"));
  if (!pdf && !out.endsWith(QStringLiteral(".png")) && !out.endsWith(QStringLiteral(".svg"))) {
    return Error{out.toStdString(), message("cannot be written"), message("the suffix must be .pdf, .png or .svg")};
  }
  const auto summary = evaluate::summarizeRecording(files[0].toStdString());
  if (!summary) return summary.error();
  return pdf ? ui::writeReport(*summary, out, units) : ui::writePicture(*summary, out, pictureSize);
}

}  // namespace stillcut::app
