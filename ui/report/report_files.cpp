#include "ui/report/report_files.h"

#include <QBuffer>
#include <QFileInfo>
#include <QImage>
#include <QPdfWriter>
#include <QSaveFile>
#include <QSvgGenerator>
#include <algorithm>

#include "ui/report/report_pages.h"
#include "ui/report/session_plots.h"
#include "ui/report/web_report.h"

namespace stillcut::ui {
namespace {

constexpr int kDotsPerInch = 1200;
constexpr double kUnitsPerInch = 96.0;
constexpr double kPictureMargin = 18;

Error cannotWrite(const QString& path, const QString& why) {
  return Error{path.toStdString(), message("cannot be written"), foreign(why.toStdString())};
}

int drawPages(QPdfWriter& pdf, const SessionSummary& summary, UnitSystem units, int pageCount) {
  QPainter painter;
  if (!painter.begin(&pdf)) return 0;
  painter.scale(kDotsPerInch / kUnitsPerInch, kDotsPerInch / kUnitsPerInch);
  return ReportPages(painter, &pdf, summary, units, pageCount).draw();
}

int countPages(const SessionSummary& summary, UnitSystem units) {
  QImage nowhere(1, 1, QImage::Format_RGB32);
  QPainter painter(&nowhere);
  return ReportPages(painter, nullptr, summary, units, 0).draw();
}

void drawPicture(QPaintDevice& device, const SessionSummary& summary, QSize size) {
  QPainter painter(&device);
  const PageStyle style;
  painter.fillRect(QRect(QPoint(), size), style.colors().panel);
  const QRectF area(0, 0, size.width(), size.height());
  drawSessionPlots(painter, area.adjusted(kPictureMargin, kPictureMargin, -kPictureMargin, -kPictureMargin), summary,
                   style);
}

// The plots as SVG, without the head of a file of its own.
QString drawing(const SessionSummary& summary) {
  constexpr QSize kSize{1100, 760};
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  QSvgGenerator svg;
  svg.setOutputDevice(&buffer);
  svg.setSize(kSize);
  svg.setViewBox(QRect(QPoint(), kSize));
  drawPicture(svg, summary, kSize);
  const QString text = QString::fromUtf8(buffer.data());
  return text.mid(std::max<qsizetype>(text.indexOf(QStringLiteral("<svg")), 0));
}

}  // namespace

Status writeReport(const SessionSummary& summary, const QString& path, UnitSystem units) {
  QSaveFile file(path);
  if (!file.open(QIODevice::WriteOnly)) return cannotWrite(path, file.errorString());
  {
    QPdfWriter pdf(&file);
    pdf.setResolution(kDotsPerInch);
    pdf.setPageSize(QPageSize(QPageSize::A4));
    pdf.setPageMargins(QMarginsF(0, 0, 0, 0));
    pdf.setTitle(QFileInfo(QString::fromStdString(summary.file)).fileName());
    pdf.setCreator(QStringLiteral("Stillcut"));
    if (drawPages(pdf, summary, units, countPages(summary, units)) == 0) return cannotWrite(path, file.errorString());
  }
  if (!file.commit()) return cannotWrite(path, file.errorString());
  return Done{};
}

Status writeWebReport(const SessionSummary& summary, const QString& path, UnitSystem units) {
  QSaveFile file(path);
  if (!file.open(QIODevice::WriteOnly)) return cannotWrite(path, file.errorString());
  file.write(webReport(summary, drawing(summary), units).toUtf8());
  if (!file.commit()) return cannotWrite(path, file.errorString());
  return Done{};
}

Status writePicture(const SessionSummary& summary, const QString& path, QSize size) {
  const bool vector = path.endsWith(QStringLiteral(".svg"));
  if (!vector && !path.endsWith(QStringLiteral(".png")))
    return cannotWrite(path, QStringLiteral("the suffix must be .png or .svg"));
  QSaveFile file(path);
  if (!file.open(QIODevice::WriteOnly)) return cannotWrite(path, file.errorString());
  if (vector) {
    QSvgGenerator svg;
    svg.setOutputDevice(&file);
    svg.setSize(size);
    svg.setViewBox(QRect(QPoint(), size));
    svg.setTitle(QFileInfo(QString::fromStdString(summary.file)).fileName());
    drawPicture(svg, summary, size);
  } else {
    QImage image(size, QImage::Format_RGB32);
    drawPicture(image, summary, size);
    if (!image.save(&file, "PNG")) return cannotWrite(path, file.errorString());
  }
  if (!file.commit()) return cannotWrite(path, file.errorString());
  return Done{};
}

Status writeByName(const SessionSummary& summary, const QString& path, UnitSystem units) {
  constexpr QSize kPicture{1400, 900};
  if (path.endsWith(QStringLiteral(".pdf"))) return writeReport(summary, path, units);
  if (path.endsWith(QStringLiteral(".html"))) return writeWebReport(summary, path, units);
  return writePicture(summary, path, kPicture);
}

}  // namespace stillcut::ui
