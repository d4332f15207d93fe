#include "core/formats/matlab/mat_import.h"

#include <matio.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <utility>

#include "core/formats/matlab/mat_elements.h"
#include "core/formats/utf_text.h"
#include "core/formats/variable_channels.h"

namespace stillcut::record {
namespace {

struct CloseMat {
  void operator()(mat_t* mat) const { Mat_Close(mat); }
};
struct FreeVariable {
  void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};
using MatFile = std::shared_ptr<mat_t>;
using Variable = std::shared_ptr<matvar_t>;

constexpr std::size_t kMostVariables = 4096;
constexpr std::size_t kMostColumns = 256;
constexpr std::size_t kLongestText = 256;
// Of numbers taken at once. Reading on in a compressed variable means inflating it from its start again: there a
// sixteenth of it, as far as all channels together stay below 128 MB.
constexpr std::size_t kSlab = std::size_t{1} << 18U;
constexpr std::size_t kInflatedAtOnce = 16;
constexpr std::size_t kMostInflated = std::size_t{1} << 24U;

std::size_t slabOf(const matvar_t& variable, std::size_t frames, std::size_t channels) {
  if (variable.compression != MAT_COMPRESSION_ZLIB) return kSlab;
  const std::size_t most = std::max<std::size_t>(1, kMostInflated / std::max<std::size_t>(channels, 1));
  return std::min(std::max(kSlab, frames / kInflatedAtOnce), std::max(most, kSlab / 8));
}

template <class T>
void convert(const std::vector<unsigned char>& raw, std::size_t count, std::vector<double>& out) {
  for (std::size_t i = 0; i < count; ++i) {
    T value{};
    std::memcpy(&value, raw.data() + i * sizeof(T), sizeof(T));
    out[i] = static_cast<double>(value);
  }
}

bool toDoubles(matio_classes type, const std::vector<unsigned char>& raw, std::size_t count, std::vector<double>& out) {
  switch (type) {
    case MAT_C_DOUBLE:
      return convert<double>(raw, count, out), true;
    case MAT_C_SINGLE:
      return convert<float>(raw, count, out), true;
    case MAT_C_INT8:
      return convert<std::int8_t>(raw, count, out), true;
    case MAT_C_UINT8:
      return convert<std::uint8_t>(raw, count, out), true;
    case MAT_C_INT16:
      return convert<std::int16_t>(raw, count, out), true;
    case MAT_C_UINT16:
      return convert<std::uint16_t>(raw, count, out), true;
    case MAT_C_INT32:
      return convert<std::int32_t>(raw, count, out), true;
    case MAT_C_UINT32:
      return convert<std::uint32_t>(raw, count, out), true;
    case MAT_C_INT64:
      return convert<std::int64_t>(raw, count, out), true;
    case MAT_C_UINT64:
      return convert<std::uint64_t>(raw, count, out), true;
    default:
      return false;
  }
}

// Whole numbers of 64 bits, from the first of the column on.
struct FirstOfColumn {
  bool known = false;
  std::uint64_t value = 0;
};
void countFrom(FirstOfColumn& first, const std::vector<unsigned char>& raw, std::vector<double>& out) {
  for (std::size_t i = 0; i < out.size(); ++i) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, raw.data() + i * sizeof bits, sizeof bits);
    if (!first.known) first = {true, bits};
    out[i] = static_cast<double>(static_cast<std::int64_t>(bits - first.value));
  }
}

// `count` numbers of one row or column of the variable.
bool readSlab(mat_t* mat, matvar_t* variable, bool framesAreRows, std::size_t column, std::size_t first,
              std::size_t count, std::vector<double>& out, FirstOfColumn* origin = nullptr) {
  std::vector<unsigned char> raw(count * 8);
  const std::size_t rows = variable->dims[0];
  const std::size_t from = framesAreRows ? column * rows + first : first * rows + column;
  const std::size_t stride = framesAreRows ? 1 : rows;
  out.resize(count);
  if (Mat_VarReadDataLinear(mat, variable, raw.data(), static_cast<int>(from), static_cast<int>(stride),
                            static_cast<int>(count)) != 0 ||
      !toDoubles(variable->class_type, raw, count, out))
    return false;
  const bool long64 = variable->class_type == MAT_C_INT64 || variable->class_type == MAT_C_UINT64;
  if (origin != nullptr && long64) countFrom(*origin, raw, out);
  return true;
}

class MatColumn final : public Column {
 public:
  MatColumn(MatFile mat, Variable variable, std::size_t column, std::size_t channels, std::string where)
      : mat_(std::move(mat)),
        variable_(std::move(variable)),
        framesAreRows_(variable_->dims[0] >= variable_->dims[1]),
        frames_(std::max(variable_->dims[0], variable_->dims[1])),
        column_(column),
        atOnce_(slabOf(*variable_, frames_, channels)),
        where_(std::move(where)) {}

  Status read(std::span<double> out) override {
    for (double& value : out) {
      if (at_ == slab_.size()) {
        const std::size_t count = std::min(atOnce_, frames_ - next_);
        if (count == 0 || !readSlab(mat_.get(), variable_.get(), framesAreRows_, column_, next_, count, slab_,
                                    fromFirst_ ? &first_ : nullptr)) {
          return Error{where_, message("'%1' cannot be read", cleanName(variable_->name)), message("a damaged file")};
        }
        next_ += count;
        at_ = 0;
      }
      value = slab_[at_++];
    }
    return Done{};
  }
  void countFromFirst() override { fromFirst_ = true; }

 private:
  MatFile mat_;
  Variable variable_;
  bool fromFirst_ = false;
  FirstOfColumn first_;
  bool framesAreRows_;
  std::size_t frames_;
  std::size_t column_;
  std::size_t atOnce_;
  std::string where_;
  std::vector<double> slab_;
  std::size_t at_ = 0;
  std::size_t next_ = 0;
};

bool isNumeric(const matvar_t& v) {
  return v.class_type >= MAT_C_DOUBLE && v.class_type <= MAT_C_UINT64 && v.isComplex == 0;
}

std::string textOf(mat_t* mat, matvar_t& variable) {
  if (Mat_VarReadDataAll(mat, &variable) != 0 || variable.data == nullptr) return "";
  const std::size_t letters = variable.dims[0] * variable.dims[1];
  const auto* bytes = static_cast<const char*>(variable.data);
  const bool wide = variable.data_type == MAT_T_UINT16 || variable.data_type == MAT_T_UTF16;
  if (variable.nbytes < letters * (wide ? 2 : 1)) return "";
  if (wide) {
    std::vector<std::uint16_t> units(letters);
    std::memcpy(units.data(), bytes, letters * 2);
    return cleanName(fromUtf16(units));
  }
  // Letters of more than one byte are counted once.
  return cleanName({bytes, variable.data_type == MAT_T_UTF8 ? variable.nbytes : letters});
}

class MatListing {
 public:
  MatListing(MatFile mat, const std::string& path, const std::string& inner, std::uint64_t fileBytes)
      : mat_(std::move(mat)), inner_(inner), fileBytes_(fileBytes) {
    contents_.path = path;
    contents_.kind = "MATLAB v5";
  }

  Result<FileContents> list() {
    std::size_t count = 0;
    while (matvar_t* next = Mat_VarReadNextInfo(mat_.get())) {
      const Variable variable(next, FreeVariable{});
      if (++count > kMostVariables) return Error{contents_.path, message("holds more than 4096 variables")};
      if (variable->name == nullptr) continue;
      if (const Status s = take(variable, variable->name); !s) return s.error();
    }
    if (count == 0)
      return Error{contents_.path, message("holds no variable that can be read"), message("a damaged file")};
    for (FileArray& array : contents_.arrays) {
      for (const auto& [name, text] : texts_) {
        if (name == array.name + "_unit") array.unit = text;
        if (name == array.name + "_quantity") array.quantity = text;
        if (name == array.name + "_axis") array.axis = text;
      }
      const auto full = std::find_if(texts_.begin(), texts_.end(),
                                     [&array](const auto& text) { return text.first == array.name + "_name"; });
      if (full != texts_.end() && !full->second.empty()) array.name = full->second;
    }
    contents_.texts = texts_;
    if (contents_.arrays.empty() && !boxed_.empty()) {
      return Error{contents_.path,
                   message("holds '%1', a cell array or an array of structs, which is not read", boxed_),
                   message("save its numbers as plain variables in MATLAB: x = c{1}; save cut.mat x fs")};
    }
    if (contents_.arrays.empty() && !inner_.empty()) {
      return Error{contents_.path + ":" + inner_, message("there is no such array in the file")};
    }
    return std::move(contents_);
  }

 private:
  // Fields of a struct, by their path: "rec.x". `v` keeps the struct that they are part of.
  Status takeFields(const Variable& v, const std::string& path, int depth) {
    constexpr int kDeepest = 8;
    const std::size_t fields = v->data == nullptr ? 0 : Mat_VarGetNumberOfFields(v.get());
    if (depth > kDeepest || v->rank != 2 || v->dims[0] * v->dims[1] != 1) return skipBoxed(cleanName(path));
    for (std::size_t i = 0; i < fields; ++i) {
      matvar_t* field = Mat_VarGetStructFieldByIndex(v.get(), i, 0);
      if (field == nullptr || field->name == nullptr) continue;
      if (Status s = take(Variable(v, field), path + "." + field->name, depth + 1); !s) return s;
    }
    return Done{};
  }

  // "/x" for a variable, "/rec.x" or "/rec/x" for a field, "/rec" for all of a struct.
  bool isWanted(const std::string& path) const {
    if (inner_.empty()) return true;
    std::string wanted = inner_.substr(1);
    std::replace(wanted.begin(), wanted.end(), '/', '.');
    return path == wanted || path.starts_with(wanted + ".");
  }

  Status take(const Variable& v, const std::string& path, int depth = 0) {
    const std::string name = cleanName(v->name);
    if (v->class_type == MAT_C_CELL) return skipBoxed(cleanName(path));
    if (v->class_type == MAT_C_STRUCT) return takeFields(v, path, depth);
    if (v->rank != 2 || v->dims == nullptr || v->dims[0] == 0 || v->dims[1] == 0) return skip(name);
    constexpr std::uint64_t kMostDeflated = 1100;
    const std::uint64_t most = fileBytes_ * (v->compression == MAT_COMPRESSION_ZLIB ? kMostDeflated : 1);
    const auto count = static_cast<long double>(v->dims[0]) * static_cast<long double>(v->dims[1]);
    if (count > static_cast<long double>(most)) {
      return Error{contents_.path, message("'%1' promises more numbers than the file holds", name),
                   message("its header is wrong")};
    }
    const std::size_t longer = std::max(v->dims[0], v->dims[1]);
    const std::size_t shorter = std::min(v->dims[0], v->dims[1]);
    if (v->class_type == MAT_C_CHAR && longer * shorter <= kLongestText) {
      texts_.emplace_back(name, textOf(mat_.get(), *v));
      return Done{};
    }
    constexpr std::size_t kLongest = 0x7fffffff;
    if (!isNumeric(*v) || shorter > kMostColumns || longer > kLongest / shorter) return skip(name);
    if (longer == 1) {
      std::vector<double> value;
      if (readSlab(mat_.get(), v.get(), true, 0, 0, 1, value)) contents_.numbers.emplace_back(name, value[0]);
      return Done{};
    }
    if (!isWanted(path)) return Done{};
    FileArray array;
    array.name = name;
    array.frames = static_cast<std::int64_t>(longer);
    array.columns = static_cast<int>(shorter);
    *channels_ += shorter;
    array.open = [mat = mat_, v, channels = channels_,
                  where = contents_.path](int column) -> Result<std::unique_ptr<Column>> {
      return std::unique_ptr<Column>(new MatColumn(mat, v, static_cast<std::size_t>(column), *channels, where));
    };
    contents_.arrays.push_back(std::move(array));
    return Done{};
  }

  Status skipBoxed(const std::string& name) {
    if (boxed_.empty()) boxed_ = name;
    return skip(name);
  }
  Status skip(const std::string& name) {
    contents_.skipped.push_back(name);
    return Done{};
  }

  MatFile mat_;
  std::string inner_;
  std::uint64_t fileBytes_;
  FileContents contents_;
  std::string boxed_;  // the first cell array or array of structs
  std::shared_ptr<std::size_t> channels_ = std::make_shared<std::size_t>(0);  // in all arrays
  std::vector<std::pair<std::string, std::string>> texts_;
};

}  // namespace

Result<std::unique_ptr<RecordingReader>> openMat5(const std::string& path, const std::string& inner,
                                                  const ReadOptions& options) {
  if (const Status s = checkMatElements(path); !s) return s.error();
  const MatFile mat(Mat_Open(path.c_str(), MAT_ACC_RDONLY), CloseMat{});
  if (!mat || Mat_GetVersion(mat.get()) != MAT_FT_MAT5) {
    return Error{path, message("is no MATLAB file of version 5 or 7"), message("its header is damaged")};
  }
  std::error_code problem;
  Result<FileContents> contents = MatListing(mat, path, inner, std::filesystem::file_size(path, problem)).list();
  if (!contents) return contents.error();
  return openArrays(std::move(*contents), options);
}

}  // namespace stillcut::record
