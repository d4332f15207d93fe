#include "ui/models/tune/param_scale.h"

#include <algorithm>
#include <cmath>

#include "ui/base/format.h"
#include "ui/base/say.h"

namespace stillcut::ui {
namespace {

using config::ParamDecl;
using config::ParamKind;

constexpr double kDecades = 2.0;  // from here on a linear slider would squeeze the small values together
constexpr int kDigits = 3;

bool logarithmic(const ParamDecl& decl) {
  return decl.kind == ParamKind::Real && decl.lowest > 0.0 && std::log10(decl.highest / decl.lowest) >= kDecades;
}

bool whole(const ParamDecl& decl) {
  return decl.kind != ParamKind::Real;
}

double rounded(const ParamDecl& decl, double value) {
  if (whole(decl)) return std::clamp(std::round(value), decl.lowest, decl.highest);
  if (value == 0.0) return std::clamp(0.0, decl.lowest, decl.highest);
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - (kDigits - 1));
  return std::clamp(std::round(value / unit) * unit, decl.lowest, decl.highest);
}

double oneTwoFive(double value, int direction) {
  const double decade = std::pow(10.0, std::floor(std::log10(value) + 1e-9));
  const double lead = value / decade;
  if (direction > 0) {
    const double next = lead < 1.99 ? 2.0 : lead < 4.99 ? 5.0 : 10.0;
    return next * decade;
  }
  const double next = lead > 5.01 ? 5.0 : lead > 2.01 ? 2.0 : lead > 1.01 ? 1.0 : 0.5;
  return next * decade;
}

}  // namespace

double fractionOf(const ParamDecl& decl, double value) {
  if (!std::isfinite(value)) {
    if (!std::isfinite(decl.fallback)) return 0.5;
    value = decl.fallback;
  }
  if (!(decl.highest > decl.lowest)) return 0.0;
  const double at = logarithmic(decl) ? std::log(value / decl.lowest) / std::log(decl.highest / decl.lowest)
                                      : (value - decl.lowest) / (decl.highest - decl.lowest);
  return std::clamp(at, 0.0, 1.0);
}

double valueAt(const ParamDecl& decl, double fraction) {
  const double f = std::clamp(fraction, 0.0, 1.0);
  return rounded(decl, logarithmic(decl) ? decl.lowest * std::pow(decl.highest / decl.lowest, f)
                                         : decl.lowest + f * (decl.highest - decl.lowest));
}

double stepFrom(const ParamDecl& decl, double value, int direction) {
  if (!std::isfinite(value)) value = std::isfinite(decl.fallback) ? decl.fallback : valueAt(decl, 0.5);
  if (whole(decl)) return rounded(decl, value + direction);
  if (logarithmic(decl)) return rounded(decl, oneTwoFive(value, direction));
  // The nearest of 1, 2, 5 to a fiftieth of the range: steps land on round numbers.
  double step = oneTwoFive((decl.highest - decl.lowest) / 100.0, 1);
  const double lands = std::round(value / step) * step;
  const bool onGrid = std::abs(lands - value) < 1e-6 * step;
  const double next =
      onGrid ? lands + direction * step : (direction > 0 ? std::ceil(value / step) : std::floor(value / step)) * step;
  return rounded(decl, next);
}

QString valueText(const ParamDecl& decl, double value) {
  if (!std::isfinite(value)) return say("automatic");
  if (decl.kind == ParamKind::Boolean) return value != 0.0 ? say("on") : say("off");
  if (decl.kind == ParamKind::Choice) {
    const auto index = std::min(static_cast<std::size_t>(std::max(value, 0.0)), decl.choices.size() - 1);
    return sayCore(std::string(decl.choices[index]));
  }
  if (decl.kind == ParamKind::Integer) return number(value);
  const double size = std::abs(value);
  if (size != 0.0 && (size < 1e-4 || size >= 1e7)) return QString::number(value, 'g', kDigits);
  return QString::number(value, 'g', size >= 1000.0 ? 6 : 4);
}

std::optional<double> valueFrom(const ParamDecl& decl, const QString& text) {
  QString plain = text.trimmed();
  if (decl.mayBeAutomatic && (plain == say("automatic") || plain == QStringLiteral("auto"))) return config::kAutomatic;
  plain.replace(u',', u'.');
  plain.remove(kThousandsSpace);
  plain.remove(QChar(0x00a0));
  plain.replace(QChar(0x2212), u'-');
  bool isNumber = false;
  const double value = plain.toDouble(&isNumber);
  if (!isNumber || std::isnan(value) || !config::isLegal(decl, value)) return std::nullopt;
  return value;
}

QString rangeText(const ParamDecl& decl) {
  return say("%1 to %2")
      .arg(valueText(decl, decl.lowest), join(valueText(decl, decl.highest), sayCore(std::string(decl.unit))));
}

}  // namespace stillcut::ui
