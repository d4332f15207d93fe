// The pages of a report, drawn on any paged device. GUI thread.
#pragma once

#include <QCoreApplication>
#include <QPagedPaintDevice>
#include <QPainter>

#include "core/model/session_summary.h"
#include "ui/base/units.h"
#include "ui/report/page_style.h"

namespace stillcut::ui {

// A4 in units of 1/96 inch.
inline constexpr double kPageWidth = 793.7;
inline constexpr double kPageHeight = 1122.5;

class ReportPages {
  Q_DECLARE_TR_FUNCTIONS(ReportPages)

 public:
  // Without a device the pages are only counted.
  ReportPages(QPainter& painter, QPagedPaintDevice* device, const SessionSummary& summary, UnitSystem units,
              int pageCount);
  // Draws all of them; returns how many there are.
  int draw();

 private:
  void firstPage();
  void interventions();
  void markers();
  void more(std::uint64_t all, std::size_t shown);
  void events();
  void sensors();
  void settings();
  void section(const QString& title, double needed);
  void table(const QString& title, const std::vector<struct TableColumn>& columns,
             const std::vector<struct TableRow>& rows);
  void beginPage();
  void newPage();
  double left() const;
  double room() const;  // height left on this page

  QPainter& painter_;
  QPagedPaintDevice* device_;
  const SessionSummary& summary_;
  UnitSystem units_;
  PageStyle style_;
  int pageCount_;
  int page_ = 0;
  double y_ = 0.0;
};

}  // namespace stillcut::ui
