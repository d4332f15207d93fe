#include "app/shop/shop_loop.h"

#include <cstdlib>
#include <utility>

#include "core/base/time.h"

namespace stillcut::shop {
namespace {

constexpr std::size_t kLinesAtOnce = 500;
constexpr int kLook = 1000;  // ms
// Notes: lines as they came, for listeners of the next start.
constexpr const char *kStartLine = "start_line", *kNewestLine = "newest_line";

std::int64_t steadyMs() {
  return toNs(SteadyClock().now()) / 1'000'000;
}

bool isLineOfARun(const nlohmann::json& line) {
  const auto text = [&line](const char* key) {
    const auto found = line.find(key);
    return found != line.end() && found->is_string() ? found->get<std::string>() : std::string();
  };
  return line.is_object() && text("schema") == "stillcut-cli/1" && text("command") == "run" && !text("type").empty() &&
         line.contains("sequence") && line["sequence"].is_number_unsigned() && line.contains("utc_ms") &&
         line["utc_ms"].is_number_integer();
}

}  // namespace

ShopLoop::ShopLoop(Parts parts, std::function<void(const std::string&)> say)
    : parts_(std::move(parts)), say_(std::move(say)), placed_(parts_.source.goesOn()) {
  const auto memory = nlohmann::json::parse(parts_.outbox.note("translator"), nullptr, false);
  if (memory.is_object()) translator_.recall(memory);
  run_ = std::strtoll(parts_.outbox.note("run").c_str(), nullptr, 10);
  newestUtcMs_ = std::strtoll(parts_.outbox.note("newest_utc_ms").c_str(), nullptr, 10);
  for (const char* note : {kStartLine, kNewestLine}) {
    const auto line = nlohmann::json::parse(parts_.outbox.note(note), nullptr, false);
    if (!line.is_object()) continue;
    for (Listener* listener : parts_.listeners) listener->recall(line);
  }
}

// A source that has no place of its own (a journal, read from two days back) begins in the middle of some run. Until a
// start comes nobody can tell of which one; but what is older than the line that was taken last was taken then, and
// what is newer goes on with the run that went on then.
bool ShopLoop::isOfKnownRun(const nlohmann::json& line) {
  const auto utcMs = line["utc_ms"].get<std::int64_t>();
  if (line["type"] == "start") {
    run_ = utcMs;
    placed_ = true;
  }
  placed_ = placed_ || utcMs > newestUtcMs_;
  return placed_;
}

Status ShopLoop::takeLines() {
  auto lines = parts_.source.read(kLinesAtOnce);
  if (!lines) return lines.error();
  more_ = lines->size() >= kLinesAtOnce;  // a session gives an event more with its step
  if (lines->empty()) return Done{};
  Outbox& outbox = parts_.outbox;
  outbox.begin();
  const SourceLine* newest = nullptr;
  for (const SourceLine& source : *lines) {
    const auto line = nlohmann::json::parse(source.text, nullptr, false);
    if (!isLineOfARun(line)) continue;  // of another program, or half a line after a crash
    if (!isOfKnownRun(line) || !outbox.takeLine(run_, line["sequence"].get<std::uint64_t>())) continue;
    newestUtcMs_ = line["utc_ms"].get<std::int64_t>();
    const std::string type = line["type"];
    if (type == "start") outbox.setNote(kStartLine, source.text);
    if (type != "event" && type != "marker" && type != "note") newest = &source;
    for (const ShopMessage& told : translator_.take(line)) outbox.add(told);
    for (Listener* listener : parts_.listeners) listener->hear(line);
  }
  if (newest != nullptr) outbox.setNote(kNewestLine, newest->text);
  outbox.setNote("cursor", lines->back().cursor);
  outbox.setNote("run", std::to_string(run_));
  outbox.setNote("newest_utc_ms", std::to_string(newestUtcMs_));
  outbox.setNote("translator", translator_.memory().dump());
  return outbox.commit();
}

Status ShopLoop::forgetDelivered() {
  const std::vector<std::uint64_t> delivered = parts_.sender->takeDelivered();
  return delivered.empty() ? Status(Done{}) : parts_.outbox.forget(delivered);
}

bool ShopLoop::done() const {
  return parts_.untilEnd && parts_.source.atEnd() && (parts_.sender == nullptr || parts_.outbox.waiting() == 0);
}

Status ShopLoop::run(int wakeDescriptor, const std::function<bool()>& ended) {
  while (!ended() && !done()) {
    if (Status taken = takeLines(); !taken) return taken;
    bool busy = more_;
    if (parts_.sender != nullptr) {
      if (Status turned = parts_.sender->turn(steadyMs()); !turned) return turned;
      const std::uint64_t before = parts_.outbox.waiting();
      if (Status forgot = forgetDelivered(); !forgot) return forgot;
      busy = busy || parts_.outbox.waiting() != before;
      if (const std::string problem = parts_.sender->takeProblem(); !problem.empty()) say_("broker: " + problem);
    }
    std::vector<pollfd> entries{{wakeDescriptor, POLLIN, 0}, {parts_.source.descriptor(), POLLIN, 0}};
    if (parts_.sender != nullptr) entries.push_back(parts_.sender->entry());
    for (Listener* listener : parts_.listeners) listener->addEntries(entries);
    const bool connecting = parts_.sender != nullptr && !parts_.sender->connected();
    ::poll(entries.data(), entries.size(), busy ? 0 : connecting ? kLook / 4 : kLook);
    for (Listener* listener : parts_.listeners) listener->turn();
  }
  if (parts_.sender == nullptr) return Done{};
  parts_.sender->end();
  return forgetDelivered();
}

}  // namespace stillcut::shop
