// SessionTable: one table of a session file, appended to row by row or read in windows.
// Thread: its owner's; not real-time.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "core/session/file/session_rows.h"
#include "core/storage/hdf5_file.h"

namespace stillcut::record {

// Rows as bytes; Table<Row> below gives them their type.
class SessionTable {
 public:
  // False: hdf5Cause() says why.
  bool create(hid_t file, const char* path, std::span<const RowField> columns, std::size_t rowSize);
  bool open(hid_t file, const char* path, std::span<const RowField> columns, std::size_t rowSize);
  bool append(const void* rows, std::uint64_t count);
  bool read(std::uint64_t first, std::uint64_t count, void* rows) const;
  bool flush() { return H5Dflush(dataset_.get()) >= 0; }
  std::uint64_t rows() const { return rows_; }
  void close() {
    dataset_.reset();
    memory_.reset();
  }

 private:
  Hdf5Id dataset_;
  Hdf5Id memory_;  // type of a row in memory
  std::uint64_t rows_ = 0;
};

template <class Row>
class TableWriter {
 public:
  bool create(hid_t file, const char* path) { return table_.create(file, path, columnsOf<Row>(), sizeof(Row)); }
  void add(const Row& row) { pending_.push_back(row); }
  // Writes what was added, and flushes it when there was something.
  bool write() {
    if (pending_.empty()) return true;
    const bool ok = table_.append(pending_.data(), pending_.size()) && table_.flush();
    pending_.clear();
    return ok;
  }
  void close() { table_.close(); }

 private:
  SessionTable table_;
  std::vector<Row> pending_;
};

// Reads rows in order, a window at a time.
template <class Row>
class TableReader {
 public:
  bool open(hid_t file, const char* path) { return table_.open(file, path, columnsOf<Row>(), sizeof(Row)); }
  std::uint64_t rows() const { return table_.rows(); }
  // nullptr: beyond the end, or the file is damaged there (then `damaged` is set).
  const Row* at(std::uint64_t index, bool& damaged) {
    if (index >= table_.rows()) return nullptr;
    if (index < first_ || index >= first_ + window_.size()) {
      constexpr std::uint64_t kWindow = 512;
      window_.resize(std::min<std::uint64_t>(kWindow, table_.rows() - index));
      first_ = index;
      if (!table_.read(first_, window_.size(), window_.data())) {
        damaged = true;
        window_.clear();
        return nullptr;
      }
    }
    return &window_[index - first_];
  }

 private:
  SessionTable table_;
  std::vector<Row> window_;
  std::uint64_t first_ = 0;
};

}  // namespace stillcut::record
