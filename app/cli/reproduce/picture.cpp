#include "app/cli/reproduce/picture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace stillcut::app {
namespace {

std::string number(double v) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", v);
  return text;
}

// A field of a table: in quotes where it holds what separates fields.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

std::string csvOf(const Panel& panel) {
  std::string text;
  const std::string name = field(panel.title);
  for (const Curve& given : panel.curves) {
    const Curve curve = thinned(given);
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      const std::string y = std::isfinite(curve.y[i]) ? number(curve.y[i]) : "";
      for (const std::string& cell : {name, field(curve.name), number(curve.x[i])}) text.append(cell).append(",");
      text.append(y).append("\n");
    }
  }
  for (const PlaceMark& mark : panel.marks)
    text += name + "," + field("mark: " + mark.name) + "," + number(mark.x) + ",\n";
  if (!panel.map) return text;
  const LevelMap& m = *panel.map;
  for (int c = 0; c < m.columns; ++c) {
    for (int r = 0; r < m.rows; ++r) {
      const double x = m.x0 + (c + 0.5) * (m.x1 - m.x0) / m.columns;
      const double y = m.y0 + (r + 0.5) * (m.y1 - m.y0) / m.rows;
      text +=
          name + "," + number(x) + "," + number(y) + "," +
          number(
              m.level[static_cast<std::size_t>(c) * static_cast<std::size_t>(m.rows) + static_cast<std::size_t>(r)]) +
          "\n";
    }
  }
  return text;
}

}  // namespace

Curve thinned(const Curve& curve, std::size_t columns) {
  if (curve.x.size() <= 2 * columns) return curve;
  Curve few{curve.name, {}, {}, curve.dashed};
  const std::size_t count = curve.x.size();
  for (std::size_t c = 0; c < columns; ++c) {
    const std::size_t from = c * count / columns;
    const std::size_t to = std::max(from + 1, (c + 1) * count / columns);
    std::size_t low = from, high = from;
    for (std::size_t i = from; i < to; ++i) {
      if (curve.y[i] < curve.y[low] || !std::isfinite(curve.y[low])) low = i;
      if (curve.y[i] > curve.y[high] || !std::isfinite(curve.y[high])) high = i;
    }
    for (const std::size_t i : {std::min(low, high), std::max(low, high)}) {
      few.x.push_back(curve.x[i]);
      few.y.push_back(curve.y[i]);
    }
  }
  return few;
}

std::string csvOf(const Picture& picture) {
  std::string text = "panel,curve,x,y\n";
  for (const Panel& panel : picture.panels) text += csvOf(panel);
  return text;
}

}  // namespace stillcut::app
