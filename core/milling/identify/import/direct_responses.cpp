#include "core/milling/identify/import/direct_responses.h"

#include <algorithm>

namespace stillcut::identify {
namespace {

std::string listOf(const std::vector<OfferedResponse>& offered) {
  std::string all;
  for (const OfferedResponse& o : offered) {
    std::string one = "'" + o.name + "'";
    if (o.along != Axis::Unknown) one += " along " + std::string(name(o.along));
    all += (all.empty() ? "" : ", ") + one;
  }
  return all;
}

bool isCross(const OfferedResponse& o) {
  return o.along != Axis::Unknown && o.force != Axis::Unknown && o.along != o.force;
}

// Indices of what may be the direct response along `axis`.
std::vector<std::size_t> along(const std::vector<OfferedResponse>& offered, Axis axis) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < offered.size(); ++i) {
    if (offered[i].along == axis) found.push_back(i);
  }
  // A direct one makes its cross ones superfluous; where a record's one force is said to be along another axis, the
  // person who asks for this one knows better.
  std::vector<std::size_t> direct;
  std::copy_if(found.begin(), found.end(), std::back_inserter(direct),
               [&](std::size_t i) { return !isCross(offered[i]); });
  return direct.empty() ? found : direct;
}

Error ambiguous(const std::vector<OfferedResponse>& offered, const std::string& where, const std::string& option) {
  return Error{where, message("holds %1 responses: %2", std::to_string(offered.size()), listOf(offered)),
               message("name the one along the hit with %1, or the axis of the hit with --axis x, y or x,y", option)};
}

Result<Choice> choose(const std::vector<OfferedResponse>& offered, const std::vector<Axis>& axes,
                      const std::string& where, const std::string& option, bool takesCross) {
  Choice choice;
  for (const Axis axis : axes) {
    std::vector<std::size_t> found = along(offered, axis);
    const bool alone = offered.size() == 1 && axes.size() == 1 && offered[0].along == Axis::Unknown;
    if (found.empty() && alone) found.push_back(0);
    if (found.empty()) {
      return Error{where, message("holds no response along %1", std::string(name(axis))),
                   message("it holds %1", listOf(offered))};
    }
    if (found.size() > 1) return ambiguous(offered, where, option);
    if (isCross(offered[found[0]]) && !takesCross) {
      return Error{where,
                   message("its only response along %1 is a cross one, by a force along %2", std::string(name(axis)),
                           std::string(name(offered[found[0]].force))),
                   message("modes at the tip need the direct one; %1 takes it all the same", option)};
    }
    choice.responses.push_back({found[0], axis});
  }
  return choice;
}

// The axes that have a direct response, z aside: the tool does not chatter along its own axis in this model.
std::vector<Axis> axesOf(const std::vector<OfferedResponse>& offered) {
  std::vector<Axis> axes;
  for (const Axis axis : {Axis::X, Axis::Y}) {
    const bool any = std::any_of(offered.begin(), offered.end(),
                                 [&](const OfferedResponse& o) { return o.along == axis && !isCross(o); });
    if (any) axes.push_back(axis);
  }
  return axes;
}

void nameUnused(Choice& choice, const std::vector<OfferedResponse>& offered) {
  std::string names;
  for (std::size_t i = 0; i < offered.size(); ++i) {
    const bool taken = std::any_of(choice.responses.begin(), choice.responses.end(),
                                   [i](const ChosenResponse& c) { return c.offered == i; });
    if (!taken) names += (names.empty() ? "'" : ", '") + offered[i].name + "'";
  }
  if (!names.empty()) choice.remarks.push_back(message("not used: %1", names));
}

}  // namespace

Result<Choice> chooseResponses(const std::vector<OfferedResponse>& offered, const std::vector<Axis>& wanted,
                               const std::string& where, const std::string& option, ForceAxis force) {
  std::vector<Axis> axes = wanted;
  const bool forceKnown =
      std::all_of(offered.begin(), offered.end(), [](const OfferedResponse& o) { return o.force != Axis::Unknown; });
  if (axes.empty() && offered.size() == 1) axes = {offered[0].along};
  if (axes.empty() && forceKnown) axes = axesOf(offered);
  if (axes.empty()) return ambiguous(offered, where, option);
  std::sort(axes.begin(), axes.end());
  const bool takesCross = force == ForceAxis::Overruled && !wanted.empty();
  auto choice = choose(offered, axes, where, option, takesCross);
  if (!choice) return choice;
  nameUnused(*choice, offered);
  return choice;
}

Result<Choice> chooseCross(const std::vector<OfferedResponse>& offered, const std::string& where) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < offered.size(); ++i) {
    const bool alongZ = offered[i].along == Axis::Z || offered[i].force == Axis::Z;
    if (isCross(offered[i]) && !alongZ) found.push_back(i);
  }
  const auto unsaid = [](const OfferedResponse& o) { return o.along == Axis::Unknown || o.force == Axis::Unknown; };
  if (found.empty() && offered.size() == 1 && unsaid(offered[0])) found.push_back(0);
  if (found.empty()) {
    return Error{where, message("holds no response along one axis to a force along the other"),
                 message("it holds %1", listOf(offered))};
  }
  const OfferedResponse& first = offered[found[0]];
  for (const std::size_t i : found) {
    if (i == found[0] || offered[i].along != first.along) continue;
    return Error{where, message("holds several cross responses: %1", listOf(offered)),
                 message("a file with one of them is needed")};
  }
  Choice choice;
  choice.responses.push_back({found[0], first.along});
  nameUnused(choice, offered);
  return choice;
}

}  // namespace stillcut::identify
