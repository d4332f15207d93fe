#include "app/io/comedi_inputs.h"

#ifdef STILLCUT_COMEDI
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "core/daq/device_messages.h"

namespace stillcut::app {
namespace {

constexpr int kMostRanges = 8;  // that are listed

struct Calibration {
  void operator()(comedi_calibration_t* c) const { ::comedi_cleanup_calibration(c); }
};
using CalibrationPtr = std::unique_ptr<comedi_calibration_t, Calibration>;

// Null: the inputs need none, or there is none.
CalibrationPtr calibrationOf(comedi_t* card, unsigned subdevice, Message& doubt) {
  if ((::comedi_get_subdevice_flags(card, subdevice) & SDF_SOFT_CALIBRATED) == 0) return nullptr;
  const std::unique_ptr<char, void (*)(void*)> path(::comedi_get_default_calibration_path(card), std::free);
  CalibrationPtr calibration(path ? ::comedi_parse_calibration_file(path.get()) : nullptr);
  if (!calibration) doubt = daq::uncalibrated();
  return calibration;
}

}  // namespace

std::vector<comedi_polynomial_t> converters(comedi_t* card, unsigned subdevice, unsigned channels, unsigned range,
                                            Message& doubt) {
  const CalibrationPtr calibration = calibrationOf(card, subdevice, doubt);
  std::vector<comedi_polynomial_t> all;
  for (unsigned c = 0; c < channels; ++c) {
    const comedi_range* span = ::comedi_get_range(card, subdevice, c, range);
    if (span == nullptr) return {};
    comedi_polynomial_t converter{};
    const bool calibrated = calibration && ::comedi_get_softcal_converter(subdevice, c, range, COMEDI_TO_PHYSICAL,
                                                                          calibration.get(), &converter) >= 0;
    if (!calibrated) {
      const int bits = std::bit_width(::comedi_get_maxdata(card, subdevice, c));
      converter = {};
      converter.order = 1;
      converter.coefficients[0] = span->min;
      converter.coefficients[1] = std::ldexp(span->max - span->min, -bits);
    }
    all.push_back(converter);
  }
  return all;
}

double volts(const comedi_polynomial_t& converter, lsampl_t code) noexcept {
  const double x = static_cast<double>(code) - converter.expansion_origin;
  double sum = 0.0;
  for (unsigned k = converter.order + 1; k-- > 0;) sum = sum * x + converter.coefficients[k];
  return sum;
}

std::string rangeOf(comedi_t* card, unsigned subdevice) {
  const int inputs = ::comedi_get_n_channels(card, subdevice);
  std::string text = "0 to " + std::to_string(inputs - 1) + " ('inputs')";
  comedi_cmd command{};
  if (::comedi_get_cmd_generic_timed(card, subdevice, &command, 1, 1) >= 0) {
    const unsigned least = command.scan_begin_src == TRIG_TIMER ? command.scan_begin_arg : command.convert_arg;
    if (least > 0) text += ", up to " + std::to_string(std::lround(1e9 / least)) + " Hz for one";
  }
  text += ", " + std::to_string(std::bit_width(::comedi_get_maxdata(card, subdevice, 0))) + " bits; 'range'";
  const int ranges = std::min(kMostRanges, ::comedi_get_n_ranges(card, subdevice, 0));
  for (int r = 0; r < ranges; ++r) {
    const comedi_range* span = ::comedi_get_range(card, subdevice, 0, static_cast<unsigned>(r));
    if (span == nullptr) continue;
    std::array<char, 80> one{};
    std::snprintf(one.data(), one.size(), "%s %d: %g to %g%s", r == 0 ? "" : ",", r, span->min, span->max,
                  span->unit == UNIT_volt ? " V"
                  : span->unit == UNIT_mA ? " mA"
                                          : "");
    text += one.data();
  }
  return text;
}

}  // namespace stillcut::app
#endif
