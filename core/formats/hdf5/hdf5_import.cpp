#include "core/formats/hdf5/hdf5_import.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "core/formats/hdf5/hdf5_arrays.h"
#include "core/formats/sensor_notes.h"
#include "core/formats/variable_channels.h"
#include "core/storage/hdf5_file.h"

namespace stillcut::record {
namespace {

std::string folderOf(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos || slash == 0 ? "/" : path.substr(0, slash);
}

std::string lastWord(const std::string& path) {
  return path.substr(path.rfind('/') + 1);
}

// Numbers in attributes count like single numbers beside the data: of the data set, then of every folder above it.
void addAttributeNumbers(hid_t file, const std::string& from, FileContents& contents) {
  for (std::string at = from;; at = folderOf(at)) {
    const Hdf5Id object(H5Oopen(file, at.c_str(), H5P_DEFAULT));
    if (object) {
      for (const char* name : {"rate_hz", "rate", "fs", "sample_rate", "sampling_rate", "samplerate",
                               "sampling_frequency", "dt", "wf_increment", "sample_interval"}) {
        const std::string key = std::string(name) == "wf_increment" ? "dt" : name;
        if (const auto value = readNumber(object.get(), name)) contents.numbers.emplace_back(key, *value);
      }
    }
    if (at == "/") return;
  }
}

std::string textOf(hid_t object, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    if (const auto text = readAnyText(object, name); text && !text->empty()) return cleanName(*text);
  }
  return {};
}

FileArray describe(const std::shared_ptr<Hdf5Id>& file, const Hdf5Array& found, const std::string& where) {
  FileArray array;
  array.name = cleanName(lastWord(found.path));
  array.frames = found.frames;
  array.columns = found.columns;
  const Hdf5Id dataset(H5Dopen2(file->get(), found.path.c_str(), H5P_DEFAULT));
  if (dataset) {
    if (const std::string name = textOf(dataset.get(), {"name", "long_name", "label"}); !name.empty())
      array.name = name;
    array.quantity = textOf(dataset.get(), {"quantity"});
    array.axis = textOf(dataset.get(), {"axis"});
    array.scale = readNumber(dataset.get(), "scale");
    readSensor(dataset.get(), array.sensor);
    array.unit = textOf(dataset.get(), {"unit", "units", "Unit", "Units", "unit_string"});
  }
  array.open = [file, found, where](int column) { return openHdf5Column(file, found, column, where); };
  return array;
}

Error several(const std::string& path, const std::vector<Hdf5Array>& arrays) {
  std::string names;
  for (std::size_t i = 0; i < std::min<std::size_t>(arrays.size(), 3); ++i) {
    names += (i > 0 ? ", " : "") + cleanName(path + ":" + arrays[i].path);
  }
  return Error{path, message("holds %1 data sets in several places", std::to_string(arrays.size())),
               message("name one of them or their folder: %1", names)};
}

Result<std::string> placeOf(const std::string& path, const std::vector<Hdf5Array>& arrays) {
  if (arrays.empty())
    return Error{path, message("holds no data set of numbers"), message("not a Stillcut session either")};
  const std::string folder = folderOf(arrays.front().path);
  const bool together =
      std::all_of(arrays.begin(), arrays.end(), [&folder](const Hdf5Array& a) { return folderOf(a.path) == folder; });
  if (!together) return several(path, arrays);
  return folder;
}

}  // namespace

Result<std::unique_ptr<RecordingReader>> openHdf5(const std::string& path, const std::string& inner,
                                                  const ReadOptions& options) {
  quietHdf5();
  auto file = std::make_shared<Hdf5Id>(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
  if (!*file) return Error{path, message("the HDF5 file cannot be opened"), hdf5Cause()};
  std::error_code problem;
  const std::uint64_t fileBytes = std::filesystem::file_size(path, problem);
  Result<Hdf5Listing> listing = listHdf5Arrays(file->get(), inner.empty() ? "/" : inner, fileBytes, path);
  if (!listing) return listing.error();
  std::string place = inner;
  if (inner.empty()) {
    Result<std::string> found = placeOf(path, listing->arrays);
    if (!found) return found.error();
    place = *found;
  }
  const std::string where = inner.empty() ? path : path + ":" + inner;
  FileContents contents;
  contents.path = where;
  contents.kind = isMatlab73(file->get(), listing->arrays) ? "MATLAB v7.3" : "HDF5";
  contents.numbers = listing->numbers;
  addAttributeNumbers(file->get(), listing->arrays.size() == 1 ? listing->arrays[0].path : place, contents);
  for (const Hdf5Array& array : listing->arrays) {
    FileArray described = describe(file, array, where);
    for (const auto& [name, text] : listing->texts) {
      if (name == described.name + "_unit") described.unit = text;
      if (name == described.name + "_quantity") described.quantity = text;
      if (name == described.name + "_axis") described.axis = text;
    }
    contents.arrays.push_back(std::move(described));
  }
  return openArrays(std::move(contents), options);
}

}  // namespace stillcut::record
