// The level of the first channel and its newest spectrum, small: enough to see that a sensor lives. GUI thread.
#pragma once

#include <QWidget>
#include <array>

#include "ui/base/themed.h"
#include "ui/facade/session_info.h"

namespace stillcut::ui {

class LevelSpectrum : public QWidget, public Themed {
  Q_OBJECT
 public:
  explicit LevelSpectrum(QWidget* parent = nullptr);

  void display(const Picture& picture);
  bool alive() const { return alive_; }

  void applyTheme(const Theme& theme) override;
  QSize sizeHint() const override { return {theme_.px(360), theme_.px(260)}; }
  QSize minimumSizeHint() const override { return {theme_.px(200), theme_.px(120)}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Theme theme_;
  std::array<float, kSpectrumBins> level_{};
  double top_hz_ = 0.0;
  bool alive_ = false;
};

}  // namespace stillcut::ui
