// What every command of stillcut-cli shares: it registers itself as a CLI11 subcommand and leaves its exit code.
// Exit codes: 0 done, 1 chatter was found (`analyze`), 2 wrong usage or unreadable input (one line on stderr), 3 a
// device or machine failed.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "core/base/result.h"

namespace stillcut::app {

inline constexpr int kExitDone = 0;
inline constexpr int kExitChatter = 1;
inline constexpr int kExitInput = 2;
inline constexpr int kExitDevice = 3;

// Prints the error as one line, whatever a file name or a library put into it, and gives `code` back.
int fail(const Error& error, int code = kExitInput);

// Each adds its subcommand; the callback sets `exitCode`.
void addSimulate(CLI::App& app, int& exitCode);
void addAnalyze(CLI::App& app, int& exitCode);
void addInfo(CLI::App& app, int& exitCode);
void addRun(CLI::App& app, int& exitCode);
void addModal(CLI::App& app, int& exitCode);
void addCouple(CLI::App& app, int& exitCode);
void addCoefficients(CLI::App& app, int& exitCode);
void addLobes(CLI::App& app, int& exitCode);
void addAdvise(CLI::App& app, int& exitCode);
void addMaterials(CLI::App& app, int& exitCode);
void addConvert(CLI::App& app, int& exitCode);
void addDevices(CLI::App& app, int& exitCode);
void addScore(CLI::App& app, int& exitCode);
void addCalibrate(CLI::App& app, int& exitCode);
void addKnock(CLI::App& app, int& exitCode);
void addLearn(CLI::App& app, int& exitCode);
void addParameters(CLI::App& app, int& exitCode);
void addPath(CLI::App& app, int& exitCode);
void addReproduce(CLI::App& app, int& exitCode);

}  // namespace stillcut::app
