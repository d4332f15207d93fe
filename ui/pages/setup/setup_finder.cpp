#include "ui/pages/setup/setup_finder.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QListWidget>

#include "ui/base/say.h"
#include "ui/widgets/step_list.h"
#include "ui/widgets/text_label.h"
#include "ui/widgets/touch_button.h"
#include "ui/widgets/wrapped_list.h"

namespace stillcut::ui {

SetupFinder::SetupFinder(SetupController& controller, SetupDraft& draft, QWidget* parent)
    : SetupTab(controller, draft, parent),
      hosts_(makeEdit(tr("Hosts to look at besides this computer"), QStringLiteral("find-hosts"))),
      find_(makeButton(tr("FIND"), tr("Look for serial ports and machines, once"), QStringLiteral("find-begin"))),
      use_(makeButton(tr("USE"), tr("Take the chosen one as the link"), QStringLiteral("find-use"))),
      test_(makeButton(tr("TEST THE LINK"), tr("Test the link step by step; nothing moves"),
                       QStringLiteral("link-test"))),
      save_(makeButton(tr("SAVE"), tr("Save the link with its delay into the profile"), QStringLiteral("link-save"))),
      places_(new QListWidget),
      note_(new TextLabel({type_size::kBody, false, true, true})),
      steps_(new StepList) {
  layOut();
  connectAll();
  SetupFinder::refresh();
}

void SetupFinder::layOut() {
  auto* column = new QVBoxLayout(this);
  column->addWidget(new TextLabel({type_size::kLabel, true, true}, tr("FIND THE MACHINE")));
  auto* line = new QHBoxLayout;
  hosts_->setPlaceholderText(tr("more hosts, or 192.168.1.0/24"));
  line->addWidget(hosts_, 1);
  line->addWidget(find_);
  column->addLayout(line);
  places_->setObjectName(QStringLiteral("found-places"));
  places_->setAccessibleName(tr("What was found"));
  showWrapped(*places_);
  places_->setResizeMode(QListView::Adjust);
  places_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  constexpr int kLeastHeight = 80;  // gives way to what the test of a link says
  places_->setMinimumHeight(kLeastHeight);
  column->addWidget(places_, 1);
  column->addWidget(note_);
  auto* buttons = new QHBoxLayout;
  for (TouchButton* button : {use_, test_, save_}) buttons->addWidget(button);
  buttons->addStretch(1);
  column->addLayout(buttons);
  column->addWidget(steps_);
}

void SetupFinder::connectAll() {
  connect(find_, &TouchButton::clicked, this, [this] {
    if (controller_.search().runs) {
      controller_.stopFinding();
    } else {
      controller_.findMachines(hosts_->text().trimmed());
    }
    refresh();
  });
  connect(use_, &TouchButton::clicked, this, &SetupFinder::use);
  connect(test_, &TouchButton::clicked, this, [this] {
    if (controller_.linkTest().state == LinkTest::State::Runs) {
      controller_.stopTest();
    } else {
      controller_.testLink(draft_.profile(), draft_.name());
    }
    refresh();
  });
  connect(save_, &TouchButton::clicked, this, &SetupFinder::save);
  connect(places_, &QListWidget::currentRowChanged, this, [this] { showFound(); });
}

// The servers of one machine are found one by one, and are one link.
void SetupFinder::use() {
  const auto& places = controller_.search().places;
  const int row = places_->currentRow();
  if (row < 0 || row >= static_cast<int>(places.size())) return;
  config::ComponentChoice chosen = places[static_cast<std::size_t>(row)].link;
  if (chosen.id.empty()) return;
  const auto host = [](const config::ComponentChoice& link) {
    const auto found = link.settings.find("host");
    return found == link.settings.end() ? std::string() : found->second;
  };
  for (const MachineSearch::Place& place : places) {
    const bool same = place.link.id == chosen.id && !host(chosen).empty() && host(place.link) == host(chosen);
    if (same) chosen.settings.insert(place.link.settings.begin(), place.link.settings.end());
  }
  draft_.edit([&](config::Profile& profile) {
    if (profile.link.id != chosen.id) profile.link = {chosen.id, {}};
    for (const auto& [key, value] : chosen.settings) profile.link.settings[key] = value;
  });
}

void SetupFinder::save() {
  const auto saved = controller_.save(draft_.profile(), draft_.name());
  note_->setTone(saved ? Tone::Normal : Tone::Onset);
  note_->setText(saved ? tr("Saved: %1").arg(saved.value()) : sayError(saved.error()));
  note_->setVisible(true);
}

void SetupFinder::showFound() {
  const MachineSearch& search = controller_.search();
  const int row = places_->currentRow();
  const bool chosen = row >= 0 && row < static_cast<int>(search.places.size());
  use_->setEnabled(chosen && !search.places[static_cast<std::size_t>(row)].link.id.empty());
}

void SetupFinder::showTest() {
  const LinkTest& test = controller_.linkTest();
  std::vector<StepLine> lines;
  for (const LinkTest::Step& step : test.steps) {
    lines.push_back(
        {QStringLiteral("%1  %2: %3")
             .arg(step.good ? QStringLiteral("✓") : QStringLiteral("✗"), sayCore(step.what.toStdString()), step.said),
         step.good ? Tone::Normal : Tone::Onset});
  }
  if (test.state == LinkTest::State::Runs) lines.push_back({QStringLiteral("…")});
  steps_->display(lines);
}

void SetupFinder::refresh() {
  const MachineSearch& search = controller_.search();
  const std::string& link = draft_.profile().link.id;
  const bool tests = controller_.linkTest().state == LinkTest::State::Runs;
  find_->setText(search.runs ? tr("STOP") : tr("FIND"));
  test_->setText(tests ? tr("STOP") : tr("TEST THE LINK"));
  test_->setEnabled(tests || (!link.empty() && link != "simulated"));
  save_->setEnabled(controller_.linkTest().state == LinkTest::State::Good && !draft_.name().isEmpty());
  QStringList rows;
  for (const MachineSearch::Place& place : search.places) {
    rows << QStringLiteral("%1   %2").arg(place.where, sayCore(place.what.toStdString()));
  }
  QStringList shown;
  for (int row = 0; row < places_->count(); ++row) shown << places_->item(row)->text();
  if (rows != shown) {
    places_->clear();
    places_->addItems(rows);
    note_->setText({});
  }
  if (search.runs || !search.problem.isEmpty() || (search.done && rows.isEmpty()) || !search.done) {
    note_->setTone(search.problem.isEmpty() ? Tone::Normal : Tone::Onset);
    note_->setText(search.runs                 ? tr("Looking")
                   : !search.problem.isEmpty() ? search.problem
                   : search.done               ? tr("Nothing answers. A path or a host can be typed on the left.")
                                               : tr("Nothing is looked for before you ask."));
  }
  note_->setVisible(!note_->text().isEmpty());
  showFound();
  showTest();
}

void SetupFinder::applyTheme(const Theme& theme) {
  SetupTab::applyTheme(theme);
  places_->setFont(theme.font(type_size::kBody));
  layout()->setContentsMargins(0, 0, 0, 0);  // a part of another tab
}

}  // namespace stillcut::ui
