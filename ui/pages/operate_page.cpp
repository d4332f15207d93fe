#include "ui/pages/operate_page.h"

#include <QGridLayout>
#include <QVBoxLayout>

#include "ui/base/format.h"
#include "ui/models/named_chatter.h"
#include "ui/pages/intervention_list.h"
#include "ui/plots/spectrogram/spectrogram_widget.h"
#include "ui/widgets/advice_panel.h"
#include "ui/widgets/limit_bar.h"
#include "ui/widgets/override_table.h"
#include "ui/widgets/panel.h"
#include "ui/widgets/verdict_sign.h"

namespace stillcut::ui {
namespace {

Tone alarmTone(const Picture& picture) {
  const Verdict& verdict = picture.verdict();
  if (!verdict.alarming()) return Tone::Normal;
  return verdict.state == CutState::Chatter ? Tone::Chatter : Tone::Onset;
}

}  // namespace

OperatePage::OperatePage(QWidget* parent)
    : Page(parent),
      verdict_(new VerdictSign),
      advice_(new AdvicePanel),
      spectrogram_(new SpectrogramWidget),
      spectrogramPanel_(new Panel),
      barsPanel_(new Panel),
      machinePanel_(new Panel),
      overrides_(new OverrideTable),
      interventions_(new InterventionList),
      grid_(new QGridLayout(this)),
      barsLayout_(new QVBoxLayout(barsPanel_)),
      theme_(makeTheme(ThemeKind::Light, 1.0)) {
  auto* left = new QVBoxLayout;
  left->addWidget(verdict_, 5);
  left->addWidget(advice_, 5);
  auto* right = new QVBoxLayout;
  auto* spectrogramLayout = new QVBoxLayout(spectrogramPanel_);
  spectrogramLayout->setContentsMargins(0, 0, 0, 0);
  spectrogramLayout->addWidget(spectrogram_);
  auto* machineLayout = new QVBoxLayout(machinePanel_);
  machineLayout->addWidget(overrides_);
  right->addWidget(spectrogramPanel_, 1);
  right->addWidget(barsPanel_);
  right->addWidget(machinePanel_);
  right->addWidget(interventions_);
  grid_->addLayout(left, 0, 0);
  grid_->addLayout(right, 0, 1);
  grid_->setColumnStretch(0, 44);
  grid_->setColumnStretch(1, 56);
  space(theme_);

  connect(advice_, &AdvicePanel::accepted, this, [this] {
    emit asked({OperatorAction::Accept, Authority::Off, adviceShown_});
  });
  connect(advice_, &AdvicePanel::againAsked, this, &OperatePage::againAsked);
  connect(advice_, &AdvicePanel::refused, this, [this] { emit asked({OperatorAction::Refuse, Authority::Off}); });
  connect(interventions_, &InterventionList::asked, this, &OperatePage::asked);
}

void OperatePage::see(const Picture& picture) {
  if (!picture.snapshot) return;
  trend_.add(picture.verdict());
  moveReason_.see(*picture.snapshot);
  spectrogram_->setSpectrumTop(picture.snapshot->spectrumTop);
  columns_.read(*picture.snapshot,
                [&](const SpectrumColumn& column) { spectrogram_->append(column, alarmTone(picture)); });
}

void OperatePage::restart() {
  columns_ = {};
  trend_ = {};
  moveReason_ = {};
  vibrationScale_ = {};
  spectrogram_->clear();
}

void OperatePage::display(const Picture& picture) {
  if (picture.snapshot) adviceShown_ = picture.snapshot->adviceNumber;
  verdict_->display(makeVerdictView(picture, trend_.trend()));
  advice_->display(makeAdviceView(picture, moveReason_.reason(), moveReason_.target()));
  overrides_->display(makeMachineView(picture));
  const bool live = picture.snapshot && !picture.stale && !picture.over() && picture.snapshot->running;
  const bool alarming = live && picture.verdict().alarming();
  interventions_->display(makeCards(picture), makeNewestAlarm(picture), makeEventLine(picture), live, alarming,
                          !picture.replay && !picture.over());
  showBars(picture);
  showSpectrogram(picture);
}

void OperatePage::showSpectrogram(const Picture& picture) {
  const CutSetup& setup = picture.info->setup;
  const std::uint64_t columns = picture.snapshot ? picture.snapshot->columnCount : 0;
  const int channel = columns > 0 ? picture.snapshot->columns[(columns - 1) % kSpectrumColumns].channel : 0;
  const bool named = channel < static_cast<int>(setup.channels.size());
  const ChannelInfo of = named ? setup.channels[static_cast<std::size_t>(channel)] : ChannelInfo{};
  const std::string_view si = named ? siUnit(of.quantity) : std::string_view();
  const QString name = named ? QString::fromStdString(of.name) : number(channel + 1);
  const QLatin1String prefix("channel ");  // a file without names counts them
  spectrogram_->setSignal(tr("channel %1").arg(name.startsWith(prefix) ? name.mid(prefix.size()) : name),
                          QString::fromUtf8(si.data(), static_cast<qsizetype>(si.size())), setup.teeth);
  spectrogram_->setPlotState(picture.plotState());
  spectrogram_->setClock(picture.info->wallMsAtStreamZero);
  if (!picture.snapshot) return;
  const Verdict& verdict = picture.verdict();
  const Tone alarm = alarmTone(picture);
  const bool marked = alarm != Tone::Normal && verdict.frequency.value > 0;
  const Hertz shown = namedChatter(*picture.snapshot, verdict.frequency, verdict.frequencySd);
  spectrogram_->setChatter(marked ? shown : Hertz(),
                           marked ? join(number(shown.value), QStringLiteral("Hz")) : QString(), alarm);
}

void OperatePage::showBars(const Picture& picture) {
  const std::vector<BarView> views = makeBars(picture, vibrationScale_);
  while (bars_.size() < views.size()) {
    auto* bar = new LimitBar;
    bar->applyTheme(theme_);
    barsLayout_->addWidget(bar);
    bar->show();
    bars_.push_back(bar);
  }
  for (std::size_t k = 0; k < views.size(); ++k) bars_[k]->display(views[k]);
}

void OperatePage::applyTheme(const Theme& theme) {
  theme_ = theme;
  space(theme);
}

void OperatePage::space(const Theme& theme) {
  const int margin = theme.px(16), gap = theme.px(10);
  grid_->setContentsMargins(margin, gap, margin, gap);
  grid_->setHorizontalSpacing(gap);
  for (int column = 0; column < 2; ++column) grid_->itemAtPosition(0, column)->layout()->setSpacing(gap);
  barsLayout_->setContentsMargins(margin, theme.px(6), margin, theme.px(6));
  barsLayout_->setSpacing(0);
  machinePanel_->layout()->setContentsMargins(margin, theme.px(4), margin, theme.px(4));
}

}  // namespace stillcut::ui
