// A figure as data, painted as SVG and written as CSV: panels below one another, curves, marked places, a map of
// levels. Thread: any.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stillcut::app {

struct Curve {
  std::string name;
  std::vector<double> x, y;  // y not a number: a gap
  bool dashed = false;
};

// Upright line across the panel.
struct PlaceMark {
  double x = 0.0;
  std::string name;
};

// level[column * rows + row]; columns along x, rows along y from the bottom.
struct LevelMap {
  double x0 = 0.0, x1 = 1.0, y0 = 0.0, y1 = 1.0;
  int columns = 0, rows = 0;
  std::vector<double> level;
  std::string unit;
};

struct Panel {
  std::string title, xLabel, yLabel;
  std::vector<Curve> curves{};
  std::vector<PlaceMark> marks{};
  std::optional<LevelMap> map{};
  bool logY = false;
  std::optional<std::pair<double, double>> yRange{};  // empty: what the curves need
};

struct Picture {
  std::string title;
  std::vector<Panel> panels;
};

// As many points as a picture can show: of each of `columns` stretches the least and the greatest.
Curve thinned(const Curve& curve, std::size_t columns = 1500);

std::string svgOf(const Picture& picture);
// "panel,curve,x,y", of a map "panel,x,y,level" in its place; the points as painted.
std::string csvOf(const Picture& picture);

}  // namespace stillcut::app
