#include "ui/report/report_pages.h"

#include <QFileInfo>
#include <QFontMetricsF>

#include "ui/report/report_text.h"
#include "ui/report/session_plots.h"
#include "ui/report/table.h"

namespace stillcut::ui {
namespace {

constexpr double kMargin = 52;
constexpr double kHead = 64;     // from the top of the paper to the rule under the head
constexpr double kFoot = 44;     // below the last line
constexpr double kSection = 34;  // a title and the air above it
constexpr double kWidth = kPageWidth - 2 * kMargin;

}  // namespace

ReportPages::ReportPages(QPainter& painter, QPagedPaintDevice* device, const SessionSummary& summary, UnitSystem units,
                         int pageCount)
    : painter_(painter), device_(device), summary_(summary), units_(units), pageCount_(pageCount) {}

double ReportPages::left() const {
  return kMargin;
}

double ReportPages::room() const {
  return kPageHeight - kFoot - y_;
}

int ReportPages::draw() {
  beginPage();
  firstPage();
  if (summary_.session) {
    interventions();
    markers();
    events();
  }
  sensors();
  settings();
  return page_;
}

void ReportPages::newPage() {
  if (device_ != nullptr) device_->newPage();
  beginPage();
}

void ReportPages::beginPage() {
  ++page_;
  const ThemeColors& colors = style_.colors();
  const QString file = QFileInfo(QString::fromStdString(summary_.file)).fileName();
  const QRectF head(kMargin, kMargin - 24, kWidth, 28);
  const QFont large = style_.font(page_ == 1 ? 22 : 13, true);
  drawLine(painter_, head, page_ == 1 ? tr("Cut report") : file, large, colors.text);
  const QString right = page_ == 1 ? file : tr("page %1 of %2").arg(page_).arg(pageCount_);
  drawLine(painter_, head.adjusted(200, 0, 0, 0), right, style_.font(12), colors.secondary,
           Qt::AlignRight | Qt::AlignVCenter);
  painter_.setPen(QPen(colors.text, 1.4));
  painter_.drawLine(QPointF(kMargin, kHead), QPointF(kPageWidth - kMargin, kHead));
  const QRectF foot(kMargin, kPageHeight - 36, kWidth, 14);
  drawLine(painter_, foot, QStringLiteral("Stillcut"), style_.font(10), colors.faint);
  drawLine(painter_, foot, QStringLiteral("%1 / %2").arg(page_).arg(pageCount_), style_.font(10), colors.faint,
           Qt::AlignRight | Qt::AlignVCenter);
  y_ = kHead + 12;
}

void ReportPages::section(const QString& title, double needed) {
  if (room() < kSection + needed) newPage();
  drawLine(painter_, QRectF(left(), y_ + 10, kWidth, 20), title, style_.font(14, true), style_.colors().text);
  y_ += kSection;
}

void ReportPages::firstPage() {
  const ThemeColors& colors = style_.colors();
  // What happened, in a band of its own: what a reader wants first.
  const QFont words = style_.font(14);
  const QString text = whatHappened(summary_, units_);
  const QRectF measure(0, 0, kWidth - 34, 400);
  const double height = QFontMetricsF(words).boundingRect(measure, Qt::TextWordWrap, text).height() + 20;
  const QRectF band(left(), y_ + 4, kWidth, height);
  painter_.fillRect(band, colors.panel);
  const Tone tone = whatHappenedTone(summary_);
  painter_.fillRect(QRectF(band.left(), band.top(), 5, band.height()),
                    tone == Tone::Normal ? colors.fill : style_.theme().back(tone));
  drawWords(painter_, band.adjusted(20, 10, -14, -8), text, words, colors.text);
  y_ = band.bottom() + 12;

  const Facts facts = cutFacts(summary_, units_);
  constexpr double kLine = 18;
  const std::size_t half = (facts.size() + 1) / 2;
  for (std::size_t i = 0; i < facts.size(); ++i) {
    const double x = left() + (i < half ? 0.0 : kWidth / 2 + 8);
    const double y = y_ + static_cast<double>(i < half ? i : i - half) * kLine;
    drawLine(painter_, QRectF(x, y, 84, kLine), facts[i].first, style_.font(11), colors.secondary);
    drawLine(painter_, QRectF(x + 88, y, kWidth / 2 - 96, kLine), facts[i].second, style_.font(11, true), colors.text);
  }
  y_ += static_cast<double>(half) * kLine + 12;
  drawSessionPlots(painter_, QRectF(left() - 6, y_, kWidth + 12, room() - 6), summary_, style_);
  y_ = kPageHeight;
}

void ReportPages::table(const QString& title, const std::vector<TableColumn>& columns,
                        const std::vector<TableRow>& rows) {
  section(title, 3 * kTableRow);
  const std::vector<TableColumn> fit = fitted(columns, rows, kWidth, style_);
  const std::vector<TableRow> lines = wrapped(fit, rows, kWidth, style_);
  int first = 0;
  while (first < static_cast<int>(lines.size())) {
    double used = 0.0;
    first += drawTable(painter_, QRectF(left(), y_, kWidth, room()), fit, lines, first, style_, used);
    y_ += used;
    if (first < static_cast<int>(lines.size())) newPage();
  }
}

// A list that is not whole says so.
void ReportPages::more(std::uint64_t all, std::size_t shown) {
  if (all <= shown) return;
  drawLine(painter_, QRectF(left(), y_ + 2, kWidth, 16), tr("and %1 more").arg(all - shown), style_.font(10),
           style_.colors().secondary);
  y_ += 18;
}

void ReportPages::interventions() {
  if (summary_.interventions.empty()) return;
  table(tr("Alarms and what was done"), interventionColumns(units_), interventionRows(summary_, units_));
  more(summary_.alarms, summary_.interventions.size());
  const QString note =
      tr("Before: highest until the first command. After: newest at the end of the alarm. "
         "Numbers are those in the plots.");
  y_ += 4 + drawWords(painter_, QRectF(left(), y_ + 4, kWidth, 40), note, style_.font(10), style_.colors().secondary);
}

void ReportPages::events() {
  if (summary_.events.empty()) return;
  table(tr("Events"), eventColumns(), eventRows(summary_));
  more(summary_.eventCount, summary_.events.size());
}

void ReportPages::markers() {
  if (!summary_.markers.empty()) table(tr("Markers"), markerColumns(), markerRows(summary_));
}

void ReportPages::sensors() {
  if (summary_.sensors.empty()) return;  // a history of features has no samples to check
  table(tr("Sensor check"), sensorColumns(), sensorRows(summary_));
  if (!summary_.session) return;
  y_ += 2;
}

void ReportPages::settings() {
  if (!summary_.settingChanges.empty()) {
    table(tr("Settings changed during the cut"), changeColumns(), changeRows(summary_));
    more(summary_.settingChangeCount, summary_.settingChanges.size());
  }
  const QStringList lines = settingLines(summary_);
  if (lines.isEmpty()) return;
  constexpr double kLine = 12.5;
  constexpr int kColumns = 3;
  section(tr("Settings at the beginning"), 6 * kLine);
  qsizetype next = 0;
  while (next < lines.size()) {
    const auto rows = static_cast<qsizetype>(room() / kLine);
    const qsizetype left_ = lines.size() - next;
    const qsizetype perColumn = std::min(rows, (left_ + kColumns - 1) / kColumns);
    for (int c = 0; c < kColumns && next < lines.size(); ++c) {
      for (qsizetype r = 0; r < perColumn && next < lines.size(); ++r, ++next) {
        const bool head = lines[next].startsWith(u'[');
        const QRectF place(left() + c * (kWidth + 12) / kColumns, y_ + static_cast<double>(r) * kLine,
                           (kWidth + 12) / kColumns - 12, kLine);
        drawLine(painter_, place, lines[next], style_.font(9, head),
                 head ? style_.colors().text : style_.colors().secondary);
      }
    }
    y_ += static_cast<double>(perColumn) * kLine;
    if (next < lines.size()) newPage();
  }
}

}  // namespace stillcut::ui
