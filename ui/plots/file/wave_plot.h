// The samples of one channel of a whole recording, and of a second recording under them: what is shown of many samples
// comes from the pyramid, of few from the samples themselves. What was not measured is shaded. GUI thread.
#pragma once

#include <memory>
#include <optional>

#include "ui/facade/file_controller.h"
#include "ui/plots/time_plot.h"

namespace stillcut::ui {

class WavePlot : public TimePlot {
  Q_OBJECT
 public:
  explicit WavePlot(AnalyseView& view, QWidget* parent = nullptr);

  struct Shown {
    std::shared_ptr<const FileContents> file;
    std::shared_ptr<const Spectra> spectra;  // has the samples of a short stretch
    int channel = 0;
  };
  void display(const Shown& main, const Shown& beside);
  // Where the sound is; empty: nothing is played.
  void setHeard(std::optional<Seconds> heard);

  QSize minimumSizeHint() const override;

 protected:
  void drawPlot(QPainter& p, const QRect& plot) override;

 private:
  void drawWave(QPainter& p, const QRect& box, const Shown& shown) const;

  Shown main_, beside_;
  std::optional<Seconds> heard_;
};

}  // namespace stillcut::ui
