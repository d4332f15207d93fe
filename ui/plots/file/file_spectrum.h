// Spectra of a recording: at cursor A, else the mean of the stretch on show; that of the second recording over it as a
// dashed line. Tooth passing as ticks, chatter as one labelled mark, its family as dashes, and a harmonic cursor, which
// a click puts. The wheel zooms, a drag moves, H puts the cursor on the strongest line, Delete takes it away.
// GUI thread.
#pragma once

#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "ui/base/themed.h"
#include "ui/facade/file_controller.h"
#include "ui/models/file/file_look.h"
#include "ui/models/history/analyse_view.h"

namespace stillcut::ui {

class FileSpectrum : public QWidget, public Themed {
  Q_OBJECT
 public:
  // The view outlives it.
  explicit FileSpectrum(AnalyseView& view, QWidget* parent = nullptr);

  struct Shown {
    std::shared_ptr<const Spectra> main, beside;
    FileLook look;
    FileMarks marks;
    QString unit;
    QString name, besideName;  // of the files, where there are two
  };
  void display(const Shown& shown);
  // What the harmonic cursor reads; empty: there is none.
  QString reading() const;

  void applyTheme(const Theme& theme) override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  struct Curve {
    double binWidth = 0.0;
    std::vector<float> level_dB;  // empty: nothing to see
  };
  Curve curveOf(const Spectra* spectra) const;
  void refresh();
  QRect plotRect() const;
  FrequencyScale scale() const;
  double xOf(double hertz) const;
  double frequencyAt(double x) const;
  void moveBy(double right);
  void drawCurve(QPainter& p, const Curve& curve, const QPen& pen) const;
  void drawNames(QPainter& p, const QRect& line) const;
  void drawMarks(QPainter& p) const;

  AnalyseView& view_;
  Shown shown_;
  Curve main_, beside_;
  Theme theme_;
  double low_dB_ = -80.0, high_dB_ = 0.0;
  std::optional<QPointF> pressed_;
  QPointF last_;
  bool dragged_ = false;
};

}  // namespace stillcut::ui
