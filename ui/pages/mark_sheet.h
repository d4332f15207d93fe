// The markers of the opened recording: one touch for what an alarm was, any span under a name of one's own, notes
// before and afterwards. Whoever uses it knows what is selected in the picture. GUI thread.
#pragma once

#include <QWidget>
#include <functional>
#include <optional>

#include "ui/base/themed.h"
#include "ui/models/session_models.h"

class QBoxLayout;
class QLineEdit;
class QListView;

namespace stillcut::ui {

class TouchButton;

class MarkSheet : public QWidget, public Themed {
  Q_OBJECT
 public:
  // `desk` may be null: nothing can be marked. It outlives the widget.
  explicit MarkSheet(SessionController* controller, QWidget* parent = nullptr);

  // What the next marker is about: the selected span, or the present moment. Set before the first touch.
  std::function<std::pair<Seconds, Seconds>()> chosen;

  void refresh();
  void applyTheme(const Theme& theme) override;

 signals:
  // A span was chosen in the list, or a moment (end = begin).
  void wentTo(Seconds begin, Seconds end);
  void told(const Status& status, const QString& done);

 private:
  QLineEdit* makeEdit(const QString& shown, const QString& spoken, const char* name);
  void mark(const QString& label);
  void markSpan();
  void change();
  void remove();
  void choose(int row);
  void edit(const Marker& marker);
  void editNone();
  void currentMoved(int row);
  void enable();
  const Marker* current() const;

  SessionController* controller_;
  MarkerModel markers_;
  QString path_;                         // of the recording that the markers are of
  std::optional<std::uint64_t> edited_;  // whose label and note are in the fields; none: they are of the next marker
  struct Removed {
    Seconds begin, length;
    QString label, note;
  };
  std::optional<Removed> removed_;  // the last one, while it can be brought back
  bool refreshing_ = false;
  QListView* list_;
  QLineEdit *label_, *note_;
  TouchButton *span_, *change_, *remove_;
  std::vector<TouchButton*> touches_;
  std::vector<QBoxLayout*> lines_;
};

}  // namespace stillcut::ui
