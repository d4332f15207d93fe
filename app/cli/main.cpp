// stillcut-cli: the program without a screen. One subcommand per file; see README, "Command line".

#include <cstdio>
#include <exception>

#include "app/cli/command.h"
#include "generated/version.h"

namespace stillcut::app {

int fail(const Error& error, int code) {
  std::fprintf(stderr, "stillcut-cli: %s\n", error.line().c_str());
  return code;
}

namespace {

int run(int argc, char** argv) {
  CLI::App app{"Stillcut tells chatter before it marks the part, and what to do about it."};
  app.set_version_flag("--version", "stillcut-cli " STILLCUT_VERSION);
  app.require_subcommand(1);
  int exitCode = kExitDone;
  addSimulate(app, exitCode);
  addAnalyze(app, exitCode);
  addInfo(app, exitCode);
  addRun(app, exitCode);
  addModal(app, exitCode);
  addCoefficients(app, exitCode);
  addLobes(app, exitCode);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& done) {
    return app.exit(done);  // --help, --version
  } catch (const CLI::ParseError& wrong) {
    return fail({"command line", wrong.what(), "see --help"});
  }
  return exitCode;
}

}  // namespace
}  // namespace stillcut::app

int main(int argc, char** argv) {
  try {
    return stillcut::app::run(argc, argv);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "stillcut-cli: %s\n", e.what());
    return stillcut::app::kExitInput;
  }
}
