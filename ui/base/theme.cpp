#include "ui/base/theme.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace stillcut::ui {
namespace {

ThemeColors light() {
  ThemeColors c;
  c.window = "#e3e6e9";
  c.panel = "#f8f9fa";
  c.raised = "#ffffff";
  c.border = "#c3c9cf";
  c.text = "#171b20";
  c.secondary = "#505a64";
  c.faint = "#646e78";
  c.track = "#dbe0e4";
  c.fill = "#76828e";
  c.advice = "#1257a8";
  c.onAdvice = "#ffffff";
  c.onset = "#f0ad1f";
  c.onOnset = "#1c1500";
  c.chatter = "#b4201c";
  c.onChatter = "#ffffff";
  c.onsetText = "#815400";
  c.chatterText = "#b4201c";
  c.gap = "#c9ced3";
  c.hatch = "#8b949d";
  return c;
}

ThemeColors dark() {
  ThemeColors c;
  c.window = "#101316";
  c.panel = "#1a1e22";
  c.raised = "#262b31";
  c.border = "#343b42";
  c.text = "#e8ebee";
  c.secondary = "#a9b2bb";
  c.faint = "#8a949e";
  c.track = "#2b3138";
  c.fill = "#8c97a3";
  c.advice = "#6cb0f5";
  c.onAdvice = "#08131f";
  c.onset = "#f2b53a";
  c.onOnset = "#1c1500";
  c.chatter = "#c92a25";
  c.onChatter = "#ffffff";
  c.onsetText = "#f2b53a";
  c.chatterText = "#ff8179";
  c.gap = "#30363c";
  c.hatch = "#6b757f";
  return c;
}

ThemeColors highContrast() {
  ThemeColors c;
  c.window = "#000000";
  c.panel = "#000000";
  c.raised = "#000000";
  c.border = "#ffffff";
  c.text = "#ffffff";
  c.secondary = "#ffffff";
  c.faint = "#d0d0d0";
  c.track = "#303030";
  c.fill = "#d0d0d0";
  c.advice = "#8cc8ff";
  c.onAdvice = "#000000";
  c.onset = "#ffd000";
  c.onOnset = "#000000";
  c.chatter = "#ff5a4f";
  c.onChatter = "#000000";
  c.onsetText = "#ffd000";
  c.chatterText = "#ff8a80";
  c.gap = "#202020";
  c.hatch = "#ffffff";
  return c;
}

}  // namespace

ThemeColors themeColors(ThemeKind kind) {
  switch (kind) {
    case ThemeKind::Light:
      return light();
    case ThemeKind::Dark:
      return dark();
    case ThemeKind::HighContrast:
      return highContrast();
  }
  return light();
}

int Theme::px(double base) const {
  return static_cast<int>(std::lround(base * scale));
}

int Theme::textPx(double base) const {
  return px(base <= type_size::kBody ? base * text : base);
}

QFont Theme::font(double base, bool bold, double share) const {
  QFont font;
  // Families whose digits are all of one width; the last one is on every Debian desktop.
  font.setFamilies({"Noto Sans", "Noto Sans CJK SC", "DejaVu Sans"});
  font.setPixelSize(std::max(static_cast<int>(std::lround(textPx(base) * share)), 1));
  font.setWeight(bold ? QFont::Bold : QFont::Normal);
  return font;
}

QColor Theme::back(Tone tone) const {
  switch (tone) {
    case Tone::Onset:
      return colors.onset;
    case Tone::Chatter:
      return colors.chatter;
    case Tone::Advice:
      return colors.advice;
    case Tone::Normal:
    case Tone::Faint:
      return colors.panel;
  }
  return colors.panel;
}

QColor Theme::front(Tone tone) const {
  switch (tone) {
    case Tone::Onset:
      return colors.onOnset;
    case Tone::Chatter:
      return colors.onChatter;
    case Tone::Advice:
      return colors.onAdvice;
    case Tone::Normal:
      return colors.text;
    case Tone::Faint:
      return colors.faint;
  }
  return colors.text;
}

QColor Theme::onPanel(Tone tone) const {
  switch (tone) {
    case Tone::Onset:
      return colors.onsetText;
    case Tone::Chatter:
      return colors.chatterText;
    case Tone::Advice:
      return colors.advice;
    case Tone::Normal:
      return colors.text;
    case Tone::Faint:
      return colors.faint;
  }
  return colors.text;
}

Theme makeTheme(ThemeKind kind, double scale, TextSize text) {
  constexpr std::array<double, 3> kSteps{1.0, 1.1, 1.2};
  return Theme{kind, themeColors(kind), scale, kSteps[static_cast<std::size_t>(text)]};
}

double scaleForSize(int width, int height) {
  constexpr double kSmallest = 0.8;  // an old panel of 1024 x 768: nobody reads what has to be moved sideways
  if (width < 1280) return std::max(kSmallest, width / 1280.0);
  const double fit = std::min(width / 1280.0, height / 800.0);
  return std::clamp(std::floor(fit * 4.0) / 4.0, 1.0, 3.0);
}

}  // namespace stillcut::ui
