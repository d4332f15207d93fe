// Sessions: the recordings there are; one of them replayed by hand, marked by people, held against every detector on
// one time axis, scored, and exported.
#pragma once

#include <functional>
#include <vector>

#include "ui/facade/session_controller.h"
#include "ui/pages/page.h"

class QBoxLayout;
class QLineEdit;

namespace stillcut::ui {

class EventPanel;
class MarkSheet;
class Panel;
class SessionList;
class SessionTimeline;
class TextLabel;
class TouchButton;
class TransportBar;

class SessionsPage : public Page {
  Q_OBJECT
 public:
  using ReportWriter = std::function<Status(const SessionSummary&, const QString& file, UnitSystem)>;
  // `desk` may be null: there are no recordings to work on here. It outlives the page.
  SessionsPage(SessionController* controller, ReportWriter report, QWidget* parent = nullptr);

  void see(const Picture& picture) override;
  void display(const Picture& picture) override;
  void applyTheme(const Theme& theme) override;
  void keep(QSettings& settings) const override;
  void restore(const QSettings& settings) override;

 private:
  QWidget* makeBelow();
  QWidget* makeResults();
  void connectTransport();
  void connectMarks();
  void refresh();
  void showResults();
  void showEvents(const SessionSummary* summary);
  void tell(const Status& status, const QString& done);
  void nextFormat();
  void exportChosen();
  void writeDrawn(const QString& suffix);
  QString exportName(const QString& suffix) const;

  QString keptFolder_;  // that was said to be worth keeping
  SessionController* controller_;
  ReportWriter report_;
  Theme theme_;
  UnitSystem units_ = UnitSystem::Metric;
  bool taskRan_ = false;
  std::size_t format_ = 0;  // of EXPORT

  SessionList* list_ = nullptr;
  MarkSheet* marks_ = nullptr;
  EventPanel* events_ = nullptr;
  QLineEdit* settings_ = nullptr;
  TouchButton *run_ = nullptr, *tuned_ = nullptr, *score_ = nullptr, *scoreAll_ = nullptr, *cut_ = nullptr,
              *pdf_ = nullptr, *everywhere_ = nullptr, *formatButton_ = nullptr, *stop_ = nullptr, *beside_ = nullptr,
              *whole_ = nullptr;
  TextLabel *title_ = nullptr, *facts_ = nullptr, *status_ = nullptr, *results_ = nullptr, *verdict_ = nullptr;
  SessionTimeline* timeline_ = nullptr;
  TransportBar* transport_ = nullptr;
  Panel *panel_ = nullptr, *below_ = nullptr;
  std::vector<QBoxLayout*> lines_;  // of touch targets
};

}  // namespace stillcut::ui
