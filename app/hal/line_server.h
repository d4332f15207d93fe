// LineServer: one TCP client at a time, lines in, lines out. A second client is turned away unless the first may go.
// Thread: one. Nothing throws after listen(); memory is bounded.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/cnc/line_splitter.h"

namespace stillcut::hal {

class LineServer {
 public:
  LineServer() = default;
  ~LineServer();
  LineServer(const LineServer&) = delete;
  LineServer& operator=(const LineServer&) = delete;

  // `address`: dotted, "127.0.0.1" for this machine alone.
  Status listen(const std::string& address, int port);
  // Waits at most `atMost` for something to happen, then hands each line to `take`, which gives the answer (empty:
  // none). `mayReplace`: a new client takes the place of the present one.
  void serve(Duration atMost, bool mayReplace, const std::function<std::string_view(std::string_view)>& take) noexcept;
  bool connected() const { return client_ >= 0; }

 private:
  void accept(bool mayReplace) noexcept;
  void hear(const std::function<std::string_view(std::string_view)>& take) noexcept;
  void drop() noexcept;

  int listener_ = -1, client_ = -1;
  cnc::LineSplitter splitter_;
};

}  // namespace stillcut::hal
