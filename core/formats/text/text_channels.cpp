// Which columns of a text recording are channels: the rules of resources/manual/recordings.md, in their order.
#include <algorithm>
#include <utility>

#include "core/formats/column_reader.h"
#include "core/formats/text/text_layout.h"
#include "core/units/unit_names.h"

namespace stillcut::record {
namespace {

RecordedChannel channelOf(const TextColumn& column, int index) {
  RecordedChannel channel = channelFromWords(column.name, column.unit);
  if (column.name.empty()) channel.info.name = "column " + std::to_string(index);
  return channel;
}

bool isSensorUnit(const TextColumn& column) {
  const std::optional<UnitMeaning> unit = unitFromText(column.unit);
  return unit && (unit->kind == UnitKind::Sensor || unit->kind == UnitKind::Voltage);
}

bool isSpeed(const TextColumn& column) {
  const std::optional<UnitMeaning> unit = unitFromText(column.unit);
  return (unit && unit->quantity == SensorQuantity::SpindleSpeed) ||
         meaningOfName(column.name) == NameMeaning::SpindleSpeed;
}

// Everything but the question of spindle speed; empty: it is a signal.
Message whyNoSignal(const TextColumn& column, bool unitsGiven) {
  if (column.stamps) return message("it holds times");
  if (column.words) return message("it holds words");
  if (column.rowNumber) return message("it counts the rows");
  const NameMeaning meaning = meaningOfName(column.name);
  if (meaning == NameMeaning::NoSignal) return message("its name says that it is no vibration");
  if (meaning == NameMeaning::Time && column.unit.empty()) return message("it holds times");
  if (unitsGiven && column.unit.empty()) return message("it has no unit, where other columns have one");
  const std::optional<UnitMeaning> unit = unitFromText(column.unit);
  if (!unit || unit->kind == UnitKind::Sensor || unit->kind == UnitKind::Voltage) return {};
  return message("its unit '%1' is none of a vibration", column.unit);
}

TextChannels choose(const TextLayout& layout, bool speed) {
  const bool unitsGiven = std::any_of(layout.columns.begin(), layout.columns.end(), isSensorUnit);
  TextChannels chosen;
  for (std::size_t i = 0; i < layout.columns.size(); ++i) {
    const TextColumn& column = layout.columns[i];
    if (static_cast<int>(i) == layout.timeColumn || column.empty) continue;
    Message why = whyNoSignal(column, unitsGiven);
    if (why.empty() && isSpeed(column) && !speed) why = message("it is a speed of the spindle");
    if (why.empty() && isSpeed(column) == speed) {
      chosen.columns.push_back(static_cast<int>(i));
      chosen.channels.push_back(channelOf(column, static_cast<int>(i)));
    } else {
      chosen.skipped.push_back(column.name.empty() ? "column " + std::to_string(i) : column.name);
      chosen.skippedWhy.push_back(std::move(why));
    }
  }
  return chosen;
}

}  // namespace

Result<TextChannels> chooseTextChannels(const TextLayout& layout, const ReadOptions& options,
                                        const std::string& where) {
  TextChannels chosen = choose(layout, false);
  const bool speedWanted = options.quantity == SensorQuantity::SpindleSpeed;
  if (chosen.channels.empty() || speedWanted) {
    TextChannels speeds = choose(layout, true);
    if (!speeds.channels.empty()) chosen = std::move(speeds);
  }
  if (chosen.channels.empty())
    return Error{where, message("no column is a channel"), message("all are time, indicators or empty")};
  Result<std::vector<RecordedChannel>> kept = keepChannels(chosen.channels, options.channels, where);
  if (!kept) return kept.error();
  if (!options.channels.empty()) {
    std::vector<int> columns;
    for (const int c : options.channels) columns.push_back(chosen.columns[static_cast<std::size_t>(c)]);
    chosen.columns = std::move(columns);
  }
  chosen.channels = std::move(*kept);
  if (const Status s = applyOptions(chosen.channels, options); !s) return s.error();
  return chosen;
}

}  // namespace stillcut::record
