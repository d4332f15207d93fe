// Paints a Picture. White ground, the colours of Okabe and Ito, which every eye can distinguish.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "app/cli/reproduce/picture.h"

namespace stillcut::app {
namespace {

constexpr double kWidth = 960.0, kLeft = 84.0, kRight = 150.0, kTitle = 40.0;
constexpr double kPanel = 210.0, kTop = 26.0, kBottom = 42.0;
constexpr std::array<const char*, 7> kColours{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                              "#56B4E9", "#E69F00", "#000000"};

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  void add(double v) {
    if (!std::isfinite(v)) return;
    low = std::min(low, v);
    high = std::max(high, v);
  }
  bool empty() const { return !(high >= low); }
};

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    out += c == '<'   ? std::string("&lt;")
           : c == '>' ? std::string("&gt;")
           : c == '&' ? std::string("&amp;")
                      : std::string(1, c);
  }
  return out;
}

template <typename... Values>
std::string format(const char* form, Values... values) {
  char text[256];
  std::snprintf(text, sizeof text, form, values...);
  return text;
}

// 1, 2 or 5 times a power of ten, so that about five fit.
double tickStep(double span) {
  const double rough = span / 5.0;
  const double decade = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double times : {1.0, 2.0, 5.0}) {
    if (times * decade >= rough) return times * decade;
  }
  return 10.0 * decade;
}

class PanelPainter {
 public:
  PanelPainter(const Panel& panel, double top) : panel_(panel), top_(top + kTop), bottom_(top + kPanel - kBottom) {
    for (const Curve& c : panel.curves) curves_.push_back(thinned(c));
    measure();
  }

  std::string paint() {
    svg_ += format("<text x='%.0f' y='%.0f' font-weight='bold'>%s</text>\n", kLeft, top_ - 8.0,
                   escaped(panel_.title).c_str());
    if (panel_.map) paintMap(*panel_.map);
    paintAxes();
    for (const PlaceMark& mark : panel_.marks) paintMark(mark);
    for (std::size_t i = 0; i < curves_.size(); ++i) paintCurve(curves_[i], i);
    if (panel_.map) paintKey(*panel_.map);
    return svg_;
  }

 private:
  double value(double y) const { return panel_.logY ? (y > 0.0 ? std::log10(y) : std::nan("")) : y; }
  double atX(double x) const { return kLeft + (x - x_.low) / (x_.high - x_.low) * (kWidth - kLeft - kRight); }
  double atY(double y) const { return bottom_ - (y - y_.low) / (y_.high - y_.low) * (bottom_ - top_); }

  void measure() {
    for (const Curve& c : curves_) {
      for (const double x : c.x) x_.add(x);
      for (const double y : c.y) y_.add(value(y));
    }
    if (panel_.map) {
      for (const double x : {panel_.map->x0, panel_.map->x1}) x_.add(x);
      for (const double y : {panel_.map->y0, panel_.map->y1}) y_.add(y);
    } else if (panel_.yRange) {
      y_ = {value(panel_.yRange->first), value(panel_.yRange->second)};
    } else if (!y_.empty() && !panel_.logY) {
      const double room = 0.05 * (y_.high - y_.low);
      y_ = {y_.low - (y_.low == 0.0 ? 0.0 : room), y_.high + room};
    }
    for (Range* r : {&x_, &y_}) {
      if (r->empty()) *r = {0.0, 1.0};
      if (r->high - r->low < 1e-12 * std::max(1.0, std::abs(r->high))) *r = {r->low - 0.5, r->high + 0.5};
    }
    // A map of eight decades shows all that a figure can.
    if (panel_.logY) y_.low = std::max(y_.low, y_.high - 8.0);
  }

  void paintAxes() {
    svg_ += format("<rect x='%.1f' y='%.1f' width='%.1f' height='%.1f' fill='none' stroke='#444'/>\n", kLeft, top_,
                   kWidth - kLeft - kRight, bottom_ - top_);
    const double dx = tickStep(x_.high - x_.low);
    for (double x = std::ceil(x_.low / dx) * dx; x <= x_.high + 1e-9 * dx; x += dx) {
      svg_ += format("<path d='M%.1f %.1fv4' stroke='#444'/>", atX(x), bottom_);
      svg_ += format("<text x='%.1f' y='%.1f' text-anchor='middle'>%.6g</text>\n", atX(x), bottom_ + 16.0,
                     std::abs(x) < 1e-9 * dx ? 0.0 : x);
    }
    const double dy = panel_.logY ? std::max(1.0, tickStep(y_.high - y_.low)) : tickStep(y_.high - y_.low);
    for (double y = std::ceil(y_.low / dy) * dy; y <= y_.high + 1e-9 * dy; y += dy) {
      const double shown = panel_.logY ? std::pow(10.0, y) : std::abs(y) < 1e-9 * dy ? 0.0 : y;
      svg_ += format("<path d='M%.1f %.1fh-4' stroke='#444'/>", kLeft, atY(y));
      svg_ += format("<text x='%.1f' y='%.1f' text-anchor='end'>%.4g</text>\n", kLeft - 7.0, atY(y) + 4.0, shown);
    }
    const double middle = 0.5 * (top_ + bottom_);
    svg_ += format("<text x='%.1f' y='%.1f' text-anchor='middle'>%s</text>\n", 0.5 * (kLeft + kWidth - kRight),
                   bottom_ + 32.0, escaped(panel_.xLabel).c_str());
    svg_ += format("<text transform='translate(16 %.1f) rotate(-90)' text-anchor='middle'>%s</text>\n", middle,
                   escaped(panel_.yLabel).c_str());
  }

  void paintMark(const PlaceMark& mark) {
    if (!(mark.x >= x_.low && mark.x <= x_.high)) return;
    const double x = atX(mark.x);
    svg_ += format("<path d='M%.1f %.1fV%.1f' stroke='#999' stroke-dasharray='4 3'/>", x, top_, bottom_);
    svg_ += format("<text x='%.1f' y='%.1f' fill='#555'>%s</text>\n", x + 3.0, top_ + 12.0, escaped(mark.name).c_str());
  }

  void paintCurve(const Curve& curve, std::size_t index) {
    const char* colour = kColours[index % kColours.size()];
    std::string path;
    bool pen = false;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      const double y = value(curve.y[i]);
      if (!std::isfinite(y)) {
        pen = false;
        continue;
      }
      path += format(pen ? "L%.1f %.1f" : "M%.1f %.1f", atX(curve.x[i]), atY(std::clamp(y, y_.low, y_.high)));
      pen = true;
    }
    svg_ += "<path d='" + path + "' fill='none' stroke='" + colour + "'" +
            (curve.dashed ? " stroke-dasharray='6 3'" : "") + "/>\n";
    if (curve.name.empty()) return;
    const double at = top_ + 12.0 + 16.0 * static_cast<double>(index);
    svg_ += format("<path d='M%.1f %.1fh18' stroke='%s' stroke-width='2'/>", kWidth - kRight + 8.0, at - 4.0, colour);
    svg_ += format("<text x='%.1f' y='%.1f'>%s</text>\n", kWidth - kRight + 30.0, at, escaped(curve.name).c_str());
  }

  // Sixty decibels, or what there is, from white to black through blue; equal neighbours of a column are one.
  static constexpr double kDepth = 60.0;
  static constexpr int kShades = 24;
  static std::string shade(int s) {
    const double part = static_cast<double>(s) / (kShades - 1);
    return format("#%02x%02x%02x", static_cast<int>(255.0 * (1.0 - part)),
                  static_cast<int>(255.0 * (1.0 - part * part * 0.9)), static_cast<int>(255.0 - 130.0 * part * part));
  }
  Range levels(const LevelMap& m) const {
    Range r;
    for (const double v : m.level) r.add(v);
    if (r.empty()) return {0.0, 1.0};
    return {std::max(r.low, r.high - kDepth), std::max(r.high, r.low + 1e-9)};
  }
  void paintMap(const LevelMap& m) {
    const Range range = levels(m);
    const double dx = (m.x1 - m.x0) / m.columns, dy = (m.y1 - m.y0) / m.rows;
    const auto shadeOf = [&](int c, int r) {
      const double v =
          m.level[static_cast<std::size_t>(c) * static_cast<std::size_t>(m.rows) + static_cast<std::size_t>(r)];
      const double part = (v - range.low) / (range.high - range.low);
      return std::isfinite(part) ? std::clamp(static_cast<int>(part * kShades), 0, kShades - 1) : 0;
    };
    svg_ += "<g shape-rendering='crispEdges'>\n";
    for (int c = 0; c < m.columns; ++c) {
      for (int r = 0; r < m.rows;) {
        const int s = shadeOf(c, r), first = r;
        while (r < m.rows && shadeOf(c, r) == s) ++r;
        if (s == 0) continue;
        const double left = atX(m.x0 + c * dx), right = atX(m.x0 + (c + 1) * dx);
        const double low = atY(m.y0 + first * dy), high = atY(m.y0 + r * dy);
        svg_ += format("<rect x='%.1f' y='%.1f' width='%.1f' height='%.1f' fill='%s'/>", left, high, right - left,
                       low - high, shade(s).c_str());
      }
    }
    svg_ += "</g>\n";
  }
  void paintKey(const LevelMap& m) {
    const Range range = levels(m);
    const double x = kWidth - kRight + 12.0, step = (bottom_ - top_) / kShades;
    for (int s = 0; s < kShades; ++s) {
      svg_ += format("<rect x='%.1f' y='%.2f' width='14' height='%.2f' fill='%s'/>", x, bottom_ - (s + 1) * step,
                     step + 0.3, shade(s).c_str());
    }
    svg_ +=
        format("<text x='%.1f' y='%.1f'>%.4g %s</text>\n", x + 20.0, top_ + 10.0, range.high, escaped(m.unit).c_str());
    svg_ += format("<text x='%.1f' y='%.1f'>%.4g</text>\n", x + 20.0, bottom_, range.low);
  }

  const Panel& panel_;
  double top_, bottom_;
  std::vector<Curve> curves_;
  Range x_, y_;
  std::string svg_;
};

}  // namespace

std::string svgOf(const Picture& picture) {
  const double height = kTitle + kPanel * static_cast<double>(picture.panels.size());
  std::string svg = format(
      "<svg xmlns='http://www.w3.org/2000/svg' width='%.0f' height='%.0f' viewBox='0 0 %.0f %.0f' "
      "font-family='DejaVu Sans, sans-serif' font-size='12'>\n<rect width='100%%' height='100%%' fill='white'/>\n",
      kWidth, height, kWidth, height);
  svg += "<text x='" + format("%.0f", kLeft) + "' y='24' font-size='15'>" + escaped(picture.title) + "</text>\n";
  double top = kTitle;
  for (const Panel& panel : picture.panels) {
    svg += PanelPainter(panel, top).paint();
    top += kPanel;
  }
  return svg + "</svg>\n";
}

}  // namespace stillcut::app
