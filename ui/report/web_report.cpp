#include "ui/report/web_report.h"

#include <QFileInfo>
#include <QLocale>

#include "ui/base/say.h"
#include "ui/report/report_text.h"

namespace stillcut::ui {
namespace {

const QString kStyle = QStringLiteral(
    "body{font:15px/1.45 sans-serif;max-width:1100px;margin:24px auto;padding:0 16px;color:#16191d;background:#fff}"
    "h1{font-size:26px}h2{font-size:19px;margin-top:32px}.what{border-left:5px solid #8a5a00;padding:10px 16px;"
    "background:#f3f4f6;white-space:pre-line}table{border-collapse:collapse;width:100%}td,th{padding:4px 10px 4px 0;"
    "border-bottom:1px solid #d5d9de;text-align:left;vertical-align:top}.n{text-align:right;white-space:nowrap}"
    "svg{width:100%;height:auto}pre{font-size:12px;columns:3;white-space:pre-wrap}");

QString tag(const char* name, const QString& inside) {
  return QStringLiteral("<%1>%2</%1>\n").arg(QLatin1String(name), inside);
}

QString tableOf(const QString& title, const std::vector<TableColumn>& columns, const std::vector<TableRow>& rows) {
  if (rows.empty()) return {};
  const auto cell = [](const char* kind, const TableColumn& column, const QString& text) {
    return QStringLiteral("<%1%2>%3</%1>")
        .arg(QLatin1String(kind), column.number ? QStringLiteral(" class=n") : QString(), text.toHtmlEscaped());
  };
  QString head, body;
  for (const TableColumn& column : columns) head += cell("th", column, column.title);
  for (const TableRow& row : rows) {
    QString line;
    for (std::size_t c = 0; c < columns.size(); ++c)
      line += cell("td", columns[c], row.cells.value(static_cast<qsizetype>(c)));
    body += tag("tr", line);
  }
  return tag("h2", title.toHtmlEscaped()) + tag("table", tag("tr", head) + body);
}

}  // namespace

QString webReport(const SessionSummary& summary, const QString& plots, UnitSystem units) {
  const QString file = QFileInfo(QString::fromStdString(summary.file)).fileName();
  QString facts;
  for (const auto& [name, value] : cutFacts(summary, units)) {
    facts += tag("tr", tag("th", name.toHtmlEscaped()) + tag("td", value.toHtmlEscaped()));
  }
  QString body = tag("h1", say("Cut report").toHtmlEscaped()) + tag("p", file.toHtmlEscaped());
  body += QStringLiteral("<p class=what>%1</p>\n").arg(whatHappened(summary, units).toHtmlEscaped());
  body += tag("table", facts) + plots;
  body += tableOf(say("Alarms and what was done"), interventionColumns(units), interventionRows(summary, units));
  body += tableOf(say("Markers"), markerColumns(), markerRows(summary));
  body += tableOf(say("Events"), eventColumns(), eventRows(summary));
  body += tableOf(say("Sensor check"), sensorColumns(), sensorRows(summary));
  body += tableOf(say("Settings changed during the cut"), changeColumns(), changeRows(summary));
  const QStringList settings = settingLines(summary);
  if (!settings.isEmpty()) {
    body += tag("h2", say("Settings at the beginning").toHtmlEscaped());
    body += tag("pre", settings.join(u'\n').toHtmlEscaped());
  }
  return QStringLiteral(
             "<!doctype html>\n<html lang=\"%1\"><head><meta charset=\"utf-8\"><title>%2</title><style>%3"
             "</style></head>\n<body>\n%4</body></html>\n")
      .arg(QLocale().bcp47Name(), file.toHtmlEscaped(), kStyle, body);
}

}  // namespace stillcut::ui
