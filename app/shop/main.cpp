// stillcut-shop: follows one machine's run and tells a shop's broker, historian and dashboards. It takes no command: it
// reads a file or its standard input, writes its own outbox, and opens connections that others can only read.
#include <gnu/libc-version.h>
#include <hdf5.h>
#include <mosquitto.h>
#include <signal.h>
#include <sqlite3.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/shop/line_file.h"
#include "app/shop/mtconnect_adapter.h"
#include "app/shop/plot_sender.h"
#include "app/shop/session_lines.h"
#include "app/shop/shop_loop.h"
#include "app/shop/sparkplug_sender.h"
#include "app/shop/topic_sender.h"
#include "generated/commit.h"
#include "generated/version.h"

namespace stillcut::shop {
namespace {

constexpr int kDone = 0, kWrongUsage = 2, kFailed = 3;

struct Options {
  std::string from, sessions, root, outbox, sparkplug, mtconnect, plot;
  BrokerOptions broker;
  bool untilEnd = false;
};

int fail(const Error& error, int code) {
  std::fprintf(stderr, "stillcut-shop: %s\n", error.line().c_str());
  return code;
}

std::string dotted(unsigned major, unsigned minor, unsigned patch) {
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
}

std::string versionText() {
  int major = 0, minor = 0, revision = 0;
  mosquitto_lib_version(&major, &minor, &revision);
  unsigned hdfMajor = 0, hdfMinor = 0, hdfPatch = 0;
  H5get_libversion(&hdfMajor, &hdfMinor, &hdfPatch);
  return "stillcut-shop " STILLCUT_VERSION " (commit " STILLCUT_COMMIT ")\nlibmosquitto " + std::to_string(major) +
         "." + std::to_string(minor) + "." + std::to_string(revision) + "\nSQLite " + sqlite3_libversion() + "\nHDF5 " +
         dotted(hdfMajor, hdfMinor, hdfPatch) + "\nJSON for Modern C++ " +
         dotted(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH) +
         "\nCLI11 " CLI11_VERSION "\nglibc " + gnu_get_libc_version() + "\ncompiled by " STILLCUT_COMPILER;
}

Status checkRoot(const std::string& root) {
  const bool level = root.find("//") == std::string::npos && !root.starts_with('/') && !root.ends_with('/');
  if (!root.empty() && level && mosquitto_pub_topic_check(root.c_str()) == MOSQ_ERR_SUCCESS) return Done{};
  return Error{root, message("is no topic"), message("SITE/AREA/MACHINE/stillcut, without + and #")};
}

std::unique_ptr<LineSource> makeSource(const Options& o, const std::string& cursor) {
  if (!o.sessions.empty()) return std::make_unique<SessionLines>(o.sessions, cursor);
  return std::make_unique<LineFile>(o.from, cursor);
}

// Null: there is no broker.
Result<std::unique_ptr<Sender>> makeSender(const Options& o, Outbox& outbox) {
  std::unique_ptr<Sender> sender;
  if (o.broker.host.empty()) return sender;
  if (o.sparkplug.empty()) {
    sender = std::make_unique<TopicSender>(o.broker, o.root, STILLCUT_VERSION, outbox);
  } else {
    auto made = SparkplugSender::make(o.broker, o.sparkplug, o.root, outbox);
    if (!made) return made.error();
    sender = std::move(*made);
  }
  if (Status begun = sender->begin(); !begun) return begun.error();
  return sender;
}

// Signals come as a descriptor, so that the loop waits for them as for everything else.
int signalDescriptor() {
  sigset_t set;
  sigemptyset(&set);
  for (const int number : {SIGTERM, SIGINT, SIGHUP}) sigaddset(&set, number);
  sigprocmask(SIG_BLOCK, &set, nullptr);
  ::signal(SIGPIPE, SIG_IGN);
  return signalfd(-1, &set, SFD_NONBLOCK | SFD_CLOEXEC);
}

int run(Options& o) {
  if (Status root = checkRoot(o.root); !root) return fail(root.error(), kWrongUsage);
  auto outbox = Outbox::open(o.outbox);
  if (!outbox) return fail(outbox.error(), kFailed);
  if (o.broker.clientId.empty()) o.broker.clientId = "stillcut-shop " + o.root;
  // One outbox belongs to one source: a cursor of another kind says nothing here.
  const std::string kind = o.sessions.empty() ? o.from : o.sessions;
  const std::string cursor = (*outbox)->note("source") == kind ? (*outbox)->note("cursor") : std::string();
  (*outbox)->begin();
  (*outbox)->setNote("source", kind);
  if (Status kept = (*outbox)->commit(); !kept) return fail(kept.error(), kFailed);
  const auto source = makeSource(o, cursor);
  auto sender = makeSender(o, **outbox);
  if (!sender) return fail(sender.error(), kWrongUsage);
  MtConnectAdapter adapter;
  PlotSender plot;
  std::vector<Listener*> listeners;
  if (!o.mtconnect.empty()) {
    if (Status listening = adapter.listen(o.mtconnect); !listening) return fail(listening.error(), kFailed);
    listeners.push_back(&adapter);
  }
  if (!o.plot.empty()) {
    if (Status opened = plot.open(o.plot); !opened) return fail(opened.error(), kWrongUsage);
    listeners.push_back(&plot);
  }
  const int signals = signalDescriptor();
  const auto ended = [signals] {
    signalfd_siginfo info{};
    return ::read(signals, &info, sizeof info) > 0;
  };
  ShopLoop loop({*source, **outbox, sender->get(), listeners, o.untilEnd || o.from == "-"},
                [](const std::string& line) { std::fprintf(stderr, "stillcut-shop: %s\n", line.c_str()); });
  const Status done = loop.run(signals, ended);
  return done ? kDone : fail(done.error(), kFailed);
}

int start(int argc, char** argv) {
  CLI::App app{"Tells a shop's MQTT broker what Stillcut sees on one machine. It takes no command."};
  app.set_version_flag("--version", versionText, "Version, commit and libraries");
  app.set_config("--config", "", "Read these options from a file, a line each: name = value");
  Options o;
  auto* from = app.add_option("--from", o.from, "File with the lines of stillcut-cli run --json; -: standard input");
  app.add_option("--sessions", o.sessions, "Folder of recordings: follow the session that the desktop writes there")
      ->excludes(from);
  app.add_option("--root", o.root, "Topic of the machine: SITE/AREA/MACHINE/stillcut")->required();
  app.add_option("--outbox", o.outbox, "File for what the broker has not got yet, and for the place in the source")
      ->required();
  app.add_option("--broker", o.broker.host, "Host of the broker; left out: everything is kept");
  app.add_option("--port", o.broker.port, "Port of the broker; left out: 1883, with --ca 8883")
      ->check(CLI::Range(1, 65535));
  app.add_option("--user", o.broker.user, "User at the broker");
  app.add_option("--password-file", o.broker.passwordFile, "File whose first line is the password");
  app.add_option("--ca", o.broker.ca, "Certificates that vouch for the broker (PEM): TLS");
  app.add_option("--certificate", o.broker.certificate, "Own certificate (PEM)");
  app.add_option("--key", o.broker.key, "Key of it (PEM)");
  app.add_option("--client", o.broker.clientId, "Name at the broker; left out: made of the topic");
  app.add_option("--sparkplug", o.sparkplug, "Be the Sparkplug B edge node GROUP/NODE instead of plain topics");
  app.add_option("--mtconnect", o.mtconnect,
                 "Be an MTConnect adapter (SHDR) on this port of this computer, or on ADDRESS:PORT; usual is 7878");
  app.add_option("--plot", o.plot, "Send every state as UDP JSON to ADDRESS:PORT, for PlotJuggler");
  app.add_flag("--until-end", o.untilEnd, "End when all that is there was read and the broker has it");
  try {
    app.parse(argc, argv);
    if (o.from.empty() == o.sessions.empty())
      return fail({message("command line"), message("one of --from and --sessions is needed")}, kWrongUsage);
  } catch (const CLI::Success& done) {
    return app.exit(done);
  } catch (const CLI::ParseError& wrong) {
    return fail({message("command line"), foreign(wrong.what()), message("see --help")}, kWrongUsage);
  }
  return run(o);
}

}  // namespace
}  // namespace stillcut::shop

int main(int argc, char** argv) {
  try {
    return stillcut::shop::start(argc, argv);
  } catch (const std::exception& e) {
    return stillcut::shop::fail({{}, stillcut::foreign(e.what())}, 3);
  }
}
