// What a person knows about the file of a tap test and the file does not say. Values: any thread.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/formats/recording_reader.h"
#include "core/milling/identify/axis.h"
#include "core/milling/identify/frf.h"

namespace stillcut::identify {

enum class MeasurementKind { Automatic, Frf, Hammer };

// How recordings are opened; record::openRecording everywhere but in tests of what happens without.
using OpenRecording =
    std::function<Result<std::unique_ptr<record::RecordingReader>>(const std::string&, const record::ReadOptions&)>;

struct ImportOptions {
  MeasurementKind kind = MeasurementKind::Automatic;
  std::vector<Axis> axes;  // wanted: one, or x and y; empty: what the file holds
  // A frequency response. Empty: as the file says, and asked for where it says nothing.
  std::string unit;                     // "m/N", "(m/s^2)/N"
  std::string frequencyUnit;            // "Hz", "kHz", "rad/s"
  std::string phaseUnit;                // "deg", "rad"
  std::optional<FrfQuantity> quantity;  // instead of the unit's
  std::optional<double> scale;          // SI units per unit of the file, instead of the unit's
  std::optional<std::size_t> dataset;   // which one of a universal file, from 0
  bool cross = false;                   // the response along one axis to a force along another is wanted, and no other
  // A hammer record. Channels by their name or number, from 0.
  std::string force;
  std::vector<std::string> responses;
  std::string forceUnit, responseUnit;                // "N", "lbf"; "m/s^2", "g", "mm/s"; "V"
  std::optional<double> forceScale, responseScale;    // of those units per unit of the file: what full scale is
  std::string forceSensitivity, responseSensitivity;  // "2.25 mV/N", "100 mV/g": of channels in volts
  std::optional<double> secondsPerTime;               // of its times in numbers
  std::optional<Hertz> rate;                          // of a recording that does not say it
  OpenRecording open;
};

}  // namespace stillcut::identify
