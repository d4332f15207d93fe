#include "core/milling/identify/import/mat_table.h"

#include <matio.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>

#include "core/formats/matlab/mat_elements.h"

namespace stillcut::identify {
namespace {

struct CloseMat {
  void operator()(mat_t* mat) const { Mat_Close(mat); }
};
struct FreeVariable {
  void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};
using Variable = std::unique_ptr<matvar_t, FreeVariable>;

constexpr std::size_t kMostNumbers = std::size_t{1} << 26U;
constexpr std::size_t kMostColumns = 64;

template <class T>
std::vector<double> numbers(const void* data, std::size_t count) {
  const T* from = static_cast<const T*>(data);
  return std::vector<double>(from, from + count);
}

std::vector<double> toDoubles(const matvar_t& v, const void* data, std::size_t count) {
  switch (v.class_type) {
    case MAT_C_DOUBLE:
      return numbers<double>(data, count);
    case MAT_C_SINGLE:
      return numbers<float>(data, count);
    case MAT_C_INT16:
      return numbers<std::int16_t>(data, count);
    case MAT_C_INT32:
      return numbers<std::int32_t>(data, count);
    case MAT_C_INT64:
      return numbers<std::int64_t>(data, count);
    default:
      return {};
  }
}

// The columns of one variable, each as long as its longer side.
void addColumns(const matvar_t& v, std::vector<TableColumn>& columns) {
  const std::size_t rows = v.dims[0];
  const std::size_t across = v.dims[1];
  const std::size_t count = rows * across;
  std::vector<double> real;
  std::vector<double> imaginary;
  if (v.isComplex != 0) {
    const auto* split = static_cast<const mat_complex_split_t*>(v.data);
    real = toDoubles(v, split->Re, count);
    imaginary = toDoubles(v, split->Im, count);
  } else {
    real = toDoubles(v, v.data, count);
  }
  if (real.size() != count) return;
  const std::size_t length = std::max(rows, across);
  const std::size_t many = std::min(rows, across);
  for (std::size_t c = 0; c < many; ++c) {
    TableColumn column;
    column.name = std::string(v.name) + (many > 1 ? " " + std::to_string(c + 1) : "");
    for (std::size_t i = 0; i < length; ++i) {
      const std::size_t at = rows >= across ? c * rows + i : i * rows + c;
      column.real.push_back(real[at]);
      if (!imaginary.empty()) column.imaginary.push_back(imaginary[at]);
    }
    columns.push_back(std::move(column));
  }
}

bool isTable(const matvar_t& v) {
  if (v.name == nullptr || v.rank != 2 || v.dims[0] == 0 || v.dims[1] == 0) return false;
  const bool numeric = v.class_type >= MAT_C_DOUBLE && v.class_type <= MAT_C_UINT64;
  return numeric && std::min(v.dims[0], v.dims[1]) <= kMostColumns && v.dims[0] <= kMostNumbers / v.dims[1] &&
         std::max(v.dims[0], v.dims[1]) > 1;
}

std::string textOf(const matvar_t& v) {
  const std::size_t count = v.dims[0] * v.dims[1];
  if (v.class_type != MAT_C_CHAR || v.rank != 2 || v.data == nullptr || count > 64 || v.data_size != 1) return "";
  return {static_cast<const char*>(v.data), count};
}

struct Found {
  std::vector<TableColumn> columns;
  std::map<std::string, std::string> texts;
};

// A measuring program keeps frequency, response and unit together in one struct, or in a struct of that: what lies in
// it counts as if it stood beside it, by its own name. Of several elements the first.
void gather(matvar_t& v, int depth, Found& found) {
  constexpr int kDeepest = 4;
  if (v.name == nullptr || v.data == nullptr || depth > kDeepest) return;
  if (v.class_type == MAT_C_STRUCT) {
    const unsigned fields = Mat_VarGetNumberOfFields(&v);
    for (unsigned k = 0; k < fields; ++k) {
      if (matvar_t* field = Mat_VarGetStructFieldByIndex(&v, k, 0)) gather(*field, depth + 1, found);
    }
  } else if (v.class_type == MAT_C_CHAR) {
    found.texts[v.name] = textOf(v);
  } else if (isTable(v)) {
    addColumns(v, found.columns);
  }
}

}  // namespace

Result<NumberTable> readMatTable(const std::string& path) {
  if (const Status sound = record::checkMatElements(path); !sound) return sound.error();
  const std::unique_ptr<mat_t, CloseMat> mat(Mat_Open(path.c_str(), MAT_ACC_RDONLY));
  if (!mat) return Error{path, message("is no MATLAB file")};
  Found found;
  while (const Variable info{Mat_VarReadNextInfo(mat.get())}) {
    if (info->name == nullptr) continue;
    const bool wanted = info->class_type == MAT_C_CHAR || info->class_type == MAT_C_STRUCT || isTable(*info);
    if (!wanted || Mat_VarReadDataAll(mat.get(), info.get()) != 0) continue;
    gather(*info, 0, found);
  }
  std::vector<TableColumn>& all = found.columns;
  const std::map<std::string, std::string>& texts = found.texts;
  std::map<std::size_t, std::size_t> lengths;
  for (const TableColumn& column : all) ++lengths[column.real.size()];
  const auto most =
      std::max_element(lengths.begin(), lengths.end(), [](auto& a, auto& b) { return a.second < b.second; });
  if (most == lengths.end() || most->second < 2) {
    return Error{path, message("holds no two vectors of the same length")};
  }
  NumberTable table;
  for (TableColumn& column : all) {
    if (column.real.size() != most->first) continue;
    const auto unit = texts.find(column.name + "_unit");
    if (unit != texts.end()) column.unit = unit->second;
    table.columns.push_back(std::move(column));
  }
  return table;
}

}  // namespace stillcut::identify
