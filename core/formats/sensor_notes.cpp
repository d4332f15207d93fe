#include "core/formats/sensor_notes.h"

#include <cmath>
#include <cstdio>

#include "core/formats/variable_channels.h"
#include "core/storage/hdf5_file.h"

namespace stillcut::record {
namespace {

constexpr const char* kSensitivity = "sensitivity_mv";  // per g for acceleration, else per SI unit
constexpr const char* kVolts = "volts";                 // of one device unit
constexpr const char* kCoupling = "coupling";
constexpr const char* kPlace = "place";

double told(double value) {
  return std::isfinite(value) && value > 0.0 ? value : 0.0;
}

}  // namespace

bool writeSensor(hid_t dataset, const ChannelInfo& info) {
  return (info.sensitivity == 0.0 || writeNumber(dataset, kSensitivity, info.sensitivity)) &&
         (info.volts == 0.0 || writeNumber(dataset, kVolts, info.volts)) &&
         (info.coupling.empty() || writeText(dataset, kCoupling, info.coupling)) &&
         (info.place.empty() || writeText(dataset, kPlace, info.place));
}

void readSensor(hid_t dataset, ChannelInfo& info) {
  info.sensitivity = told(readNumber(dataset, kSensitivity).value_or(0.0));
  info.volts = told(readNumber(dataset, kVolts).value_or(0.0));
  info.coupling = cleanName(readText(dataset, kCoupling).value_or(""));
  info.place = cleanName(readText(dataset, kPlace).value_or(""));
}

void takeSensor(const ChannelInfo& from, ChannelInfo& to) {
  to.sensitivity = from.sensitivity;
  to.volts = from.volts;
  to.coupling = from.coupling;
  to.place = from.place;
}

std::string sensorText(const ChannelInfo& info) {
  std::string text;
  const auto add = [&text](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  char number[40];
  if (info.sensitivity > 0.0) {
    std::snprintf(number, sizeof number, "%.6g mV/%s", info.sensitivity,
                  info.quantity == SensorQuantity::Acceleration ? "g" : std::string(siUnit(info.quantity)).c_str());
    add(number);
  }
  if (info.volts > 0.0) {
    std::snprintf(number, sizeof number, "%.6g V", info.volts);
    add(number);
  }
  if (!info.coupling.empty()) add(info.coupling);
  if (!info.place.empty()) add("at " + info.place);
  return text;
}

}  // namespace stillcut::record
