// Uff58Cursor: the one reader of datasets 58 and 58b, dataset by dataset and point by point, with a fixed buffer
// whatever the length of the file. Everything uff58.h says about strictness is done here. Thread: one at a time.
// Errors: one line with file and dataset; nothing can be read after one.
#pragma once

#include <array>
#include <complex>
#include <span>
#include <string>

#include "core/base/result.h"
#include "core/formats/universal/byte_window.h"
#include "core/formats/universal/uff58.h"

namespace stillcut::uff {

struct Uff58Point {
  double x = 0.0;
  std::complex<double> y;
};

class Uff58Cursor {
 public:
  // Where the points of a dataset begin; good for any cursor over the same bytes.
  struct Place {
    std::uint64_t position = 0;
    int dataset = 0;  // counted from 1, those passed over included
    bool binary = false;
    bool bigEndian = false;
    std::uint64_t bytes = 0;  // as its header announces
    Uff58Header header;
  };

  Uff58Cursor(ByteWindow window, std::string where);

  // Goes to the points of the next dataset 58. False: there is none left.
  Result<bool> next();
  const Uff58Header& header() const { return place_.header; }
  const Place& place() const { return place_; }
  void go(const Place& place);
  // The next points, as many as `out` holds or are left; 0 when all are read.
  Result<std::size_t> read(std::span<Uff58Point> out);
  // After all points: the dataset must end here.
  Status finish();

 private:
  Error fail(Message what, Message why = {}) const;
  void begin();
  Status skipToEnd();
  Status parseBinaryHeader(std::string_view fields);
  Status parseHeader();
  Status parseSizes(std::string_view line);
  Status checkSize() const;
  Result<Uff58Point> point(const std::array<double, 3>& numbers) const;
  Status readAscii(Uff58Point& out);
  Status readBinary(Uff58Point& out);
  std::size_t numbersPerPoint() const;
  std::size_t abscissaBytes() const;
  Error endedEarly() const;

  ByteWindow window_;
  std::string where_;
  Place place_;
  std::uint64_t read_ = 0;         // points of this dataset
  std::uint64_t implausible_ = 0;  // among its numbers
  std::string line_;               // ASCII: what is left of the line at hand begins at lineAt_
  std::size_t lineAt_ = 0;
};

}  // namespace stillcut::uff
