// The page for the engineer at the desk: spectrogram, signal and detectors over one axis of time, and the spectrum of
// any moment of it. GUI thread.
#pragma once

#include "ui/base/units.h"
#include "ui/models/history/analyse_view.h"
#include "ui/models/tune/preset_list.h"
#include "ui/pages/page.h"

class QGridLayout;
class QStackedWidget;

namespace stillcut::ui {

class AnalyseTools;
class EventPanel;
class HistoryMap;
class MachinePlot;
class Panel;
class PresetBar;
class SpectrumPlot;
class TracePlot;
class TrackPlot;

class AnalysePage : public Page {
  Q_OBJECT
 public:
  explicit AnalysePage(QWidget* parent = nullptr);

  void see(const Picture& picture) override;
  void display(const Picture& picture) override;
  void restart() override;
  void keep(QSettings& settings) const override;
  void restore(const QSettings& settings) override;
  void applyTheme(const Theme& theme) override;

  AnalyseView& view() { return view_; }
  PresetList& presets() { return presets_; }

 signals:
  // The channel that spectrogram and spectrum shall be made of from now on.
  void channelAsked(int channel);

 private:
  Panel* panel(QWidget* inside);
  void showEvents(const Picture& picture);

  AnalyseView view_;
  PresetList presets_;
  AnalyseOptions told_;  // of view_, as last said to be worth keeping
  AnalyseTools* tools_;
  HistoryMap* map_;
  TracePlot* trace_;
  TrackPlot* tracks_;
  MachinePlot* machine_;
  EventPanel* events_;
  QStackedWidget *traces_, *beside_;  // signal or machine; spectrum or events
  SpectrumPlot* spectrum_;
  PresetBar* bar_;
  QGridLayout* grid_;
  int channel_ = -1;
  std::uint64_t eventsShown_ = 0;  // version of the log
  UnitSystem eventUnits_ = UnitSystem::Metric;
};

}  // namespace stillcut::ui
