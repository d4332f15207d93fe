// SessionLines: a session that another program is recording, as the lines of a run: for the desktop, which writes no
// lines. It follows the newest session below a folder, also a history of features (record.mode = "features"), and goes
// over to the next one when that begins. What a session does not hold (rms, latency) is null; seconds in cut and in
// chatter are reckoned from its steps. Sessions are only ever read, beside their writer.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/shop/line_source.h"

namespace stillcut::shop {

class SessionLines final : public LineSource {
 public:
  SessionLines(std::string folder, const std::string& cursor);
  ~SessionLines() override;

  Result<std::vector<SourceLine>> read(std::size_t atMost) override;
  int descriptor() const override { return -1; }
  bool goesOn() const override { return true; }  // a session that is not gone on with begins with its start
  bool atEnd() const override;

 private:
  struct Place;
  struct Reading;
  struct Known {
    std::int64_t began_ns = 0;  // since 1970 UTC; 0: no session
    std::filesystem::file_time_type changed{};
    std::string path;
  };
  std::vector<Known> look();
  std::string folder_;
  std::unique_ptr<Place> place_;
  std::map<std::string, Known> known_;  // by path, as last seen
};

}  // namespace stillcut::shop
