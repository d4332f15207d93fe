// A button for gloves: at least 12 mm high, one or two words, its key underneath. Colour only where it means something.
#pragma once

#include <QAbstractButton>

#include "ui/base/themed.h"

namespace stillcut::ui {

class TouchButton : public QAbstractButton, public Themed {
  Q_OBJECT
 public:
  enum class Look { Plain, Advice, Tab };

  explicit TouchButton(const QString& caption, Look look = Look::Plain, QWidget* parent = nullptr);

  // The small line under the caption; an action's key.
  void setHint(const QString& hint);
  QString hint() const { return hint_; }
  // Key that clicks the button from anywhere in the window, shown as its hint.
  void setKey(const QKeySequence& key);
  // Amber, with another caption and hint: asks for a second touch.
  void setAsking(bool asking, const QString& caption = {}, const QString& hint = {});
  bool asking() const { return asking_; }
  // The tone a checked button has.
  void setCheckedTone(Tone tone);
  void setBaseHeight(double base);
  // A caption of several words may take two lines, in a smaller type.
  void setTwoLines(bool on);
  bool clipped() const override { return clipped_; }

  void applyTheme(const Theme& theme) override;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Paint {
    QColor back, front, border;
  };
  Paint paint() const;
  double captionWidth() const;

  Theme theme_;
  Look look_;
  QString hint_, askCaption_, askHint_;
  Tone checkedTone_ = Tone::Normal;
  double baseHeight_ = 58;
  bool asking_ = false;
  bool twoLines_ = false;
  bool clipped_ = false;
};

}  // namespace stillcut::ui
