#include "ui/pages/tap/tap_measure.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QTableView>
#include <algorithm>
#include <utility>
#include <vector>

#include "ui/models/tap/tap_text.h"
#include "ui/pages/choose_files.h"
#include "ui/widgets/limit_bar.h"
#include "ui/widgets/text_label.h"
#include "ui/widgets/tool_button.h"

namespace stillcut::ui {

TapMeasure::TapMeasure(TapController& controller, QWidget* parent)
    : TapPart(controller, parent),
      device_(makeChoice(tr("Device"), QStringLiteral("tap-device"))),
      force_(makeChoice(tr("Hammer"), QStringLiteral("tap-force"))),
      response_(makeChoice(tr("Sensor"), QStringLiteral("tap-response"))),
      forceMeter_(new LimitBar),
      responseMeter_(new LimitBar),
      sign_(new TextLabel({type_size::kFault, true, false, true})),
      detail_(new TextLabel({type_size::kBody, false, true, true})),
      begin_(makeToolButton(tr("BEGIN"), tr("Begin the hits of this axis anew"), "tap-begin")),
      files_(makeToolButton(tr("FILES"), tr("Open files of a tap test"), "tap-files")),
      questions_(new QWidget),
      questionRows_(new QGridLayout(questions_)),
      flip_(makeToolButton(tr("SENSOR OPPOSITE"), tr("The sensor sits on the other side: turn the response"),
                           "tap-flip")),
      read_(makeToolButton(tr("READ"), tr("Read the files again with what was said"), "tap-read")),
      table_(makeTable(hits_, tr("Hits"), QStringLiteral("tap-hits"))) {
  auto* column = new QVBoxLayout(this);
  auto* choices = new QGridLayout;
  const struct {
    QComboBox* box;
    QString label;
  } rows[] = {{device_, tr("Device")}, {force_, tr("Hammer")}, {response_, tr("Sensor")}};
  choices->addWidget(new TextLabel(TextLabel::Look{type_size::kBody}, rows[0].label), 0, 0);
  choices->addWidget(device_, 0, 1, 1, 3);
  choices->addWidget(new TextLabel(TextLabel::Look{type_size::kBody}, rows[1].label), 1, 0);
  choices->addWidget(force_, 1, 1);
  choices->addWidget(new TextLabel(TextLabel::Look{type_size::kBody}, rows[2].label), 1, 2);
  choices->addWidget(response_, 1, 3);
  choices->setColumnStretch(1, 1);
  choices->setColumnStretch(3, 1);
  column->addLayout(choices);
  column->addWidget(forceMeter_);
  column->addWidget(responseMeter_);
  sign_->setObjectName(QStringLiteral("tap-sign"));
  detail_->setObjectName(QStringLiteral("tap-detail"));
  column->addWidget(sign_);
  column->addWidget(detail_);
  questions_->setObjectName(QStringLiteral("tap-questions"));
  questionRows_->setContentsMargins(0, 0, 0, 0);
  questionRows_->setColumnStretch(1, 1);
  questions_->hide();
  column->addWidget(questions_);
  flip_->setCheckable(true);
  auto* buttons = new QHBoxLayout;
  begin_->setKey(Qt::Key_F8);
  buttons->addWidget(begin_);
  buttons->addWidget(files_);
  buttons->addWidget(read_);
  buttons->addWidget(flip_);
  buttons->addStretch(1);
  column->addLayout(buttons);
  column->addWidget(table_, 1);
  showDevices();
  connect(device_, &QComboBox::activated, this, [this](int row) {
    const QString id = device_->itemData(row).toString();
    id.isEmpty() ? controller_.stopListening() : controller_.listen(id);
  });
  connect(force_, &QComboBox::activated, this, [this](int row) { controller_.chooseForce(row - 1); });
  connect(response_, &QComboBox::activated, this, [this](int row) { controller_.chooseResponse(row); });
  connect(begin_, &TouchButton::clicked, this, [this] { controller_.begin(axis_); });
  connect(files_, &TouchButton::clicked, this, &TapMeasure::openFiles);
  connect(read_, &TouchButton::clicked, this, &TapMeasure::answer);
  connect(flip_, &TouchButton::clicked, this, &TapMeasure::answer);
  connect(&hits_, &TickTable::tickAsked, this,
          [this](int row, bool ticked) { controller_.useHit(axis_, static_cast<std::size_t>(row), ticked); });
}

void TapMeasure::showDevices() {
  std::vector<TapDevice> devices{{QString(), tr("none")}};
  for (TapDevice& device : controller_.devices()) devices.push_back(std::move(device));
  bool same = device_->count() == static_cast<int>(devices.size());
  for (int k = 0; same && k < device_->count(); ++k) {
    const TapDevice& device = devices[static_cast<std::size_t>(k)];
    same = device_->itemData(k).toString() == device.id && device_->itemText(k) == device.name;
  }
  if (same) return;
  device_->clear();
  for (const TapDevice& device : devices) device_->addItem(device.name, device.id);
  const bool off = controller_.listening().state == TapListening::State::Off;
  device_->setCurrentIndex(off ? 0 : std::max(device_->findData(controller_.listening().device), 0));
}

// A profile that was saved on the page Set up meanwhile is a device to listen to.
void TapMeasure::showEvent(QShowEvent* event) {
  TapPart::showEvent(event);
  showDevices();
}

void TapMeasure::openFiles() {
  chooseFiles(
      this, tr("Files of a tap test"), QFileDialog::ExistingFiles, {},
      [this](const QStringList& paths) { controller_.openFiles(paths, axis_); }, recordingFilters(true));
}

// Fields stay while they are typed into: only what is asked anew is added.
void TapMeasure::showQuestions() {
  const TapFileReading& reading = controller_.reading();
  const auto same = [](TapQuestion question, const auto& row) { return question == row.first; };
  if (!std::equal(reading.questions.begin(), reading.questions.end(), asked_.begin(), asked_.end(), same)) {
    while (QLayoutItem* item = questionRows_->takeAt(0)) {
      item->widget()->deleteLater();
      delete item;
    }
    for (const auto& [question, edit] : asked_) forgetTyped(edit);
    asked_.clear();
    for (const TapQuestion question : reading.questions) {
      const TapQuestionText text = tapQuestion(question);
      auto* label = new TextLabel(TextLabel::Look{type_size::kBody}, text.asked);
      QLineEdit* edit = makeEdit(text.asked, QStringLiteral("tap-question-%1").arg(static_cast<int>(question)));
      edit->setPlaceholderText(text.example);
      const auto said = reading.answers.said.find(question);
      if (said != reading.answers.said.end()) edit->setText(said->second);
      connect(edit, &QLineEdit::returnPressed, this, &TapMeasure::answer);
      const int row = static_cast<int>(asked_.size());
      questionRows_->addWidget(label, row, 0);
      questionRows_->addWidget(edit, row, 1);
      label->applyTheme(theme());
      dressTyped(edit);
      asked_.emplace_back(question, edit);
    }
  }
  const bool asks = !asked_.empty() && (!reading.problem.isEmpty() || reading.runs);
  questions_->setVisible(asks);
  read_->setVisible(asks);
  flip_->setVisible(reading.flipAsked);
  flip_->setChecked(reading.answers.flip);
  table_->setVisible(!asks);
}

void TapMeasure::answer() {
  TapAnswers answers;
  for (const auto& [question, edit] : asked_) answers.said[question] = edit->text();
  answers.flip = flip_->isChecked();
  controller_.answer(answers);
}

void TapMeasure::showChannels() {
  const TapListening& listening = controller_.listening();
  QStringList names;
  for (const TapChannel& channel : listening.channels) names << channel.name;
  if (names != channels_) {
    channels_ = names;
    force_->clear();
    response_->clear();
    force_->addItem(tr("none"));
    force_->addItems(names);
    response_->addItems(names);
  }
  const bool runs = listening.state == TapListening::State::Running;
  for (QComboBox* box : {force_, response_}) box->setEnabled(runs);
  if (!runs) return;
  const QSignalBlocker quietForce(force_), quietResponse(response_);
  force_->setCurrentIndex(listening.force + 1);
  response_->setCurrentIndex(listening.response);
}

void TapMeasure::refresh(int axis, UnitSystem) {
  axis_ = axis;
  showChannels();
  showQuestions();
  const TapListening& listening = controller_.listening();
  const bool runs = listening.state == TapListening::State::Running;
  if (listening.state == TapListening::State::Off) device_->setCurrentIndex(0);
  const auto show = [&](LimitBar* bar, int channel) {
    bar->setVisible(runs && channel >= 0);
    if (bar->isVisibleTo(this)) bar->display(tapMeter(listening.channels[static_cast<std::size_t>(channel)]));
  };
  show(forceMeter_, listening.force);
  show(responseMeter_, listening.response);
  const TapSign sign = tapSign(controller_);
  sign_->setTone(sign.tone);
  sign_->setText(sign.text);
  detail_->setText(sign.detail);
  detail_->setVisible(!sign.detail.isEmpty());
  begin_->setEnabled(runs && listening.response >= 0);
  const auto& hits = controller_.hits(axis);
  const bool ofFiles = !hits.empty() && !hits.front().file.isEmpty();
  const bool withForce = ofFiles ? controller_.response(axis).withForce : listening.force >= 0;
  const int before = hits_.rowCount();
  hits_.show(hitHeader(withForce), hitRows(hits, withForce));
  // To a new one; who looks at an older one stays there.
  if (hits_.rowCount() > before) table_->scrollToBottom();
}

}  // namespace stillcut::ui
