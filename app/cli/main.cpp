// stillcut-cli: the program without a screen. One subcommand per file; see README, "Command line".

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/command.h"
#include "app/compose/build_info.h"
#include "core/config/nearest_word.h"

namespace stillcut::app {

int fail(const Error& error, int code) {
  std::string line = error.line();
  std::replace_if(
      line.begin(), line.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  std::fprintf(stderr, "stillcut-cli: %s\n", line.c_str());
  return code;
}

namespace {

Message hint(std::string_view word, const std::vector<std::string>& known) {
  const std::vector<std::string_view> words(known.begin(), known.end());
  Message near = config::didYouMean(word, words);
  return near.empty() ? message("see --help") : near;
}

std::vector<std::string> commandNames(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(command->get_name());
  }
  return names;
}

// The parser's "Could not convert: --teeth = two", in words of the user.
std::optional<Error> conversionError(const CLI::App& command, std::string_view told, const Message& help) {
  constexpr std::string_view kBegin = "Could not convert: ", kBetween = " = ";
  if (!told.starts_with(kBegin)) return std::nullopt;
  told.remove_prefix(kBegin.size());
  const std::size_t between = told.find(kBetween);
  if (between == std::string_view::npos) return std::nullopt;
  const std::string name(told.substr(0, between)), value(told.substr(between + kBetween.size()));
  if (value.find_first_of(", ") != std::string::npos)
    return Error{name, message("'%1' is no number", value), message("write 10100 or 0.5: no commas, no blanks")};
  const CLI::Option* option = command.get_option_no_throw(name);
  const bool whole = option != nullptr && option->get_type_name().starts_with("INT");
  return Error{name, whole ? message("'%1' is no whole number", value) : message("'%1' is no number", value), help};
}

// What the parser makes of wrong usage says which rule was broken; the user wants to know which word was wrong.
Error usageError(const CLI::App& app, const CLI::ParseError& wrong, std::string_view first) {
  const std::vector<CLI::App*> parsed = app.get_subcommands();
  if (parsed.empty()) {
    if (first.empty() || first.starts_with("-"))
      return {message("command line"), message("a command is needed"), message("see --help")};
    return {message("command line"), message("'%1' is no command", first), hint(first, commandNames(app))};
  }
  const CLI::App* innermost = parsed.front();
  while (!innermost->get_subcommands().empty()) innermost = innermost->get_subcommands().front();
  const CLI::App& command = *innermost;
  for (const std::string& word : app.remaining(true)) {
    if (!word.starts_with("--")) continue;
    std::vector<std::string> options;
    for (const CLI::Option* option : command.get_options()) {
      for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
    }
    const std::string name = word.substr(0, word.find('='));
    return {command.get_name(), message("'%1' is no option", name), hint(name, options)};
  }
  const Message help = message("see stillcut-cli %1 --help", command.get_name());
  if (auto conversion = conversionError(command, wrong.what(), help)) return *conversion;
  return {command.get_name(), foreign(wrong.what()), help};
}

int run(int argc, char** argv) {
  CLI::App app{"Stillcut detects chatter in milling, and says what to do about it."};
  app.set_version_flag(
      "--version", [] { return versionText("stillcut-cli", "CLI11 " CLI11_VERSION); }, "Version, commit and libraries");
  app.require_subcommand(1);
  int exitCode = kExitDone;
  addSimulate(app, exitCode);
  addAnalyze(app, exitCode);
  addInfo(app, exitCode);
  addRun(app, exitCode);
  addModal(app, exitCode);
  addCouple(app, exitCode);
  addCoefficients(app, exitCode);
  addLobes(app, exitCode);
  addAdvise(app, exitCode);
  addMaterials(app, exitCode);
  addConvert(app, exitCode);
  addDevices(app, exitCode);
  addScore(app, exitCode);
  addCalibrate(app, exitCode);
  addKnock(app, exitCode);
  addLearn(app, exitCode);
  addPath(app, exitCode);
  addReproduce(app, exitCode);
  addParameters(app, exitCode);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& done) {
    return app.exit(done);  // --help, --version
  } catch (const CLI::ParseError& wrong) {
    return fail(usageError(app, wrong, argc > 1 ? argv[1] : ""));
  }
  return exitCode;
}

}  // namespace
}  // namespace stillcut::app

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow any more is an error of that file, not the program's end
  try {
    return stillcut::app::run(argc, argv);
  } catch (const std::exception& e) {
    return stillcut::app::fail({{}, stillcut::foreign(e.what())});
  }
}
