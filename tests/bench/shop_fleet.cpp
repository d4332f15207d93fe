// shop_fleet [MACHINES [SECONDS]]: many machines at one broker, each with an outbox and a sender of its own as
// stillcut-shop has them, and a message of features a second; one historian takes all. Prints what was lost or doubled,
// how long a message takes from the outbox to the historian, and what a day amounts to. The outboxes lie in memory
// (/dev/shm): here one disk would wait for the writes of all machines, which in a shop have a disk each.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <map>

#include "app/shop/run_translator.h"
#include "app/shop/topic_sender.h"
#include "tests/support/shop/real_broker.h"
#include "tests/support/shop/run_lines.h"
#include "tests/support/temp_folder.h"

namespace stillcut::shop {
namespace {

using testing::RealBroker;
using testing::RunLines;

std::int64_t steadyNs() {
  return toNs(SteadyClock().now());
}

struct Machine {
  RunLines run;
  RunTranslator translator;
  std::unique_ptr<Outbox> outbox;
  std::unique_ptr<TopicSender> sender;
  std::int64_t next_ns = 0;
  int told = 0;

  void tell(double t, const std::string& kind) {
    outbox->begin();
    for (ShopMessage& m : translator.take(kind == "start" ? run.start() : run.state("status", t, "stable"))) {
      m.payload["left_ns"] = steadyNs();
      outbox->add(m);
    }
    (void)outbox->commit().ok();
  }
  bool turn() {
    (void)sender->turn(steadyNs() / 1'000'000).ok();
    const auto delivered = sender->takeDelivered();
    if (delivered.empty()) return false;
    (void)outbox->forget(delivered).ok();
    return true;
  }
};

// Who takes everything: the time of each on its way, and what came of each machine. Thread: the library's.
class Historian {
 public:
  explicit Historian(int port) {
    client_ = mosquitto_new("historian", false, this);
    mosquitto_connect_callback_set(client_, [](mosquitto* c, void*, int) {
      mosquitto_subscribe(c, nullptr, "works/#", 2);
      mosquitto_subscribe(c, nullptr, "$SYS/broker/bytes/received", 0);
    });
    mosquitto_message_callback_set(
        client_, [](mosquitto*, void* self, const mosquitto_message* m) { static_cast<Historian*>(self)->take(*m); });
    mosquitto_connect(client_, "127.0.0.1", port, 60);
    mosquitto_loop_start(client_);
  }
  ~Historian() {
    mosquitto_disconnect(client_);
    mosquitto_loop_stop(client_, true);
    mosquitto_destroy(client_);
  }
  std::size_t count() const {
    const std::scoped_lock lock(mutex_);
    return late_ms_.size();
  }
  double brokerBytes() const {
    const std::scoped_lock lock(mutex_);
    return brokerBytes_;
  }
  int report(std::size_t machines, std::size_t sent, double seconds, double bytes) const;

 private:
  void take(const mosquitto_message& m) {
    const std::int64_t now_ns = steadyNs();
    const std::string payload(static_cast<const char*>(m.payload), static_cast<std::size_t>(m.payloadlen));
    const std::string topic = m.topic;
    const std::scoped_lock lock(mutex_);
    if (topic.starts_with("$SYS")) brokerBytes_ = std::strtod(payload.c_str(), nullptr);
    if (topic.starts_with("$SYS") || topic.ends_with("/online")) return;
    const auto message = nlohmann::json::parse(payload);
    late_ms_.push_back(1e-6 * static_cast<double>(now_ns - message["left_ns"].get<std::int64_t>()));
    payload_ += m.payloadlen + static_cast<int>(topic.size());
    auto& newest = newest_[topic.substr(0, topic.find("/stillcut/"))];
    const auto sequence = message["sequence"].get<std::uint64_t>();
    outOfOrder_ += sequence != newest + 1 ? 1 : 0;
    newest = sequence;
  }
  mosquitto* client_;
  mutable std::mutex mutex_;
  std::vector<double> late_ms_;
  std::map<std::string, std::uint64_t> newest_;
  double brokerBytes_ = 0.0;
  long payload_ = 0;
  int outOfOrder_ = 0;
};

int Historian::report(std::size_t machines, std::size_t sent, double seconds, double bytes) const {
  const std::scoped_lock lock(mutex_);
  std::vector<double> late = late_ms_;
  std::sort(late.begin(), late.end());
  const auto quantile = [&late](double q) {
    return late.empty()
               ? 0.0
               : late[std::min(late.size() - 1, static_cast<std::size_t>(q * static_cast<double>(late.size())))];
  };
  const double day = 86400.0 / seconds;
  std::printf("machines %zu, seconds %.0f\n", machines, seconds);
  std::printf("sent %zu, arrived %zu, missing or doubled or out of order %d\n", sent, late.size(), outOfOrder_);
  std::printf("from outbox to historian, ms: median %.2f, p99 %.2f, p99.9 %.2f, worst %.2f\n", quantile(0.5),
              quantile(0.99), quantile(0.999), late.empty() ? 0.0 : late.back());
  std::printf(
      "a day of one machine: %.1f MB of topics and payloads; at the broker from all machines %.2f GB, protocol "
      "included\n",
      1e-6 * day * static_cast<double>(payload_) / static_cast<double>(machines), 1e-9 * day * bytes);
  return outOfOrder_ == 0 && late.size() == sent ? 0 : 1;
}

int measure(std::size_t machines, int seconds) {
  const std::filesystem::path memory = "/dev/shm";
  if (std::filesystem::is_directory(memory)) ::setenv("TMPDIR", memory.c_str(), 1);
  const record::TempFolder folder;
  const RealBroker broker(folder / "", "allow_anonymous true\nsys_interval 1\n");
  const Historian historian(broker.port());
  std::deque<Machine> fleet(machines);  // they are never moved
  const std::int64_t begin_ns = steadyNs() + 2'000'000'000;
  for (std::size_t k = 0; k < machines; ++k) {
    const std::string name = "mill" + std::to_string(k + 1);
    auto outbox = Outbox::open(folder / (name + ".outbox"));
    if (!outbox) return std::fprintf(stderr, "shop_fleet: %s\n", outbox.error().line().c_str()), 2;
    Machine& m = fleet[k];
    m.outbox = std::move(*outbox);
    BrokerOptions options;
    options.host = "127.0.0.1";
    options.port = broker.port();
    options.clientId = name;
    m.sender = std::make_unique<TopicSender>(options, "works/hall1/" + name + "/stillcut", "bench", *m.outbox);
    if (!m.sender->begin()) return 2;
    m.next_ns = begin_ns + static_cast<std::int64_t>(k) * 1'000'000'000 / static_cast<std::int64_t>(machines);
  }
  const std::int64_t end_ns = begin_ns + static_cast<std::int64_t>(seconds) * 1'000'000'000;
  double bytesBefore = 0.0;
  while (steadyNs() < end_ns + 5'000'000'000) {
    const std::int64_t now_ns = steadyNs();
    if (bytesBefore == 0.0 && now_ns > begin_ns) bytesBefore = historian.brokerBytes();
    std::vector<pollfd> entries;
    std::int64_t next_ns = now_ns + 50'000'000;
    std::size_t waiting = 0;
    bool busy = false;
    for (Machine& m : fleet) {
      if (m.next_ns <= now_ns && m.next_ns < end_ns) {
        m.tell(m.told, m.told == 0 ? "start" : "status");
        ++m.told;
        m.next_ns += 1'000'000'000;
      }
      busy = m.turn() || busy;
      entries.push_back(m.sender->entry());
      next_ns = std::min(next_ns, m.next_ns < end_ns ? m.next_ns : next_ns);
      waiting += m.outbox->waiting();
    }
    if (now_ns > end_ns && waiting == 0) break;
    const std::int64_t wait_ns = std::max<std::int64_t>(0, next_ns - steadyNs());
    ::poll(entries.data(), entries.size(), busy ? 0 : static_cast<int>(wait_ns / 1'000'000));
  }
  std::size_t sent = 0;
  for (const Machine& m : fleet) sent += static_cast<std::size_t>(m.told) + 1;  // the first state comes with features
  testing::within(Seconds(20.0), [&] { return historian.count() >= sent; });
  return historian.report(machines, sent, seconds, historian.brokerBytes() - bytesBefore);
}

}  // namespace
}  // namespace stillcut::shop

int main(int argc, char** argv) try {
  if (stillcut::shop::testing::brokerProgram().empty()) return std::puts(stillcut::shop::testing::kNoBroker), 77;
  const int machines = argc > 1 ? std::atoi(argv[1]) : 200, seconds = argc > 2 ? std::atoi(argv[2]) : 600;
  if (machines < 1 || seconds < 1) return std::fputs("shop_fleet [MACHINES [SECONDS]]\n", stderr), 2;
  return stillcut::shop::measure(static_cast<std::size_t>(machines), seconds);
} catch (const std::exception& e) {
  return std::fprintf(stderr, "shop_fleet: %s\n", e.what()), 2;
}
