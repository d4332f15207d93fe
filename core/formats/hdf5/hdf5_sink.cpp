// Plain HDF5: one data set a channel under /channels, samples bit by bit as recorded, with scale and unit beside them.
#include <array>
#include <cstdio>

#include "core/formats/recording_sink.h"
#include "core/formats/sensor_notes.h"
#include "core/storage/hdf5_file.h"

namespace stillcut::record {
namespace {

class Hdf5Sink final : public RecordingSink {
 public:
  explicit Hdf5Sink(std::string path) : path_(std::move(path)), part_(path_ + ".part") {}
  ~Hdf5Sink() override {
    sets_.clear();
    file_.reset();
    std::remove(part_.c_str());
  }

  Status create(const ExportPlan& plan) {
    quietHdf5();
    file_ = Hdf5Id(H5Fcreate(part_.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
    if (!file_) return failure();
    const Hdf5Id folder(H5Gcreate2(file_.get(), "channels", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    if (!folder || !writeNumber(folder.get(), "rate_hz", plan.rate.value)) return failure();
    int number = 0;
    for (const RecordedChannel& channel : plan.channels) {
      char name[32];
      std::snprintf(name, sizeof name, "%02d", number++);
      if (!createSet(folder.get(), name, channel)) return failure();
    }
    return writeGaps(plan);
  }

  Status write(const SampleBlock& block) override {
    const hsize_t count = static_cast<hsize_t>(block.frames);
    const hsize_t end = written_ + count;
    const Hdf5Id memory(H5Screate_simple(1, &count, nullptr));
    for (std::size_t c = 0; c < sets_.size(); ++c) {
      if (H5Dset_extent(sets_[c].get(), &end) < 0) return failure();
      const Hdf5Id space(H5Dget_space(sets_[c].get()));
      if (H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, &written_, nullptr, &count, nullptr) < 0 ||
          H5Dwrite(sets_[c].get(), H5T_NATIVE_FLOAT, memory.get(), space.get(), H5P_DEFAULT,
                   block.channel(static_cast<int>(c)).data()) < 0) {
        return failure();
      }
    }
    written_ = end;
    return Done{};
  }

  Status finish() override {
    bool closed = true;
    for (Hdf5Id& set : sets_) closed = set.reset() && closed;
    closed = file_.reset() && closed;
    if (!closed) return failure();
    if (std::rename(part_.c_str(), path_.c_str()) != 0) return Error{path_, message("cannot be written")};
    return Done{};
  }

 private:
  bool createSet(hid_t folder, const char* name, const RecordedChannel& channel) {
    const hsize_t none = 0;
    const hsize_t unlimited = H5S_UNLIMITED;
    constexpr hsize_t kChunk = 16384;
    const Hdf5Id space(H5Screate_simple(1, &none, &unlimited));
    const Hdf5Id plan(H5Pcreate(H5P_DATASET_CREATE));
    H5Pset_chunk(plan.get(), 1, &kChunk);
    Hdf5Id set(H5Dcreate2(folder, name, H5T_IEEE_F32LE, space.get(), H5P_DEFAULT, plan.get(), H5P_DEFAULT));
    const bool made = set && writeText(set.get(), "name", channel.info.name) &&
                      writeText(set.get(), "unit", exportUnit(channel)) &&
                      writeNumber(set.get(), "scale", channel.info.scale) &&
                      (!channel.quantityKnown ||
                       writeText(set.get(), "quantity", std::string(stillcut::name(channel.info.quantity)))) &&
                      writeText(set.get(), "axis", channel.info.axis) && writeSensor(set.get(), channel.info);
    sets_.push_back(std::move(set));
    return made;
  }

  // Pairs of the first filled frame and how many.
  Status writeGaps(const ExportPlan& plan) {
    if (plan.gaps.empty()) return Done{};
    std::vector<std::int64_t> pairs;
    for (const FilledGap& gap : plan.gaps) {
      pairs.push_back(gap.first);
      pairs.push_back(gap.frames);
    }
    const std::array<hsize_t, 2> shape{plan.gaps.size(), 2};
    const Hdf5Id space(H5Screate_simple(2, shape.data(), nullptr));
    const Hdf5Id set(
        H5Dcreate2(file_.get(), "channels/gaps", H5T_STD_I64LE, space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    if (!set || H5Dwrite(set.get(), H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, pairs.data()) < 0)
      return failure();
    return Done{};
  }

  Error failure() const { return Error{path_, message("cannot be written"), hdf5Cause()}; }

  std::string path_;
  std::string part_;
  Hdf5Id file_;
  std::vector<Hdf5Id> sets_;
  hsize_t written_ = 0;
};

}  // namespace

Result<std::unique_ptr<RecordingSink>> createHdf5Sink(const std::string& path, const ExportPlan& plan) {
  auto sink = std::make_unique<Hdf5Sink>(path);
  if (const Status s = sink->create(plan); !s) return s.error();
  return std::unique_ptr<RecordingSink>(std::move(sink));
}

}  // namespace stillcut::record
