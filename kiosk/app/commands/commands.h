#pragma once

#include <CLI/CLI.hpp>

namespace onggi::app {

/// Each adds its subcommand to `app`; when that is the one called, `exit_code` gets what it came
/// to: 0 good, 1 the program's or the machine's fault, 2 the input's.
void add_run(CLI::App& app, int& exit_code);
void add_visit(CLI::App& app, int& exit_code);
void add_replay(CLI::App& app, int& exit_code);
void add_check(CLI::App& app, int& exit_code);
void add_vessel(CLI::App& app, int& exit_code);
void add_score(CLI::App& app, int& exit_code);
void add_soak(CLI::App& app, int& exit_code);
void add_lab(CLI::App& app, int& exit_code);

/// Of `onggi vessel`.
void add_inspect(CLI::App& vessel, int& exit_code);
void add_import(CLI::App& vessel, int& exit_code);

}  // namespace onggi::app
