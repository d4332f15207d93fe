#include "core/formats/hdf5/hdf5_import.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <utility>

#include "core/formats/hdf5/hdf5_arrays.h"
#include "core/formats/sensor_notes.h"
#include "core/formats/variable_channels.h"
#include "core/storage/hdf5_file.h"
#include "core/units/time_names.h"

namespace stillcut::record {
namespace {

std::string folderOf(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos || slash == 0 ? "/" : path.substr(0, slash);
}

std::string lastWord(const std::string& path) {
  return path.substr(path.rfind('/') + 1);
}

// A data set of one number in a folder.
std::optional<double> numberIn(hid_t folder, const char* name) {
  if (H5Lexists(folder, name, H5P_DEFAULT) <= 0) return std::nullopt;
  const Hdf5Id dataset(H5Dopen2(folder, name, H5P_DEFAULT));
  const Hdf5Id space(dataset ? H5Dget_space(dataset.get()) : H5I_INVALID_HID);
  double value = 0.0;
  if (!space || H5Sget_simple_extent_npoints(space.get()) != 1 ||
      H5Dread(dataset.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, &value) < 0)
    return std::nullopt;
  return value;
}

struct Stated {
  std::vector<std::pair<std::string, double>> numbers;
  std::vector<std::pair<std::string, std::string>> texts;
};

herr_t takeAttribute(hid_t object, const char* name, const H5A_info_t*, void* context) {
  Stated& stated = *static_cast<Stated*>(context);
  if (!namesRate(name)) return 0;
  if (const auto value = readNumber(object, name)) {
    stated.numbers.emplace_back(name, *value);
  } else if (const auto text = readAnyText(object, name)) {
    stated.texts.emplace_back(name, *text);
  }
  return 0;
}

// The attributes of one object that tell a rate.
Stated attributesOf(hid_t file, const std::string& at) {
  Stated stated;
  const Hdf5Id object(H5Oopen(file, at.c_str(), H5P_DEFAULT));
  if (object) H5Aiterate2(object.get(), H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, takeAttribute, &stated);
  return stated;
}

// The rate that the data sets tell of themselves. Error: they tell several.
Status takeRateOfSets(hid_t file, const std::vector<Hdf5Array>& arrays, FileContents& contents) {
  std::optional<double> all;
  for (const Hdf5Array& array : arrays) {
    const Stated stated = attributesOf(file, array.path);
    const std::optional<double> rate = statedRate(stated.numbers, stated.texts);
    if (!rate) continue;
    if (all && *all != *rate) {
      return Error{contents.path, message("its data sets have several rates"),
                   message("name one of them: %1", cleanName(contents.path + ":" + array.path))};
    }
    all = rate;
  }
  if (all) contents.numbers.emplace_back("rate_hz", *all);
  return Done{};
}

// Numbers in attributes, and data sets of one number, count like single numbers beside the data: of every folder from
// `from` up.
void takeRateOfFolders(hid_t file, const std::string& from, FileContents& contents) {
  for (std::string at = from;; at = folderOf(at)) {
    Stated stated = attributesOf(file, at);
    contents.numbers.insert(contents.numbers.end(), stated.numbers.begin(), stated.numbers.end());
    contents.texts.insert(contents.texts.end(), stated.texts.begin(), stated.texts.end());
    const Hdf5Id object(H5Oopen(file, at.c_str(), H5P_DEFAULT));
    if (object && H5Iget_type(object.get()) == H5I_GROUP) {
      for (const char* name : {"rate_hz", "rate", "fs", "sample_rate", "sampling_rate", "samplerate",
                               "sampling_frequency", "dt", "wf_increment", "sample_interval"}) {
        if (const auto value = numberIn(object.get(), name)) contents.numbers.emplace_back(name, *value);
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

Error tableOfRecords(const std::string& path, const std::string& table) {
  return Error{path, message("'%1' is a table of records, which is not read", table),
               message("save each of its columns as a data set of its own")};
}

Result<std::string> placeOf(const std::string& path, const Hdf5Listing& listing) {
  const std::vector<Hdf5Array>& arrays = listing.arrays;
  if (arrays.empty() && !listing.table.empty()) return tableOfRecords(path, listing.table);
  if (arrays.empty() && !listing.deep.empty()) {
    return Error{path, message("'%1' has more than two dimensions", listing.deep),
                 message("save samples by channels, one block behind the other")};
  }
  if (arrays.empty())
    return Error{path, message("holds no data set of numbers"), message("not a Stillcut session either")};
  const std::string folder = folderOf(arrays.front().path);
  const bool together =
      std::all_of(arrays.begin(), arrays.end(), [&folder](const Hdf5Array& a) { return folderOf(a.path) == folder; });
  if (!together) return several(path, arrays);
  return folder;
}

// Where the superblock of version 3 stands, its fourth byte from here says that a writer has the file open.
constexpr std::streamoff kConsistencyFlags = 11;

struct OpenedFile {
  std::shared_ptr<Hdf5Id> file;
  bool leftOpen = false;
};

// A file that its writer did not close is read where that writer let others read meanwhile.
Result<OpenedFile> openFile(const std::string& path) {
  auto file = std::make_shared<Hdf5Id>(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
  if (*file) return OpenedFile{std::move(file), false};
  const Message cause = hdf5Cause();
  if (!isLeftOpen(path)) return Error{path, message("the HDF5 file cannot be opened"), cause};
  // One try: nobody writes it any more. A session of ours that was cut off is not for this reader.
  const Hdf5Id access(H5Pcreate(H5P_FILE_ACCESS));
  H5Pset_metadata_read_attempts(access.get(), 1);
  file = std::make_shared<Hdf5Id>(H5Fopen(path.c_str(), H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, access.get()));
  if (*file && !readAnyText(file->get(), "format")) return OpenedFile{std::move(file), true};
  return Error{path, message("the HDF5 file was not closed by its writer"),
               message("close it there, or run h5clear -s on a copy of it")};
}

}  // namespace

bool isLeftOpen(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::array<char, 9> head{};
  in.read(head.data(), head.size());
  constexpr char kVersionWithFlags = 3;
  constexpr int kWriting = 0x01, kWritingBesideReaders = 0x04;
  if (!in || head[8] != kVersionWithFlags) return false;
  in.seekg(kConsistencyFlags);
  const int flags = in.get();
  return flags > 0 && (flags & ~(kWriting | kWritingBesideReaders)) == 0;
}

Result<std::unique_ptr<RecordingReader>> openHdf5(const std::string& path, const std::string& inner,
                                                  const ReadOptions& options) {
  quietHdf5();
  Result<OpenedFile> opened = openFile(path);
  if (!opened) return opened.error();
  const std::shared_ptr<Hdf5Id> file = opened->file;
  std::error_code problem;
  const std::uint64_t fileBytes = std::filesystem::file_size(path, problem);
  Result<Hdf5Listing> listing = listHdf5Arrays(file->get(), inner.empty() ? "/" : inner, fileBytes, path);
  if (!listing) return listing.error();
  std::string place = inner;
  if (inner.empty()) {
    Result<std::string> found = placeOf(path, *listing);
    if (!found) return found.error();
    place = *found;
  }
  const std::string where = inner.empty() ? path : path + ":" + inner;
  FileContents contents;
  contents.path = where;
  if (opened->leftOpen) {
    contents.notes.push_back(message("was not closed by its writer: what that had written so far is read"));
  }
  contents.kind = isMatlab73(file->get(), listing->arrays) ? "MATLAB v7.3" : "HDF5";
  contents.numbers = listing->numbers;
  contents.texts = listing->texts;
  if (const Status s = takeRateOfSets(file->get(), listing->arrays, contents); !s) return s.error();
  takeRateOfFolders(file->get(), place, contents);
  const bool onlyTimes = std::all_of(listing->arrays.begin(), listing->arrays.end(), [](const Hdf5Array& array) {
    return array.columns == 1 && isTimeName(lastWord(array.path));
  });
  if (onlyTimes && !listing->table.empty()) return tableOfRecords(path, listing->table);
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
