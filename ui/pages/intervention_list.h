// The last interventions as cards, newest first, as many as there is room for, and the one-touch judgement of the
// newest.
#pragma once

#include <QWidget>
#include <vector>

#include "core/model/operator_input.h"
#include "ui/base/themed.h"
#include "ui/models/strip_view.h"

namespace stillcut::ui {

class InterventionCard;
class TouchButton;

class InterventionList : public QWidget, public Themed {
  Q_OBJECT
 public:
  explicit InterventionList(QWidget* parent = nullptr);

  // `live`: samples come in. `alarming`: an alarm is on right now, which can be judged before there is a card.
  // `answerable`: neither of a replay nor of a run that is over, whose recording is closed.
  void display(const std::vector<CardView>& cards, const NewestAlarm& newest, const EventLine& event, bool live,
               bool alarming, bool answerable = true);
  int shownCards() const;
  bool clipped() const override { return clipped_; }

  void applyTheme(const Theme& theme) override;
  QSize minimumSizeHint() const override;
  QSize sizeHint() const override;

 signals:
  void asked(const stillcut::OperatorInput& input);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void judge(AlarmJudgement touched);
  void hear();
  void showJudgement();
  void place();
  bool faulty() const { return event_.tone == Tone::Chatter; }
  void paintFault(QPainter& p, const QRectF& box);

  Theme theme_;
  std::vector<CardView> cards_;
  NewestAlarm newest_;
  EventLine event_;
  std::vector<InterventionCard*> widgets_;
  TouchButton* wasTrue_;
  TouchButton* wasFalse_;
  TouchButton* hear_;  // chatter that nobody told of
  bool live_ = false;
  bool alarming_ = false, answerable_ = true;
  bool clipped_ = false;
  bool heard_ = false;
};

}  // namespace stillcut::ui
