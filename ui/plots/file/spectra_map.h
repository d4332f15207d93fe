// The spectrogram of a recording: any stretch of it, on a linear or logarithmic axis of frequency, in hertz or orders.
// Tooth passing stands as ticks at the right edge, chatter as a labelled line, the rest of its family as dashes.
// Frequencies zoom with Ctrl and the wheel. GUI thread.
#pragma once

#include <QImage>
#include <memory>

#include "ui/facade/file_controller.h"
#include "ui/models/file/file_look.h"
#include "ui/plots/time_plot.h"

namespace stillcut::ui {

class SpectraMap : public TimePlot {
  Q_OBJECT
 public:
  explicit SpectraMap(AnalyseView& view, QWidget* parent = nullptr);

  // `unit`: of the signal.
  void display(std::shared_ptr<const Spectra> spectra, const FileLook& look, const FileMarks& marks,
               const QString& unit);
  // Ends of the palette [dB].
  double lowest() const { return low_dB_; }
  double highest() const { return high_dB_; }

  QSize minimumSizeHint() const override;

 protected:
  void drawPlot(QPainter& p, const QRect& plot) override;
  void panUp(double share) override;
  void zoomUp(double factor, double y) override;

 private:
  struct Drawn {  // what the image shows
    const Spectra* spectra = nullptr;
    Instant from{};
    Seconds span{};
    Hertz low{}, high{};
    bool log = false;
    QSize size;
    QRgb gap = 0;
    bool operator==(const Drawn&) const = default;
  };
  FrequencyScale scale() const;
  void fitLevels();
  void paintImage(const Drawn& wanted);
  void drawMarks(QPainter& p, const QRect& plot) const;

  std::shared_ptr<const Spectra> spectra_;
  FileLook look_;
  FileMarks marks_;
  QString unit_;
  SpectraRequest fitted_;  // for which the palette was laid out
  double low_dB_ = -80.0, high_dB_ = 0.0;
  Drawn drawn_;
  QImage image_;
};

}  // namespace stillcut::ui
