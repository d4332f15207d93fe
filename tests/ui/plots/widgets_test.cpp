// Each painted widget on its own: what is shown where, and that a text which does not fit is noticed.
#include "tests/support/reason_codes.h"
#include "tests/ui/support/pictures.h"
#include "tests/ui/support/ui_fixture.h"
#include "ui/pages/intervention_list.h"
#include "ui/plots/axis_painter.h"
#include "ui/shell/apply_theme.h"
#include "ui/widgets/advice_panel.h"
#include "ui/widgets/intervention_card.h"
#include "ui/widgets/limit_bar.h"
#include "ui/widgets/override_table.h"
#include "ui/widgets/painting.h"
#include "ui/widgets/status_strip.h"
#include "ui/widgets/text_label.h"
#include "ui/widgets/verdict_sign.h"

namespace stillcut::ui {
namespace {

const Theme kLight = makeTheme(ThemeKind::Light, 1.0);

template <class Widget>
QImage paint(Widget& widget, QSize size) {
  widget.applyTheme(kLight);
  widget.resize(size);
  return widget.grab().toImage();
}

// Pixels of that colour in a row.
int count(const QImage& image, int y, const QColor& color) {
  int n = 0;
  for (int x = 0; x < image.width(); ++x) n += image.pixelColor(x, y) == color ? 1 : 0;
  return n;
}

class Widgets : public UiTest {};

// The style sheet of the window has a colour for every plain label.
TEST_F(Widgets, ATextKeepsItsToneInTheWindow) {
  QWidget window;
  auto* label = new TextLabel({type_size::kValue, true}, QStringLiteral("HHHH"), &window);
  label->resize(200, 40);
  for (const Tone tone : {Tone::Normal, Tone::Chatter, Tone::Onset}) {
    label->setTone(tone);
    applyTheme(window, kLight);
    const QImage image = window.grab().toImage();
    EXPECT_GT(count(image, 20, kLight.onPanel(tone)), 4) << static_cast<int>(tone);
  }
}

TEST_F(Widgets, LimitBarFillsItsShareOfTheBed) {
  LimitBar bar;
  bar.display({"Energy ratio", "0.25", 0.25, true, {}, Tone::Normal});
  const QImage image = paint(bar, {600, 30});
  const double filled = count(image, 15, kLight.colors.fill), rest = count(image, 15, kLight.colors.track);
  EXPECT_NEAR(filled / (filled + rest), 0.25, 0.01);
  EXPECT_FALSE(bar.clipped());
}

TEST_F(Widgets, LimitBarTakesTheColourOfItsTone) {
  LimitBar bar;
  bar.display({"Energy ratio", "0.75", 0.75, true, {0.3}, Tone::Chatter});
  const QImage image = paint(bar, {600, 30});
  EXPECT_GT(count(image, 12, kLight.colors.chatter), 100);
  EXPECT_EQ(count(image, 12, kLight.colors.fill), 0);
}

TEST_F(Widgets, VerdictsDifferInShapeNotOnlyInColour) {
  // The shape alone, without colour: pixels unlike the panel's corner, in the place of the shape.
  const auto outline = [](Shape shape) {
    VerdictSign sign;
    VerdictView view;
    view.shape = shape;
    view.tone = Tone::Normal;
    sign.display(view);
    const QImage image = paint(sign, {560, 290});
    QByteArray mask;
    for (int y = 60; y < 180; ++y) {
      for (int x = 10; x < 120; ++x) mask.append(image.pixelColor(x, y) == kLight.colors.panel ? '0' : '1');
    }
    return mask;
  };
  const std::vector<QByteArray> masks{outline(Shape::Ring), outline(Shape::Circle), outline(Shape::Triangle),
                                      outline(Shape::Octagon)};
  for (std::size_t a = 0; a < masks.size(); ++a) {
    EXPECT_GT(masks[a].count('1'), 200) << a;
    for (std::size_t b = a + 1; b < masks.size(); ++b) {
      int differing = 0;
      for (qsizetype k = 0; k < masks[a].size(); ++k) differing += masks[a][k] != masks[b][k] ? 1 : 0;
      EXPECT_GT(differing, 200) << a << " and " << b;
    }
  }
}

TEST_F(Widgets, EveryReasonFitsIntoTheVerdictAndTheAdvice) {
  VerdictSign sign;
  AdvicePanel advice;
  for (int code = 1; test::isReason(code); ++code) {
    Scene s = stableScene();
    s.verdict().valid = false;
    s.verdict().reason = {static_cast<ReasonCode>(code), {12345.6, 2.345, 5678.9, 12345.6}};
    sign.display(makeVerdictView(s.picture(), Trend::Unknown));
    paint(sign, {545, 284});
    EXPECT_FALSE(sign.clipped()) << sign.view().detail.toStdString();
    s.snapshot.adviceOpen = true;
    OverrideRequest& r = s.snapshot.request;
    r.kind = RequestKind::Set;
    r.claimsSpeed = r.claimsFeed = true;
    r.speed = Rpm(23456);
    r.feed = fromMmPerMin(12345);
    r.reason = s.verdict().reason;
    advice.display(makeAdviceView(s.picture()));
    paint(advice, {545, 306});
    EXPECT_FALSE(advice.clipped()) << advice.view().reason.toStdString();
  }
}

TEST_F(Widgets, ATextThatDoesNotFitIsNoticedAndCutInsideItsBox) {
  InterventionCard card;
  CardView view;
  view.headline = QString(200, u'W');
  card.display(view);
  paint(card, {400, 53});
  EXPECT_TRUE(card.clipped());
}

TEST_F(Widgets, StripItemsKeepTheirPlaceWhileNumbersChange) {
  StatusStrip strip;
  std::vector<StripItem> items{
      {"Link", "1 ms", Tone::Normal}, {"Drops", "0", Tone::Normal}, {"Age", "4 ms", Tone::Normal}};
  strip.display(items);
  paint(strip, {900, 32});
  items[0].value = "120 ms";
  strip.display(items);
  strip.grab();
  const QImage wide = strip.grab().toImage();
  items[0].value = "2 ms";
  strip.display(items);
  const QImage narrow = strip.grab().toImage();
  // Right of the first item nothing has moved.
  EXPECT_EQ(wide.copy(300, 0, 600, 32), narrow.copy(300, 0, 600, 32));
}

TEST_F(Widgets, OverrideTableSaysWhatHindersInsteadOfItsColumns) {
  OverrideTable table;
  Scene s = stableScene();
  s.snapshot.machine.linkUp = false;
  table.display(makeMachineView(s.picture()));
  paint(table, {660, 90});
  EXPECT_TRUE(table.view().warning);
  EXPECT_FALSE(table.clipped());
  EXPECT_TRUE(table.accessibleDescription().contains("does not answer"));
}

TEST_F(Widgets, InterventionListShowsWhatWentWrong) {
  Scene s = stableScene();
  s.snapshot.eventCount = 2;
  s.snapshot.events[0] = {s.snapshot.time, 0, EventLevel::Fault, {ReasonCode::LeaseExpired, {0.25}}};
  s.snapshot.events[1] = {s.snapshot.time, 1, EventLevel::Info, {ReasonCode::LinkBack, {}}};
  const EventLine line = makeEventLine(s.picture());
  EXPECT_TRUE(line.text.contains("programmed values restored")) << line.text.toStdString();
  EXPECT_EQ(line.tone, Tone::Chatter);
  InterventionList list;
  list.display({}, {}, line, true, false);
  paint(list, {690, 148});
  EXPECT_FALSE(list.clipped());
  s.snapshot.time += std::chrono::seconds(31);
  EXPECT_TRUE(makeEventLine(s.picture()).text.isEmpty());
}

TEST_F(Widgets, TouchButtonAsksInAmberAndClicksByKey) {
  QWidget window;
  auto* button = new TouchButton("AUTO", TouchButton::Look::Plain, &window);
  button->setKey(Qt::Key_F3);
  window.show();
  window.activateWindow();
  QCoreApplication::processEvents();
  int clicks = 0;
  QObject::connect(button, &TouchButton::clicked, [&] { ++clicks; });
  QTest::keyClick(&window, Qt::Key_F3);
  EXPECT_EQ(clicks, 1);
  button->setEnabled(false);
  QTest::keyClick(&window, Qt::Key_F3);
  EXPECT_EQ(clicks, 1);
  button->setEnabled(true);
  button->setAsking(true, "AUTO?", "touch again");
  EXPECT_EQ(paint(*button, {146, 66}).pixelColor(20, 10), kLight.colors.onset);
  EXPECT_FALSE(button->clipped());
}

TEST(AxisPainter, TheWidestNumberHasRoomWithItsSign) {
  const Theme theme = makeTheme(ThemeKind::Light, 1.0);
  const QFontMetrics metrics(theme.font(type_size::kTick));
  const int small = leftAxisWidth(200, {0.0, 1.0}, {}, theme);
  const int wide = leftAxisWidth(200, {-0.0004, 0.0004}, QStringLiteral("\u00b5m/N"), theme);
  EXPECT_GT(wide, small);
  EXPECT_GE(wide, metrics.horizontalAdvance(QStringLiteral("\u22120.0004 \u00b5m/N")));
}

}  // namespace
}  // namespace stillcut::ui
