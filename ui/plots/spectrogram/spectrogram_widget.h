// The live spectrogram: the last ten seconds, tooth-passing harmonics as ticks, chatter as one labelled mark, gaps
// hatched. Keys: X changes the axis (Hz, order of the spindle, rpm per tooth), Page Up and Page Down, or two
// fingers, its reach.
#pragma once

#include <QWidget>
#include <optional>

#include "ui/base/theme.h"
#include "ui/base/themed.h"
#include "ui/facade/session_info.h"
#include "ui/plots/spectrogram/spectrogram_image.h"

namespace stillcut::ui {

class SpectrogramWidget : public QWidget, public Themed {
  Q_OBJECT
 public:
  enum class Axis { Hertz, Order, Rpm };

  explicit SpectrogramWidget(QWidget* parent = nullptr);

  // GUI thread. Teeth 0: no ticks. `signal` names the channel, `unit` its SI unit.
  void setSignal(const QString& signal, const QString& unit, int teeth);
  void setSpectrumTop(Hertz top);
  // `alarm`: Onset or Chatter when the verdict was that, else Normal.
  void append(const SpectrumColumn& column, Tone alarm);
  // The newest chatter frequency with its label; 0: no mark.
  void setChatter(Hertz frequency, const QString& label, Tone tone);
  void setPlotState(PlotState plotState);
  // The clock on the wall at stream time 0, ms since 1970: the times below are the clock's then.
  void setClock(qint64 wallMsAtStreamZero) { wallMsAtStreamZero_ = wallMsAtStreamZero; }
  void clear();

  Axis axis() const { return axis_; }
  void setAxis(Axis axis);
  Hertz visibleTop() const;
  const SpectrogramImage& picture() const { return image_; }

  void applyTheme(const Theme& theme) override;
  QSize minimumSizeHint() const override;
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QRect plotRect() const;
  double yOf(Hertz f) const;
  double unitsPerHertz() const;
  void updateImage();
  void reach(Hertz top);
  void drawHeader(QPainter& p, const QRect& plot) const;
  void drawColumns(QPainter& p, const QRect& plot) const;
  void drawGaps(QPainter& p, const QRect& plot) const;
  void drawAxes(QPainter& p, const QRect& plot) const;
  void drawTimes(QPainter& p, const QRect& plot) const;
  void drawTeeth(QPainter& p, const QRect& plot) const;
  void drawChatter(QPainter& p, const QRect& plot) const;

  Theme theme_;
  SpectrogramImage image_;
  QString signal_, unit_, chatterLabel_;
  int teeth_ = 0;
  Hertz top_{}, wantedTop_, spindle_{}, chatter_{};
  std::optional<qint64> wallMsAtStreamZero_;
  Instant newest_{};
  Axis axis_ = Axis::Hertz;
  Tone chatterTone_ = Tone::Normal;
  PlotState plotState_ = PlotState::Moves;
};

}  // namespace stillcut::ui
