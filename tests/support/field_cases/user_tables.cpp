#include "tests/support/field_cases/user_tables.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <string_view>
#include <utility>

namespace stillcut::field {
namespace {

constexpr double kGravity = 9.81;       // m/s^2
constexpr double kVoltsPerUnit = 0.02;  // V per m/s^2, of the oscilloscopes
constexpr double kTriggered_s = 4.0;    // after the first row
constexpr std::size_t kShorter = 1000;  // rows of the second repeat
constexpr std::size_t kBadRow = 5000;

template <class... Values>
std::string formatted(const char* format, Values... values) {
  std::array<char, 160> line{};
  std::snprintf(line.data(), line.size(), format, values...);
  return line.data();
}

// What one row holds: s, m/s^2.
struct Row {
  std::size_t i;
  double t, x, y, z;
};

struct Form {
  int axes;
  std::string_view head;
  std::string (*row)(const Row& r);
  std::string_view tail = {};
  const char* suffix = ".csv";
};

std::string timeStampOf(const Row& r) {
  const auto micro = static_cast<long long>(std::nearbyint(r.t * 1e6));
  return formatted("2025-07-03T10:11:%02lld.%06lld", 12 + micro / 1000000, micro % 1000000);
}

std::string tektronixRow(const Row& r) {
  constexpr auto kBeside =
      std::to_array<const char*>({"Record Length,2.560000e+04,,", "Sample Interval,3.125000e-04,,", "Source,CH1,,"});
  const char* beside = r.i < kBeside.size() ? kBeside[r.i] : ",,,";
  return formatted("%s%.9f,%.6f,", beside, r.t - kTriggered_s, r.x * kVoltsPerUnit);
}

Form loggerForm(UserTable table) {
  switch (table) {
    case UserTable::Klipper:
      return {3, "#time,accel_x,accel_y,accel_z\n", [](const Row& r) {
                return formatted("%.6f,%.6f,%.6f,%.6f", 1234.5 + r.t, 1e3 * r.x, 1e3 * r.y, 1e3 * r.z);
              }};
    case UserTable::RepRapFirmware:
      return {3, "Sample,X,Y,Z\n",
              [](const Row& r) {
                return formatted("%zu,%.3f,%.3f,%.3f", r.i, r.x / kGravity, r.y / kGravity, r.z / kGravity);
              },
              "Rate 3200, overflows 0\n"};
    case UserTable::SensorLogger:
      return {3, "time,seconds_elapsed,z,y,x\n", [](const Row& r) {
                return formatted("%lld,%.9f,%.6f,%.6f,%.6f", 1700000000000000000LL + static_cast<long long>(r.t * 1e9),
                                 r.t, r.z, r.y, r.x);
              }};
    case UserTable::PhysicsToolbox:
      return {3, "time,gFx,gFy,gFz,TgF\n", [](const Row& r) {
                return formatted("%.4f,%.4f,%.4f,%.4f,1.000", r.t, r.x / kGravity, r.y / kGravity, r.z / kGravity);
              }};
    case UserTable::Artis:
      return {2, "TimeStamp;2025-07-03 14-07-22;2025-07-03 14-42-33\n", [](const Row& r) {
                const bool both = r.i < kTableRows - kShorter;
                return formatted("%.4f;%.6f;", r.t, r.x) + (both ? formatted("%.6f", r.y) : std::string());
              }};
    default:
      return {2, "timestamp,ax,ay\n", [](const Row& r) { return timeStampOf(r) + formatted(",%.5f,%.5f", r.x, r.y); }};
  }
}

Form oscilloscopeForm(UserTable table) {
  switch (table) {
    case UserTable::PicoScope:
      return {2, "Time,Channel A,Channel B\n(ms),(mV),(mV)\n\n", [](const Row& r) {
                return formatted("%.6f,%.6f,%.6f", 1e3 * (r.t - kTriggered_s), 1e3 * kVoltsPerUnit * r.x,
                                 1e3 * kVoltsPerUnit * r.y);
              }};
    case UserTable::Siglent:
      return {1,
              "Record Length,Analog:25600\nSample Interval,Analog:0.0003125\nVertical Units,CH1:V\nSource,CH1\n"
              "Second,Value\n",
              [](const Row& r) { return formatted("%.10f,%.6f", r.t - kTriggered_s, kVoltsPerUnit * r.x); }};
    case UserTable::Tektronix:
      return {1, "", tektronixRow};
    default:
      return {1,
              "Sample Rate: 3200 Hz. Sample values on linear scale.\n"
              "Length processed: 25600 samples, 8.00000 seconds. One column per channel.\n\n",
              [](const Row& r) { return formatted("%.6f", kVoltsPerUnit * r.x); },
              {},
              ".txt"};
  }
}

Form plainForm(UserTable table) {
  const auto twoAxes = [](const Row& r) { return formatted("%.7f,%.5f,%.5f", r.t, r.x, r.y); };
  switch (table) {
    case UserTable::OneBadCell:
      return {1, "Time (s),X (m/s^2)\n", [](const Row& r) {
                return formatted("%.7f,", r.t) + (r.i == kBadRow ? std::string("NaN") : formatted("%.5f", r.x));
              }};
    case UserTable::CutMidLine:
      return {2, "Time (s),X (m/s^2),Y (m/s^2)\n", twoAxes, "8.0003125,1.2"};
    default:
      return {2, "Time (s),Accel X (m/s^2),Accel Y (m/s^2)\n", twoAxes};
  }
}

Form formOf(UserTable table) {
  switch (table) {
    case UserTable::Control:
    case UserTable::OneBadCell:
    case UserTable::CutMidLine:
      return plainForm(table);
    case UserTable::PicoScope:
    case UserTable::Siglent:
    case UserTable::Tektronix:
    case UserTable::Audacity:
      return oscilloscopeForm(table);
    default:
      return loggerForm(table);
  }
}

}  // namespace

FileCase userTable(const TableCut& s, UserTable table) {
  const Form form = formOf(table);
  const TableSamples samples = tableSamples(s);
  std::string text(form.head);
  for (std::size_t i = 0; i < kTableRows; ++i) {
    text += form.row({i, samples.t[i], samples.x[i], samples.y[i], samples.z[i]});
    text += '\n';
  }
  text += form.tail;
  return {tableCase(s, samples, form.axes), form.suffix, std::move(text)};
}

}  // namespace stillcut::field
