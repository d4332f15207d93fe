#include "ui/models/lobe_view.h"

#include <algorithm>
#include <cmath>

#include "ui/models/format.h"
#include "ui/models/say.h"

namespace stillcut::ui {
namespace {

// Points closer together than this are one point on the screen.
constexpr double kSameSpeed = 0.005;
constexpr double kSameDepth = 20e-6;  // [m]

double removalRate(const LobeFrame& frame, Rpm speed, Metres depth) {
  return depth.value * frame.widthOfCut.value * frame.feedPerTooth.value * frame.teeth * speed.value / 60.0;
}

bool within(Rpm speed, const LobeFrame& frame) {
  return speed >= frame.reachLow && speed <= frame.reachHigh;
}

// Speed at which the straight line between two limits meets `depth`.
Rpm crossing(const LobeLimit& a, const LobeLimit& b, Metres depth) {
  const double rise = b.depth.value - a.depth.value;
  const double part = std::abs(rise) > 0.0 ? (depth.value - a.depth.value) / rise : 0.5;
  return a.speed + (b.speed - a.speed) * std::clamp(part, 0.0, 1.0);
}

}  // namespace

std::optional<Metres> limitAt(const LobeDiagram& diagram, Rpm speed) {
  const auto& limits = diagram.limits;
  if (limits.empty() || speed < limits.front().speed || speed > limits.back().speed) return std::nullopt;
  const auto after = std::lower_bound(limits.begin(), limits.end(), speed,
                                      [](const LobeLimit& limit, Rpm s) { return limit.speed < s; });
  if (after == limits.begin()) return after->depth;
  const auto before = after - 1;
  const double part = (speed - before->speed) / (after->speed - before->speed);
  return before->depth + (after->depth - before->depth) * part;
}

bool onIsland(const LobeDiagram& diagram, Rpm speed, Metres depth) {
  const auto& limits = diagram.limits;
  const auto quiet = [depth](const LobeLimit& limit) {
    return std::any_of(limit.islands.begin(), limit.islands.end(),
                       [depth](const DepthSpan& span) { return depth > span.from && depth < span.to; });
  };
  if (limits.empty() || speed < limits.front().speed || speed > limits.back().speed) return false;
  const auto after = std::lower_bound(limits.begin(), limits.end(), speed,
                                      [](const LobeLimit& limit, Rpm s) { return limit.speed < s; });
  return quiet(*after) && (after->speed == speed || quiet(*(after - 1)));
}

std::vector<Pocket> pocketsAt(const LobeDiagram& diagram, const LobeFrame& frame, Metres depth) {
  std::vector<Pocket> out;
  const auto& limits = diagram.limits;
  for (std::size_t k = 0; k < limits.size(); ++k) {
    const bool quiet = limits[k].depth > depth;
    const bool wasQuiet = k > 0 && limits[k - 1].depth > depth;
    if (quiet && !wasQuiet) {
      Pocket pocket;
      pocket.open = k == 0;
      pocket.from = k == 0 ? limits[0].speed : crossing(limits[k - 1], limits[k], depth);
      out.push_back(pocket);
    }
    if (quiet) {
      Pocket& pocket = out.back();
      if (limits[k].depth > pocket.limit) {
        pocket.limit = limits[k].depth;
        pocket.best = limits[k].speed;
      }
      pocket.to = limits[k].speed;
      pocket.reachable = pocket.reachable || within(limits[k].speed, frame);
    } else if (wasQuiet) {
      out.back().to = crossing(limits[k - 1], limits[k], depth);
    }
  }
  if (!out.empty() && !limits.empty() && limits.back().depth > depth) out.back().open = true;
  for (Pocket& pocket : out) pocket.removal = removalRate(frame, pocket.best, depth);
  return out;
}

WhatIf whatIf(const LobeDiagram* diagram, const LobeFrame& frame, Rpm speed, Metres depth, UnitSystem units) {
  WhatIf out;
  const auto limit = diagram ? limitAt(*diagram, speed) : std::nullopt;
  if (!limit || !(limit->value > 0.0)) {
    out.verdict = say("Not computed here");
    out.detail = diagram ? say("The diagram does not reach this speed") : say("Compute the diagram first");
    return out;
  }
  out.known = true;
  const bool island = onIsland(*diagram, speed, depth);
  out.stable = depth < *limit || island;
  const double margin = 100.0 * (*limit / std::max(depth, Metres(1e-9)) - 1.0);
  out.tone = out.stable ? Tone::Normal : Tone::Chatter;
  out.verdict =
      island       ? say("STABLE, on an island above the limit: less depth would chatter")
      : out.stable ? say("STABLE, %1 deeper would be too deep").arg(join(number(margin), QStringLiteral("%")))
                   : say("CHATTER, %1 too deep").arg(join(number(100.0 * (1.0 - *limit / depth)), QStringLiteral("%")));
  QStringList parts{say("limit %1").arg(depthText(*limit, units))};
  if (frame.feedPerTooth.value > 0.0) {
    parts << say("removes %1").arg(removalText(removalRate(frame, speed, depth), units));
    if (frame.programmed.value > 0.0) {
      const double saved = 100.0 * (frame.programmed / speed - 1.0);
      if (std::abs(saved) >= 0.5) {
        const QString amount = join(number(std::abs(saved)), QStringLiteral("%"));
        parts << (saved > 0.0 ? say("%1 more time").arg(amount) : say("%1 less time").arg(amount));
      }
    }
  }
  out.detail = parts.join(say(", "));
  return out;
}

std::vector<MetPoint> pointsMet(const RunHistory& history, const LobeService& service) {
  std::vector<MetPoint> out;
  for (const WorkingPoint& point : history.points()) {
    const bool unstable = point.state == CutState::Onset || point.state == CutState::Chatter;
    const MetPoint met{point.speed, service.depthAt(point.time), unstable};
    const bool same = !out.empty() && out.back().unstable == met.unstable &&
                      std::abs(met.speed / out.back().speed - 1.0) < kSameSpeed &&
                      std::abs((met.depth - out.back().depth).value) < kSameDepth;
    if (!same) out.push_back(met);
  }
  return out;
}

void PocketTable::setPockets(std::vector<Pocket> pockets, UnitSystem units) {
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
  if (role == Qt::ToolTipRole) return p.reachable ? QVariant() : QVariant(tr("Beyond what the speed override reaches"));
  if (role != Qt::DisplayRole && role != Qt::AccessibleTextRole) return {};
  switch (static_cast<Column>(index.column())) {
    case Speeds:
      return QStringLiteral("%1\u2013%2").arg(number(p.from.value), number(p.to.value));
    case Best:
      return p.reachable ? number(p.best.value) : tr("(%1)").arg(number(p.best.value));
    case Limit:
      return depthText(p.limit, units_);
    case Removal:
      return p.removal > 0.0 ? significant(removalIn(p.removal, units_), 3) : number(std::nan(""));
    case kColumns:
      break;
  }
  return {};
}

QVariant PocketTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (role != Qt::DisplayRole || orientation != Qt::Horizontal || section < 0 || section >= kColumns) return {};
  switch (static_cast<Column>(section)) {
    case Speeds:
      return tr("quiet, rpm");
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
