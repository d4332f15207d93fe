// ShopLoop: the one loop of stillcut-shop: source, outbox, broker, and who listens along. Nothing in it can reach the
// machine or the run that it follows. Thread: main.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "app/shop/line_source.h"
#include "app/shop/listener.h"
#include "app/shop/outbox.h"
#include "app/shop/run_translator.h"
#include "app/shop/sender.h"

namespace stillcut::shop {

class ShopLoop {
 public:
  struct Parts {
    LineSource& source;
    Outbox& outbox;
    Sender* sender = nullptr;  // null: everything is kept
    std::vector<Listener*> listeners;
    bool untilEnd = false;  // end when all that is there was read and the broker has it
  };
  // `say`: a line for the log.
  ShopLoop(Parts parts, std::function<void(const std::string&)> say);

  // Until `ended` says so, looked at after each event and every second.
  Status run(int wakeDescriptor, const std::function<bool()>& ended);

 private:
  Status takeLines();
  bool isOfKnownRun(const nlohmann::json& line);
  Status forgetDelivered();
  bool done() const;

  Parts parts_;
  std::function<void(const std::string&)> say_;
  RunTranslator translator_;
  std::int64_t run_ = 0;          // to which the lines belong that come now: when it began, UTC ms
  std::int64_t newestUtcMs_ = 0;  // of the line that was taken last
  bool placed_;                   // the lines that come now are known to be of run_
  bool more_ = false;             // the source had more than was taken
};

}  // namespace stillcut::shop
