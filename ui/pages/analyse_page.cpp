#include "ui/pages/analyse_page.h"

#include <QGridLayout>
#include <QSettings>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <initializer_list>
#include <utility>
#include <vector>

#include "ui/base/say.h"
#include "ui/models/history/run_history.h"
#include "ui/models/history/signal_history.h"
#include "ui/models/history/spectrum_view.h"
#include "ui/models/live_numbers.h"
#include "ui/pages/analyse_tools.h"
#include "ui/pages/event_panel.h"
#include "ui/pages/preset_bar.h"
#include "ui/plots/machine_plot.h"
#include "ui/plots/spectrogram/history_map.h"
#include "ui/plots/spectrum_plot.h"
#include "ui/plots/trace_plot.h"
#include "ui/plots/track_plot.h"
#include "ui/widgets/panel.h"

namespace stillcut::ui {
namespace {

QString nowKey() {
  return QStringLiteral("now");  // the name under which what is on show is kept; no preset can have it: names are shown
}

QStringList channelNames(const CutSetup& setup) {
  QStringList names;
  for (const ChannelInfo& channel : setup.channels) names << QString::fromStdString(channel.name);
  return names;
}

}  // namespace

AnalysePage::AnalysePage(QWidget* parent)
    : Page(parent),
      tools_(new AnalyseTools(view_)),
      map_(new HistoryMap(view_)),
      trace_(new TracePlot(view_)),
      tracks_(new TrackPlot(view_)),
      machine_(new MachinePlot(view_)),
      events_(new EventPanel(QStringLiteral("analyse-events"))),
      traces_(new QStackedWidget),
      beside_(new QStackedWidget),
      spectrum_(new SpectrumPlot(view_)),
      bar_(new PresetBar(view_, presets_)),
      grid_(new QGridLayout(this)) {
  map_->setTimesShown(false);
  trace_->setTimesShown(false);
  machine_->setTimesShown(false);
  traces_->addWidget(trace_);
  traces_->addWidget(machine_);
  beside_->addWidget(spectrum_);
  beside_->addWidget(events_);
  grid_->addWidget(tools_, 0, 0, 1, 2);
  grid_->addWidget(panel(map_), 1, 0);
  grid_->addWidget(panel(traces_), 2, 0);
  grid_->addWidget(panel(tracks_), 3, 0, 2, 1);
  grid_->addWidget(panel(beside_), 1, 1, 3, 1);
  grid_->addWidget(panel(bar_), 4, 1);
  grid_->setColumnStretch(0, 62);
  grid_->setColumnStretch(1, 38);
  grid_->setRowStretch(1, 50);
  grid_->setRowStretch(2, 22);
  grid_->setRowStretch(3, 14);
  grid_->setRowStretch(4, 14);
  connect(events_, &EventPanel::wentTo, this, [this](Instant t) {
    view_.goTo(t);
    view_.setCursor(AnalyseView::A, t);
  });
  connect(events_, &EventPanel::judged, this, &Page::asked);
  connect(&view_, &AnalyseView::changed, this, [this] {
    if (view_.options() == told_) return;
    told_ = view_.options();
    emit stateChanged();
  });
  for (const auto signal : {&PresetList::rowsInserted, &PresetList::rowsRemoved}) {
    connect(&presets_, signal, this, &Page::stateChanged);
  }
  connect(&presets_, &PresetList::dataChanged, this, &Page::stateChanged);
  connect(tools_, &AnalyseTools::fileAsked, this, [this] { emit fileAsked({}); });
  connect(tools_, &AnalyseTools::referenceAsked, this, [this] {
    spectrum_->toggleReference();
    tools_->setReference(spectrum_->hasReference());
  });
}

Panel* AnalysePage::panel(QWidget* inside) {
  auto* around = new Panel;
  auto* layout = new QVBoxLayout(around);
  layout->setContentsMargins(4, 4, 4, 4);  // the round corners are the panel's
  layout->addWidget(inside);
  return around;
}

void AnalysePage::see(const Picture& picture) {
  const int channels = static_cast<int>(picture.info->setup.channels.size());
  std::vector<double> limits;
  for (const DetectorLabel& detector : picture.info->detectors) {
    limits.push_back(limitOfIndicator(detector.indicators.value(0), picture.info->limits));
  }
  if (picture.history != nullptr) tracks_->seeLimits(picture.history->end(), limits);
  const int wanted = std::min(view_.options().channel, std::max(channels - 1, 0));
  if (wanted == channel_) return;
  channel_ = wanted;
  emit channelAsked(wanted);
}

void AnalysePage::display(const Picture& picture) {
  const RunHistory& history = *picture.history;
  const SessionInfo& info = *picture.info;
  // What happened is kept for longer than the plots are.
  const auto& log = history.log().events();
  const bool further = view_.options().events && !log.empty();
  view_.setReach(further ? std::min(history.begin(), log.front().time) : history.begin(), history.end(),
                 history.spectrumTop());
  tools_->setChannels(channelNames(info.setup));
  bar_->display(info);
  std::vector<TrackPlot::Row> rows;
  for (const DetectorLabel& detector : info.detectors) {
    rows.push_back(
        {sayCore(detector.label.toStdString()), limitOfIndicator(detector.indicators.value(0), info.limits)});
  }
  const QString unit = channelUnit(info.setup, channel_);
  map_->display(&history, info.setup.teeth, unit);
  trace_->display(picture.signal, unit);
  tracks_->display(&history, std::move(rows), picture.snapshot ? picture.snapshot->inCharge : 0);
  showEvents(picture);
  spectrum_->display(makeSpectrumView(history, view_, info));
  const PlotState plotState = view_.following() ? picture.plotState() : PlotState::Moves;
  spectrum_->setPlotState(plotState);
  for (TimePlot* plot : std::initializer_list<TimePlot*>{map_, trace_, tracks_, machine_}) {
    plot->setPlotState(plotState);
    plot->setClock([&info](Instant t) { return info.wallMs(t); });
  }
}

// The list is written anew where there is more to read.
void AnalysePage::showEvents(const Picture& picture) {
  const bool events = view_.options().events;
  traces_->setCurrentWidget(events ? static_cast<QWidget*>(machine_) : trace_);
  beside_->setCurrentWidget(events ? static_cast<QWidget*>(events_) : spectrum_);
  if (!events) return;
  const EventLog& log = picture.history->log();
  machine_->display(&log.machine(), picture.history->end(), picture.units);
  events_->setJudging(!picture.over());
  // In a replay there is nothing to judge.
  const AlarmMarks* marks = picture.replay ? nullptr : &picture.history->marks();
  const std::uint64_t version = log.version() + (marks != nullptr ? marks->version() : 0);  // both only grow
  if (version == eventsShown_ && picture.units == eventUnits_) return;
  eventsShown_ = version;
  eventUnits_ = picture.units;
  const std::vector<RunEvent> all(log.events().begin(), log.events().end());
  events_->display(
      all, [&info = *picture.info](Instant t) { return info.wallMs(t); }, picture.units, marks);
}

void AnalysePage::restart() {
  machine_->display(nullptr, {}, eventUnits_);
  events_->display({}, {}, eventUnits_);
  eventsShown_ = 0;
  view_.restart();
  map_->restart();
  trace_->display(nullptr, {});
  tracks_->restart();
  spectrum_->display({});
  channel_ = -1;
}

void AnalysePage::keep(QSettings& settings) const {
  presets_.keep(settings);
  settings.setValue(nowKey(), toVariant(view_.options()));
}

void AnalysePage::restore(const QSettings& settings) {
  presets_.restore(settings);
  if (const auto options = analyseOptionsFrom(settings.value(nowKey()).toMap())) view_.setOptions(*options);
}

void AnalysePage::applyTheme(const Theme& theme) {
  const int margin = theme.px(16), gap = theme.px(10);
  grid_->setContentsMargins(margin, gap, margin, gap);
  grid_->setSpacing(gap);
}

}  // namespace stillcut::ui
