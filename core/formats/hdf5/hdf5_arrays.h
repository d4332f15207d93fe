// Arrays of numbers in an HDF5 file: what there is, and one column of one of them as numbers.
// Thread: its caller's, for as long as it takes; not real-time.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/formats/column_reader.h"
#include "core/storage/hdf5_file.h"

namespace stillcut::record {

struct Hdf5Array {
  std::string path;         // from the root of the file
  std::int64_t frames = 0;  // the longer side
  int columns = 1;          // the shorter side
  bool frameIsRow = true;   // the first dimension is time
  int rank = 1;
};

struct Hdf5Listing {
  std::vector<Hdf5Array> arrays;                           // of two numbers or more
  std::vector<std::pair<std::string, double>> numbers;     // of one
  std::vector<std::pair<std::string, std::string>> texts;  // MATLAB's character arrays
  std::string table, deep;                                 // the first of records, of three dimensions; empty: none
};

// Everything at or under `from` (a data set or a folder, which is looked through with all its folders). An array for
// which a file of `fileBytes` cannot hold the samples is an error.
Result<Hdf5Listing> listHdf5Arrays(hid_t file, const std::string& from, std::uint64_t fileBytes,
                                   const std::string& path);

Result<std::unique_ptr<Column>> openHdf5Column(const std::shared_ptr<Hdf5Id>& file, const Hdf5Array& array, int column,
                                               const std::string& where);

// A text attribute of fixed or variable length, as h5py and MATLAB write them; nothing when there is none.
std::optional<std::string> readAnyText(hid_t object, const char* name);

bool isMatlab73(hid_t file, const std::vector<Hdf5Array>& arrays);

}  // namespace stillcut::record
