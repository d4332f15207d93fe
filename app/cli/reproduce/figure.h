// A figure or table of one of the five papers that can be made from our simulation. Each paper has a source that adds
// its rows to the one list.
// Thread: one.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/reproduce/picture.h"
#include "core/base/result.h"
#include "core/milling/simulation/scenario.h"

namespace stillcut::app {

inline constexpr double kNotPrinted = std::numeric_limits<double>::quiet_NaN();

struct PaperNumber {
  std::string name, unit;
  double paper = kNotPrinted;  // not a number: the paper does not print it
  double ours = kNotPrinted;
  std::string remark{};
};

struct FigureResult {
  Picture picture;
  std::vector<PaperNumber> numbers{};
  std::vector<std::pair<std::string, std::string>> tables{};  // name of a further file, its content
};

struct Figure {
  std::string id;     // "van-dijk-9"
  std::string paper;  // "van Dijk 2010, figure 9"
  std::string shows;
  std::function<Result<FigureResult>()> make;
};

const std::vector<Figure>& figures();

void addVanDijkFigures(std::vector<Figure>& list);
void addLiaoFigures(std::vector<Figure>& list);
void addCaliskanFigures(std::vector<Figure>& list);
void addXuFigures(std::vector<Figure>& list);
void addFordFigures(std::vector<Figure>& list);

// One of those that come with the program, by its name.
Result<milling::Scenario> paperScenario(const std::string& name);

}  // namespace stillcut::app
