// Universal file format, dataset 58 (ASCII) and 58b (binary): functions at nodal degrees of freedom, as modal test
// systems write them. Source: Universal File Formats for Modal Analysis Testing, dataset 58 (SDRC / University of
// Cincinnati). Other datasets in the file are passed over.
//
// Strict: sizes in the file are believed only as far as bytes are there, values must be finite, the floating-point
// format must be IEEE 754. Memory never exceeds a few times the file's size; Uff58Cursor (uff58_cursor.h) reads any
// length with a fixed buffer.
// Thread: any, set-up path. Errors: one line with file and dataset.
#pragma once

#include <array>
#include <complex>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace stillcut::uff {

// Function type, record 6 field 1; others are kept as their number.
enum class Uff58Function : int {
  General = 0,
  TimeResponse = 1,
  AutoSpectrum = 2,
  CrossSpectrum = 3,
  FrequencyResponse = 4,
  Transmissibility = 5,
  Coherence = 6,
  PowerSpectralDensity = 9,
  Spectrum = 12
};

// Specific data type of an axis, records 8 to 11 field 1; others are kept as their number.
enum class Uff58Quantity : int {
  Unknown = 0,
  General = 1,
  Displacement = 8,
  ReactionForce = 9,
  Velocity = 11,
  Acceleration = 12,
  ExcitationForce = 13,
  Pressure = 15,
  Time = 17,
  Frequency = 18
};

struct Uff58Axis {
  Uff58Quantity quantity = Uff58Quantity::Unknown;
  std::string label;  // as in the file, blanks around it removed; may hold bytes that are no ASCII
  std::string unit;
};

struct Uff58Header {
  std::array<std::string, 5> id;
  Uff58Function function = Uff58Function::General;
  std::string responseName;
  std::string referenceName;
  long responseNode = 0;
  int responseDirection = 0;  // +-1 x, +-2 y, +-3 z, 0 scalar
  long referenceNode = 0;
  int referenceDirection = 0;
  bool complex = false;          // imaginary parts are meaningful
  bool doublePrecision = false;  // as stored
  bool even = true;              // abscissa is start + i * increment
  std::uint64_t points = 0;
  double start = 0.0;
  double increment = 0.0;
  double zValue = 0.0;
  Uff58Axis abscissa, ordinate, denominator, z;
};

struct Uff58Dataset : Uff58Header {
  std::vector<double> x;                // abscissa, as many as y
  std::vector<std::complex<double>> y;  // ordinate; imaginary part 0 for real data
};

enum class Uff58Form { Ascii, LittleEndian, BigEndian };

// Every dataset 58 of a universal file held in `bytes`; `where` names the file. None at all is an error.
Result<std::vector<Uff58Dataset>> parseUff58(std::string_view bytes, const std::string& where);

// Does the text begin like a universal file (a line holding only -1)?
bool looksLikeUff(std::string_view bytes);

// The beginning of a dataset as a universal file's text, from its first -1 up to the first number.
std::string formatUff58Head(const Uff58Header& header, Uff58Form form);

}  // namespace stillcut::uff
