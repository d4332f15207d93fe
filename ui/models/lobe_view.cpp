#include "ui/models/lobe_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/base/format.h"
#include "ui/base/say.h"

namespace stillcut::ui {
namespace {

// Points closer together than this are one point on the screen.
constexpr double kSameSpeed = 0.005;
constexpr double kSameDepth = 20e-6;  // [m]
constexpr Metres kRounding(1e-9);     // between units
constexpr double kPlateau = 0.01;     // of its depth: no cut is set more finely than that

double removalRate(const LobeFrame& frame, Rpm speed, Metres depth) {
  return depth.value * frame.widthOfCut.value * frame.feedPerTooth.value * frame.teeth * speed.value / 60.0;
}

// Where nobody has said what the machine reaches, nothing is out of reach.
bool within(Rpm speed, const LobeFrame& frame) {
  if (!(frame.reachHigh > frame.reachLow)) return true;
  return speed >= frame.reachLow && speed <= frame.reachHigh;
}

// Speed at which the straight line between two limits meets `depth`.
Rpm crossing(const LobeLimit& a, const LobeLimit& b, Metres depth) {
  const double rise = b.depth.value - a.depth.value;
  const double part = std::abs(rise) > 0.0 ? (depth.value - a.depth.value) / rise : 0.5;
  return a.speed + (b.speed - a.speed) * std::clamp(part, 0.0, 1.0);
}

// The speeds looked at on both sides, the same twice where `speed` is one of them; none outside the diagram.
std::optional<std::pair<const LobeLimit*, const LobeLimit*>> limitsAround(const LobeDiagram& diagram, Rpm speed) {
  const auto& limits = diagram.limits;
  if (limits.empty() || speed < limits.front().speed || speed > limits.back().speed) return std::nullopt;
  const auto after = std::lower_bound(limits.begin(), limits.end(), speed,
                                      [](const LobeLimit& limit, Rpm s) { return limit.speed < s; });
  return std::pair{after->speed == speed ? &*after : &*(after - 1), &*after};
}

// In a pocket of the limits `first` .. `last`. The edges of the deepest stretch are where it is the least safe, so the
// middle of it is the best; where the override does not reach that far, the nearest speed that it reaches.
void findBest(Pocket& pocket, const LobeDiagram& diagram, std::size_t first, std::size_t last, const LobeFrame& frame) {
  const auto& limits = diagram.limits;
  std::size_t deepest = first;
  for (std::size_t k = first; k <= last; ++k) {
    const bool reached = within(limits[k].speed, frame);
    const bool deeper = limits[k].depth > limits[deepest].depth;
    if (reached == pocket.reachable ? deeper : reached) deepest = k;
    pocket.reachable = pocket.reachable || reached;
  }
  const Metres plateau = limits[deepest].depth * (1.0 - kPlateau);
  std::size_t left = deepest, right = deepest;
  while (left > first && limits[left - 1].depth >= plateau) --left;
  while (right < last && limits[right + 1].depth >= plateau) ++right;
  pocket.best = (limits[left].speed + limits[right].speed) * 0.5;
  const bool reachKnown = frame.reachHigh > frame.reachLow;
  if (pocket.reachable && reachKnown) pocket.best = std::clamp(pocket.best, frame.reachLow, frame.reachHigh);
  pocket.limit = limitAt(diagram, pocket.best).value_or(limits[deepest].depth);
  pocket.limited = !openBelow(diagram, pocket.best);
}

}  // namespace

std::optional<Metres> limitAt(const LobeDiagram& diagram, Rpm speed) {
  const auto around = limitsAround(diagram, speed);
  if (!around) return std::nullopt;
  const auto& [before, after] = *around;
  if (before == after) return after->depth;
  const double part = (speed - before->speed) / (after->speed - before->speed);
  return before->depth + (after->depth - before->depth) * part;
}

bool openBelow(const LobeDiagram& diagram, Rpm speed) {
  const auto around = limitsAround(diagram, speed);
  return around && !around->first->limited && !around->second->limited;
}

bool onIsland(const LobeDiagram& diagram, Rpm speed, Metres depth) {
  const auto quiet = [depth](const LobeLimit& limit) {
    return std::any_of(limit.islands.begin(), limit.islands.end(),
                       [depth](const DepthSpan& span) { return depth > span.from && depth < span.to; });
  };
  const auto around = limitsAround(diagram, speed);
  return around && quiet(*around->first) && quiet(*around->second);
}

std::vector<Pocket> pocketsAt(const LobeDiagram& diagram, const LobeFrame& frame, Metres depth) {
  std::vector<Pocket> out;
  const auto& limits = diagram.limits;
  const auto quiet = [depth](const LobeLimit& l) {
    return l.depth > depth || (!l.limited && depth <= l.depth + kRounding);
  };
  for (std::size_t first = 0; first < limits.size();) {
    if (!quiet(limits[first])) {
      ++first;
      continue;
    }
    std::size_t last = first;
    while (last + 1 < limits.size() && quiet(limits[last + 1])) ++last;
    Pocket pocket;
    pocket.open = first == 0 || last + 1 == limits.size();
    pocket.from = first == 0 ? limits[0].speed : crossing(limits[first - 1], limits[first], depth);
    pocket.to = last + 1 == limits.size() ? limits[last].speed : crossing(limits[last], limits[last + 1], depth);
    findBest(pocket, diagram, first, last, frame);
    pocket.removal = removalRate(frame, pocket.best, depth);
    out.push_back(pocket);
    first = last + 1;
  }
  return out;
}

std::vector<Pocket> pocketsAt(const LobeDiagram* diagram, const LobeFrame& frame, Metres depth,
                              const LobeCloseUp* closeUp) {
  if (closeUp != nullptr && closeUp->pocketsKnown && closeUp->at.depth == depth) return closeUp->pockets;
  return diagram != nullptr ? pocketsAt(*diagram, frame, depth) : std::vector<Pocket>{};
}

namespace {

// What is known of one place, whoever has computed it.
struct Here {
  Metres limit;
  bool open = false;    // no limit was found down to `limit`
  bool island = false;  // stable above the limit
};

std::optional<Here> hereOf(const LobeDiagram* diagram, const SpeedDepth& at, const LobeCloseUp* closeUp) {
  if (closeUp != nullptr && closeUp->at == at && closeUp->limit) {
    const LobeLimit& limit = *closeUp->limit;
    const bool island = std::ranges::any_of(
        limit.islands, [&at](const DepthSpan& span) { return at.depth > span.from && at.depth < span.to; });
    return Here{limit.depth, !limit.limited, island};
  }
  const auto limit = diagram != nullptr ? limitAt(*diagram, at.speed) : std::nullopt;
  if (!limit || !(limit->value > 0.0)) return std::nullopt;
  return Here{*limit, openBelow(*diagram, at.speed), onIsland(*diagram, at.speed, at.depth)};
}

// Speeds of one pocket are alike for chatter, and unlike for what the teeth shake.
QString quietestOf(const SpeedDepth& at, const LobeCloseUp* closeUp) {
  if (closeUp == nullptr || !closeUp->pocketsKnown || closeUp->at.depth != at.depth) return {};
  const auto around = std::ranges::find_if(
      closeUp->pockets, [&at](const Pocket& pocket) { return pocket.from <= at.speed && at.speed <= pocket.to; });
  if (around == closeUp->pockets.end() || !(around->quietest.value > 0.0)) return {};
  return say("the teeth shake least at %1, %2")
      .arg(join(number(around->quietest.value), rpmUnit()),
           join(significant(around->vibration), QStringLiteral("m/s\u00b2")));
}

}  // namespace

WhatIf whatIf(const LobeDiagram* diagram, const LobeFrame& frame, const SpeedDepth& at, UnitSystem units,
              const LobeCloseUp* closeUp) {
  WhatIf out;
  const auto here = hereOf(diagram, at, closeUp);
  if (!here) {
    out.verdict = say("Not computed here");
    out.detail = diagram ? say("The diagram does not reach this speed") : say("Compute the diagram first");
    return out;
  }
  const Metres limit = here->limit, depth = at.depth;
  if (here->open && depth > limit + kRounding) {
    out.verdict = say("Not computed so deep");
    out.detail = say("no limit found down to %1").arg(depthText(limit, units));
    return out;
  }
  out.known = true;
  out.stable = depth < limit || here->island || here->open;
  const double margin = 100.0 * (limit / std::max(depth, Metres(1e-9)) - 1.0);
  out.tone = out.stable ? Tone::Normal : Tone::Chatter;
  out.verdict = here->open     ? say("STABLE, no limit found down to %1").arg(depthText(limit, units))
                : here->island ? say("STABLE, on an island above the limit: less depth would chatter")
                : out.stable
                    ? say("STABLE, %1 deeper would be too deep").arg(join(number(margin), QStringLiteral("%")))
                    : say("CHATTER, %1 too deep").arg(join(number(100.0 * (depth / limit - 1.0)), QStringLiteral("%")));
  QStringList parts{here->open ? say("limit deeper than %1").arg(depthText(limit, units))
                               : say("limit %1").arg(depthText(limit, units))};
  if (frame.feedPerTooth.value > 0.0) {
    parts << say("removes %1").arg(removalText(removalRate(frame, at.speed, depth), units));
    if (frame.programmed.value > 0.0) {
      const double saved = 100.0 * (frame.programmed / at.speed - 1.0);
      if (std::abs(saved) >= 0.5) {
        const QString amount = join(number(std::abs(saved)), QStringLiteral("%"));
        parts << (saved > 0.0 ? say("%1 more time").arg(amount) : say("%1 less time").arg(amount));
      }
    }
  }
  if (const QString quietest = quietestOf(at, closeUp); !quietest.isEmpty()) parts << quietest;
  out.detail = parts.join(say(", "));
  return out;
}

std::vector<MetPoint> pointsMet(const RunHistory& history, const LobeService& service) {
  std::vector<MetPoint> out;
  for (const WorkingPoint& point : history.points()) {
    const MetPoint met{point.speed, service.axialDepthAt(point.time), point.state};
    const bool same = !out.empty() && out.back().state == met.state &&
                      std::abs(met.speed / out.back().speed - 1.0) < kSameSpeed &&
                      std::abs((met.depth - out.back().depth).value) < kSameDepth;
    if (!same) out.push_back(met);
  }
  return out;
}

void PocketTable::setPockets(std::vector<Pocket> pockets, UnitSystem units) {
  if (pockets == pockets_ && units == units_) return;  // whoever goes through them with the keys stays where he is
  beginResetModel();
  pockets_ = std::move(pockets);
  units_ = units;
  endResetModel();
}

int PocketTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(pockets_.size());
}

int PocketTable::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : kColumns;
}

QVariant PocketTable::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
  const Pocket& p = pocket(index.row());
  if (role == Qt::TextAlignmentRole) return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  if (role == Qt::ToolTipRole) return hintOf(p, static_cast<Column>(index.column()));
  if (role != Qt::DisplayRole && role != Qt::AccessibleTextRole) return {};
  switch (static_cast<Column>(index.column())) {
    case Speeds:
      return QStringLiteral("%1\u2013%2").arg(number(p.from.value), number(p.to.value));
    case Best:
      return p.reachable ? number(p.best.value) : tr("(%1)").arg(number(p.best.value));
    case Limit:
      return p.limited ? depthText(p.limit, units_) : tr("> %1").arg(depthText(p.limit, units_));
    case Removal:
      return p.removal > 0.0 ? significant(removalIn(p.removal, units_), 3) : number(std::nan(""));
    case kColumns:
      break;
  }
  return {};
}

QVariant PocketTable::hintOf(const Pocket& pocket, Column column) const {
  if (column == Limit && !pocket.limited) return tr("No limit found: the search ended there");
  return pocket.reachable ? QVariant() : QVariant(tr("Beyond what the speed override reaches"));
}

QVariant PocketTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (role != Qt::DisplayRole || orientation != Qt::Horizontal || section < 0 || section >= kColumns) return {};
  switch (static_cast<Column>(section)) {
    case Speeds:
      return tr("stable, rpm");
    case Best:
      return tr("best, rpm");
    case Limit:
      return tr("down to");
    case Removal:
      return removalUnit(units_);
    case kColumns:
      break;
  }
  return {};
}

}  // namespace stillcut::ui
