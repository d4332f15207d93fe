// ServiceNotice: tells the service manager that the run has begun, how it is and that it lives, by datagrams to the
// socket that $NOTIFY_SOCKET names (sd_notify(3)). Where there is none it says nothing.
// Thread: one.
#pragma once

#include <string>

#include "core/base/time.h"

namespace stillcut::app {

class ServiceNotice {
 public:
  ServiceNotice();
  ~ServiceNotice();
  ServiceNotice(const ServiceNotice&) = delete;
  ServiceNotice& operator=(const ServiceNotice&) = delete;

  void ready();
  // At every look: it lives, sent often enough for the watchdog, and `status` where it is another one.
  void alive(Instant now, const std::string& status);
  void stopping();

 private:
  void send(const std::string& text) const;

  int socket_ = -1;
  Duration period_{};  // between two signs of life
  Instant last_{};
  std::string status_;
};

}  // namespace stillcut::app
