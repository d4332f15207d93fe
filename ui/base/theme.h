// Every colour and every type size of the screens. Grey is normal; a colour means that somebody has to act.
// GUI thread. Plain values: a theme is handed down to widgets (see themed.h), nobody looks one up.
#pragma once

#include <QColor>
#include <QFont>

namespace stillcut::ui {

enum class ThemeKind { Light, Dark, HighContrast };
enum class TextSize { Normal, Large, Largest };

// What a thing on the screen means. Each tone also has a shape and a word of its own: colour never speaks alone.
enum class Tone { Normal, Faint, Onset, Chatter, Advice };

struct ThemeColors {
  QColor window, panel, raised, border;  // surfaces, and what divides them
  QColor text, secondary, faint;         // what is read, what explains it, what is off
  QColor track, fill;                    // a bar's bed, and its normal fill
  QColor advice, onAdvice;               // blue: a proposal, and the one accent
  QColor onset, onOnset;                 // amber: chatter begins
  QColor chatter, onChatter;             // red: chatter
  QColor onsetText, chatterText;         // the same two as text on a panel
  QColor gap, hatch;                     // where samples are missing
};

// Colours of one of the three themes; all of them are in theme.cpp and nowhere else.
ThemeColors themeColors(ThemeKind kind);

struct Theme {
  ThemeKind kind = ThemeKind::Light;
  ThemeColors colors;
  double scale = 1.0;  // 1 at 1280 x 800; grows with the window
  double text = 1.0;   // of labels, sentences and ticks, by the reader's choice: large words stay in their places

  int px(double base) const;
  // Text of `base` pixels (before scaling), digits all of one width; `share` of it where it has to shrink to fit.
  QFont font(double base, bool bold = false, double share = 1.0) const;
  int textPx(double base) const;
  QColor back(Tone tone) const;     // a surface that carries the tone
  QColor front(Tone tone) const;    // text and shapes on that surface
  QColor onPanel(Tone tone) const;  // text of that tone on an ordinary panel
};

Theme makeTheme(ThemeKind kind, double scale, TextSize text = TextSize::Normal);
// The steps a window of this size gets: 0.8 for 1024 x 768, 1 for 1280 x 800, 1.25 for 1920 x 1080, 2.5 for 3840 x
// 2160.
double scaleForSize(int width, int height);

namespace type_size {
inline constexpr double kVerdict = 96;    // capitals of 15 mm and more on a 24-inch screen: read at three metres
inline constexpr double kFrequency = 62;  // 15 mm at 1920 x 1080 on a 24-inch screen
inline constexpr double kTarget = 56;     // what to do is read before what kind of chatter it is
inline constexpr double kKind = 40;
inline constexpr double kFault = 46;  // of what has failed, for the operator at the machine
inline constexpr double kValue = 22;
inline constexpr double kBody = 17;
inline constexpr double kButton = 19;
inline constexpr double kLabel = 14;
inline constexpr double kTick = 13;
}  // namespace type_size

}  // namespace stillcut::ui
