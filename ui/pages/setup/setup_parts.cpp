#include "ui/pages/setup/setup_parts.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QScrollArea>
#include <QStyledItemDelegate>
#include <QTableView>
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/base/format.h"
#include "ui/base/say.h"
#include "ui/base/typed_number.h"
#include "ui/models/plain_words.h"
#include "ui/models/sensor_view.h"
#include "ui/pages/choose_files.h"
#include "ui/pages/setup/setup_finder.h"
#include "ui/pages/setup/setup_sensor_trial.h"
#include "ui/plots/level_spectrum.h"
#include "ui/widgets/painting.h"
#include "ui/widgets/settings_form.h"
#include "ui/widgets/text_label.h"
#include "ui/widgets/touch_button.h"

namespace stillcut::ui {
namespace {

QString described(const std::vector<ComponentOption>& options, const std::string& id) {
  for (const ComponentOption& option : options) {
    if (option.id.toStdString() == id) return sayCore(option.description.toStdString());
  }
  return {};
}

QScrollArea* scrolled(QWidget* content) {
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFocusPolicy(Qt::NoFocus);
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(content);
  column->addStretch(1);
  scroll->setWidget(box);
  return scroll;
}

QStringList clockLines(const std::vector<JoinedClock>& clocks) {
  QStringList lines;
  for (const JoinedClock& clock : clocks) {
    lines << say("Joined device, %1 channels: %2 by this computer's clock, times steady within %3 µs, beside any "
                 "constant delay of its wire")
                 .arg(clock.channels)
                 .arg(frequency(clock.rate, Hertz(clock.rate.value * 1e-5)), significant(1e6 * clock.residual.value));
  }
  return lines;
}

bool isThat(const FoundDevice& device, const config::ComponentChoice& source) {
  return device.source.id == source.id && source.settings.contains("device") &&
         source.settings.at("device") == device.source.settings.at("device");
}

constexpr std::array kQuantities{SensorQuantity::Acceleration, SensorQuantity::Velocity, SensorQuantity::Displacement,
                                 SensorQuantity::Sound,        SensorQuantity::Force,    SensorQuantity::Current,
                                 SensorQuantity::SpindleSpeed};

// Quantities are chosen, not typed.
class QuantityDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex&) const override {
    auto* box = new QComboBox(parent);
    box->setObjectName(QStringLiteral("channel-quantity"));
    box->setFont(parent->font());
    box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    for (const SensorQuantity quantity : kQuantities) {
      const std::string id(name(quantity));
      box->addItem(sayCore(id), QString::fromStdString(id));
    }
    connect(box, &QComboBox::activated, this, [this, box] {
      emit const_cast<QuantityDelegate*>(this)->commitData(box);
      emit const_cast<QuantityDelegate*>(this)->closeEditor(box);
    });
    return box;
  }
  void setEditorData(QWidget* editor, const QModelIndex& index) const override {
    auto* box = qobject_cast<QComboBox*>(editor);
    box->setCurrentIndex(std::max(box->findData(index.data(Qt::EditRole)), 0));
  }
  void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override {
    model->setData(index, qobject_cast<QComboBox*>(editor)->currentData(), Qt::EditRole);
  }
  void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option, const QModelIndex&) const override {
    QRect place = option.rect;
    constexpr int kAir = 12;
    place.setWidth(std::max(place.width(), editor->sizeHint().width() + kAir));
    editor->setGeometry(place);
  }
};

double typed(const QLineEdit* edit) {
  QString text = edit->text();
  text.replace(u',', u'.').remove(kThousandsSpace);
  bool isNumber = false;
  const double value = text.toDouble(&isNumber);
  return isNumber && std::isfinite(value) && value > 0.0 ? value : 0.0;
}

}  // namespace

SetupMachine::SetupMachine(SetupController& controller, SetupDraft& draft, QWidget* parent)
    : SetupTab(controller, draft, parent),
      about_(new TextLabel({type_size::kBody, false, true, true})),
      form_(new SettingsForm),
      name_(makeEdit(tr("Name of the machine"), QStringLiteral("machine-name"))),
      speed_(makeEdit(tr("Programmed speed in rpm"), QStringLiteral("machine-speed"))),
      feed_(makeEdit(tr("Programmed feed"), QStringLiteral("machine-feed"))),
      depth_(makeEdit(tr("Depth of cut"), QStringLiteral("machine-depth"))),
      feedLabel_(new TextLabel({type_size::kBody})),
      depthLabel_(new TextLabel({type_size::kBody})),
      problem_(new TextLabel({type_size::kBody, false, false, true})),
      finder_(new SetupFinder(controller, draft)),
      allowAuto_(makeButton(tr("AUTO MAY BE CHOSEN"), tr("Auto may be chosen on this machine"),
                            QStringLiteral("machine-auto"))) {
  auto* whole = new QVBoxLayout(this);
  auto* columns = new QHBoxLayout;
  auto* column = new QVBoxLayout;
  auto* names = new QHBoxLayout;
  names->addWidget(new TextLabel({type_size::kBody}, tr("Machine")));
  names->addWidget(name_, 2);
  names->addWidget(new TextLabel({type_size::kBody}, tr("Speed, rpm")));
  names->addWidget(speed_, 1);
  names->addWidget(feedLabel_);
  names->addWidget(feed_, 1);
  names->addWidget(depthLabel_);
  names->addWidget(depth_, 1);
  depth_->setPlaceholderText(QStringLiteral("\u2013"));  // not known; a word does not fit
  whole->addLayout(names);
  problem_->setTone(Tone::Onset);
  problem_->hide();
  whole->addWidget(problem_);
  whole->addLayout(columns, 1);
  columns->addLayout(column, 55);
  columns->addWidget(finder_, 45);
  column->addWidget(new TextLabel({type_size::kLabel, true, true}, tr("LINK TO THE CONTROL")));
  auto* choices = new QGridLayout;
  constexpr int kInARow = 3;
  for (const ComponentOption& option : controller.links()) {
    TouchButton* button =
        makeButton(option.id.toUpper(), sayCore(option.description.toStdString()), QStringLiteral("link-") + option.id);
    button->setCheckable(true);
    const int place = static_cast<int>(links_.size());
    links_.push_back(button);
    choices->addWidget(button, place / kInARow, place % kInARow);
    connect(button, &TouchButton::clicked, this, [this, id = option.id] {
      // A second touch takes it back: the program then only watches.
      const bool again = draft_.profile().link.id == id.toStdString();
      draft_.setLink(again ? QString() : id);
      refresh();
    });
  }
  choices->setColumnStretch(kInARow, 1);
  column->addLayout(choices);
  column->addWidget(about_);
  column->addWidget(scrolled(form_), 1);
  allowAuto_->setCheckable(true);
  column->addWidget(allowAuto_, 0, Qt::AlignLeft);
  connect(form_, &SettingsForm::edited, &draft, &SetupDraft::setLinkSetting);
  connect(name_, &QLineEdit::editingFinished, this,
          [this] { draft_.edit([this](config::Profile& p) { p.cut.machine = name_->text().toStdString(); }); });
  connect(speed_, &QLineEdit::editingFinished, this, [this] {
    draft_.edit([this](config::Profile& p) { p.cut.nominalSpeed = Rpm(std::max(typedSpeed(speed_->text()), 0.0)); });
  });
  connect(feed_, &QLineEdit::editingFinished, this, [this] {
    if (!feed_->isModified()) return;  // what is shown is rounded
    draft_.edit([this](config::Profile& p) {
      p.cut.nominalFeed = feedFrom(std::max(typedSpeed(feed_->text()), 0.0), draft_.units());
    });
    feed_->setModified(false);
  });
  connect(depth_, &QLineEdit::editingFinished, this, &SetupMachine::takeDepth);
  connect(allowAuto_, &TouchButton::clicked, this,
          [this] { draft_.edit([this](config::Profile& p) { p.allowAuto = allowAuto_->isChecked(); }); });
  refresh();
}

// An empty field: the depth is not known.
void SetupMachine::takeDepth() {
  if (!depth_->isModified()) return;  // what is shown is rounded
  const UnitSystem units = draft_.units();
  const Metres depth = lengthFrom(typed(depth_), units);
  const bool none = depth_->text().trimmed().isEmpty();
  const bool legal = none || (depth >= kShallowestCut && depth <= kDeepestCut);
  problem_->setVisible(!legal);
  problem_->setText(legal ? QString()
                          : tr("The depth was not taken: it must be a number from %1 to %2, or nothing where it is not "
                               "known")
                                .arg(depthText(kShallowestCut, units), depthText(kDeepestCut, units)));
  if (!legal) return;
  depth_->setModified(false);
  draft_.edit([&](config::Profile& p) { p.depth = none ? Metres() : depth; });
}

void SetupMachine::refresh() {
  const config::Profile& profile = draft_.profile();
  for (TouchButton* button : links_) {
    button->setChecked(button->objectName() == QStringLiteral("link-") + QString::fromStdString(profile.link.id));
  }
  about_->setText(profile.link.id.empty() ? draft_.missing(SetupDraft::Part::Machine)
                                          : withoutKeys(described(controller_.links(), profile.link.id)));
  form_->show(controller_.linkSettings(profile), profile.link.settings, QStringLiteral("link-setting-"));
  finder_->refresh();
  allowAuto_->setChecked(profile.allowAuto);
  const auto put = [](QLineEdit* edit, const QString& text) {
    if (!edit->hasFocus()) edit->setText(text);
  };
  put(name_, QString::fromStdString(profile.cut.machine));
  put(speed_, profile.cut.nominalSpeed.value > 0.0 ? number(profile.cut.nominalSpeed.value) : QString());
  const UnitSystem units = draft_.units();
  const QString feed = number(feedIn(profile.cut.nominalFeed, units), units == UnitSystem::Inch ? 1 : 0);
  put(feed_, profile.cut.nominalFeed.value > 0.0 ? feed : QString());
  feedLabel_->setText(tr("Feed, %1").arg(feedUnit(units)));
  feed_->setAccessibleName(tr("Programmed feed in %1").arg(feedUnit(units)));
  const QString depth = QString::number(lengthIn(profile.depth, units), 'g', 5);
  if (!depth_->isModified()) depth_->setText(profile.depth.value > 0.0 ? depth : QString());
  depthLabel_->setText(tr("Depth, %1").arg(lengthUnit(units)));
  depth_->setAccessibleName(tr("Depth of cut in %1").arg(lengthUnit(units)));
  depth_->setToolTip(tr("Deepest cut of the programme, %1 to %2; the Lobes page shows the cut at this depth")
                         .arg(depthText(kShallowestCut, units), depthText(kDeepestCut, units)));
}

SetupSensors::SetupSensors(SetupController& controller, SetupDraft& draft, QWidget* parent)
    : SetupTab(controller, draft, parent),
      heading_(new TextLabel({type_size::kLabel, true, true}, tr("DEVICE"))),
      foundRows_(new QVBoxLayout),
      none_(new TextLabel({type_size::kBody, false, false, true},
                          tr("Nothing is plugged in that could be heard. Plug in a microphone or a sensor: it shows "
                             "here by its name."))),
      kits_(makeKits()),
      other_(makeButton(tr("OTHER DEVICE"), tr("Other kinds of devices: recordings, measuring cards, boards, networks"),
                        QStringLiteral("device-other"))),
      kinds_(new QWidget),
      about_(new TextLabel({type_size::kBody, false, true, true})),
      whose_(new TextLabel({type_size::kLabel, true, true})),
      state_(new TextLabel({type_size::kBody, true, false, true})),
      findings_(new TextLabel({type_size::kBody, false, false, true})),
      levels_(new TextLabel({type_size::kBody, false, false, true})),
      listen_(makeButton(tr("LISTEN"), tr("Listen to the chosen device"), QStringLiteral("device-listen"))),
      form_(new SettingsForm),
      channels_(draft),
      table_(new QTableView),
      trial_(new SetupSensorTrial(controller, draft, [this] { return table_->currentIndex().row(); })),
      live_(new LevelSpectrum) {
  auto* columns = new QHBoxLayout(this);
  auto* left = new QVBoxLayout;
  left->addWidget(heading_);
  left->addLayout(foundRows_);
  left->addWidget(none_);
  none_->setObjectName(QStringLiteral("device-none"));
  left->addWidget(kits_);
  other_->setCheckable(true);
  left->addWidget(other_, 0, Qt::AlignLeft);
  connect(other_, &TouchButton::clicked, this, &SetupSensors::refresh);
  auto* choices = new QGridLayout(kinds_);
  choices->setContentsMargins(0, 0, 0, 0);
  constexpr int kInARow = 3;
  for (const ComponentOption& option : controller.sources()) {
    TouchButton* button = makeButton(sourceCaption(option.id), withoutKeys(sayCore(option.description.toStdString())),
                                     QStringLiteral("source-") + option.id);
    button->setCheckable(true);
    const int place = static_cast<int>(sources_.size());
    sources_.push_back(button);
    choices->addWidget(button, place / kInARow, place % kInARow);
    connect(button, &TouchButton::clicked, this, [this, id = option.id] {
      draft_.setSource(id);
      refresh();
    });
  }
  choices->setColumnStretch(kInARow, 1);
  left->addWidget(kinds_);
  left->addWidget(about_);
  settings_ = scrolled(form_);
  left->addWidget(settings_, 2);
  left->addWidget(new TextLabel({type_size::kLabel, true, true}, tr("CHANNELS")));
  table_->setModel(&channels_);
  table_->setObjectName(QStringLiteral("channels"));
  table_->setAccessibleName(tr("Channels"));
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  for (const int column : {ChannelModel::Quantity, ChannelModel::Scale})
    table_->horizontalHeader()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
  table_->setEditTriggers(QAbstractItemView::AllEditTriggers);
  table_->setItemDelegateForColumn(ChannelModel::Quantity, new QuantityDelegate(table_));
  constexpr int kHeadAndRow = 56;  // px: lower than Qt's own least height, so that no button has to give way
  table_->setMinimumHeight(kHeadAndRow);
  left->addWidget(table_, 3);
  auto* buttons = new QHBoxLayout;
  TouchButton* add = makeButton(tr("ADD CHANNEL"), tr("Add a channel"), QStringLiteral("channel-add"));
  TouchButton* remove = makeButton(tr("REMOVE"), tr("Remove the chosen channel"), QStringLiteral("channel-remove"));
  buttons->addWidget(add);
  buttons->addWidget(remove);
  buttons->addStretch(1);
  left->addLayout(buttons);
  connect(add, &TouchButton::clicked, &channels_, &ChannelModel::add);
  connect(remove, &TouchButton::clicked, this, [this] { channels_.remove(table_->currentIndex().row()); });
  connect(form_, &SettingsForm::edited, &draft, &SetupDraft::setSourceSetting);
  connect(form_, &SettingsForm::fileWanted, this, [this](const QString& key) {
    chooseFiles(this, settingLabel(key.toStdString()), QFileDialog::ExistingFile, {},
                [this, key](const QStringList& paths) { draft_.setSourceSetting(key, paths.value(0)); });
  });
  auto* right = new QVBoxLayout;
  auto* heading = new QHBoxLayout;
  heading->addWidget(whose_, 1);
  heading->addWidget(listen_);
  right->addLayout(heading);
  for (TextLabel* label : {state_, findings_, levels_}) right->addWidget(label);
  right->addWidget(live_, 1);
  right->addWidget(trial_);
  findings_->setTone(Tone::Onset);
  listen_->setCheckable(true);
  connect(listen_, &TouchButton::clicked, this, [this] {
    if (listen_->isChecked()) {
      listenNow();
    } else {
      controller_.stopPreview();
    }
  });
  columns->addLayout(left, 58);
  columns->addLayout(right, 42);
  refresh();
}

// The three that the manual describes, each with its part of the chapter.
QWidget* SetupSensors::makeKits() {
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(new TextLabel({type_size::kLabel, true, true}, tr("THREE THAT WORK, AND HOW")));
  const struct {
    QString caption, spoken, name, link;
  } kits[] = {{tr("MICROPHONE"), tr("Measurement microphone, USB sound card"), QStringLiteral("kit-microphone"),
               QStringLiteral("hardware.md#microphone")},
              {tr("IEPE SENSOR"), tr("IEPE accelerometer, USB interface"), QStringLiteral("kit-iepe"),
               QStringLiteral("hardware.md#iepe-accelerometer")},
              {tr("MEMS BOARD"), tr("MEMS board on USB, two axes"), QStringLiteral("kit-mems"),
               QStringLiteral("hardware.md#mems-board")}};
  auto* line = new QHBoxLayout;
  line->setSpacing(pixelsFor(kTouchGapMm, this) + 2);
  for (const auto& kit : kits) {
    TouchButton* how = makeButton(kit.caption, tr("The manual on it: %1").arg(kit.spoken), kit.name);
    how->setToolTip(kit.spoken);
    line->addWidget(how);
    connect(how, &TouchButton::clicked, this, [this, link = kit.link] { emit manualAsked(link); });
  }
  line->addStretch(1);
  column->addLayout(line);
  return box;
}

void SetupSensors::listenNow() {
  heardFresh_ = {};
  listened_ = draft_.profile().source;
  controller_.listen(draft_.profile(), draft_.name());
}

// A device by its maker's name, so that nobody has to know what kind of driver it has.
void SetupSensors::showFound() {
  constexpr std::size_t kMost = 3;  // on the screen; more are reached by their kind
  std::vector<FoundDevice> here = controller_.devicesHere();
  if (here.size() > kMost) here.resize(kMost);
  const auto same = [](const FoundDevice& a, const FoundDevice& b) {
    return a.label == b.label && a.range == b.range && a.source.settings == b.source.settings;
  };
  if (!std::ranges::equal(here, foundShown_, same)) {
    for (TouchButton* button : found_) button->deleteLater();
    found_.clear();
    for (std::size_t k = 0; k < here.size(); ++k) {
      TouchButton* button = makeButton(here[k].label, tr("Take %1, which is plugged in here").arg(here[k].label),
                                       QStringLiteral("device-found-%1").arg(k));
      button->setCheckable(true);
      button->setHint(sayCore(here[k].range.toStdString()));
      button->applyTheme(theme());
      connect(button, &TouchButton::clicked, this, [this, device = here[k]] {
        draft_.useDevice(device);
        other_->setChecked(false);
        listenNow();  // its meter moves when somebody knocks: it is the right one
        refresh();
      });
      foundRows_->addWidget(button);
      found_.push_back(button);
    }
    foundShown_ = std::move(here);
  }
  const config::ComponentChoice& source = draft_.profile().source;
  for (std::size_t k = 0; k < found_.size(); ++k) found_[k]->setChecked(isThat(foundShown_[k], source));
}

bool SetupSensors::chosenIsFound() const {
  const config::ComponentChoice& source = draft_.profile().source;
  return std::ranges::any_of(foundShown_, [&](const FoundDevice& device) { return isThat(device, source); });
}

// Names first. What kind of device it is matters to whoever has one that is not listed, or has chosen one before.
void SetupSensors::showKinds() {
  const bool chosen = !draft_.profile().source.id.empty();
  const bool kinds = other_->isChecked() || (chosen && !chosenIsFound());
  heading_->setVisible(!kinds);  // room for the rows below
  none_->setVisible(foundShown_.empty() && !kinds);
  kits_->setVisible(foundShown_.empty() && !kinds);
  other_->setVisible(!chosen || chosenIsFound());
  kinds_->setVisible(kinds);
  about_->setVisible(kinds);
  settings_->setVisible(chosen);
}

void SetupSensors::showEvent(QShowEvent* event) {
  SetupTab::showEvent(event);
  controller_.lookForDevices();
}

void SetupSensors::refresh() {
  showFound();
  showKinds();
  const config::Profile& profile = draft_.profile();
  for (TouchButton* button : sources_) {
    button->setChecked(button->objectName() == QStringLiteral("source-") + QString::fromStdString(profile.source.id));
  }
  listen_->setEnabled(!profile.source.id.empty());
  const bool another = profile.source.id != listened_.id || profile.source.settings != listened_.settings;
  if (another && controller_.heard().state != DevicePreview::State::Off) controller_.stopPreview();
  about_->setText(profile.source.id.empty() ? draft_.missing(SetupDraft::Part::Sensors)
                                            : withoutKeys(described(controller_.sources(), profile.source.id)));
  form_->show(controller_.sourceSettings(profile), profile.source.settings, QStringLiteral("source-setting-"));
  trial_->refresh();
}

// The chosen device while it is listened to, else what runs.
Picture SetupSensors::shown(const Picture& picture, const DevicePreview& heard) {
  listen_->setChecked(heard.state == DevicePreview::State::Opening || heard.state == DevicePreview::State::Running);
  if (heard.state == DevicePreview::State::Off) {
    whose_->setText(tr("WHAT RUNS NOW"));
    return picture;
  }
  whose_->setText(tr("THE CHOSEN DEVICE"));
  Picture device = picture;
  device.info = heard.info;
  device.snapshot = heard.snapshot;
  heardFresh_.see(heard.snapshot, picture.nowMs);
  device.stale = heardFresh_.stale();
  return device;
}

void SetupSensors::display(const Picture& picture) {
  // What is plugged in while somebody looks shows without another touch.
  constexpr qint64 kLookEveryMs = 3000;
  if (lookedMs_ < 0) lookedMs_ = picture.nowMs;
  if (foundShown_.empty() && picture.nowMs - lookedMs_ > kLookEveryMs) {
    controller_.lookForDevices();
    lookedMs_ = picture.nowMs;
  }
  const DevicePreview heard = controller_.heard();
  const Picture device = shown(picture, heard);
  const SensorView view = makeSensorView(device);
  const bool failed = !heard.problem.isEmpty();
  live_->display(device);
  state_->setTone(view.sick || failed ? Tone::Onset : Tone::Normal);
  state_->setText(failed                                         ? plainWords(heard.problem)
                  : heard.state == DevicePreview::State::Opening ? tr("Opening the device")
                                                                 : view.headline);
  findings_->setText(view.findings.join(u'\n'));
  findings_->setVisible(!view.findings.isEmpty());
  levels_->setText((view.channels + QStringList{view.rate} + clockLines(heard.clocks)).join(u'\n').trimmed());
}

void SetupSensors::hideEvent(QHideEvent* event) {
  if (controller_.heard().state != DevicePreview::State::Off) controller_.stopPreview();
  SetupTab::hideEvent(event);
}

void SetupSensors::applyTheme(const Theme& theme) {
  SetupTab::applyTheme(theme);
  table_->setFont(theme.font(type_size::kBody));
  table_->horizontalHeader()->setFont(theme.font(type_size::kLabel));
  table_->verticalHeader()->setDefaultSectionSize(touchHeight(theme, this));
}

}  // namespace stillcut::ui
