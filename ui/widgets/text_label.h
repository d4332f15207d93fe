// Wrapped or one-line text in a size and a tone of the theme. GUI thread.
#pragma once

#include <QLabel>

#include "ui/base/themed.h"

namespace stillcut::ui {

class TextLabel : public QLabel, public Themed {
  Q_OBJECT
 public:
  struct Look {
    double size = type_size::kBody;
    bool bold = false;
    bool secondary = false;
    bool wrap = false;
  };
  explicit TextLabel(const Look& look, const QString& text = {}, QWidget* parent = nullptr);

  void setTone(Tone tone);
  void applyTheme(const Theme& theme) override;

 private:
  void paintText();

  Theme theme_;
  Look look_;
  Tone tone_ = Tone::Normal;
};

}  // namespace stillcut::ui
