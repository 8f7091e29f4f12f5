/// @file
/// A verb of the command: its help page and the options every verb has.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace authalic::cli {

/// What every verb needs to know about the run.
struct Session {
  bool quiet = false;
  int threads = 0;  ///< 0 = every core
};

/// The help page of a verb. Options and their defaults come from the declarations themselves.
struct VerbHelp {
  std::string name;
  std::string summary;                  ///< one line
  std::string synopsis;                 ///< what follows "authalic "
  std::string description;              ///< paragraphs, separated by blank lines
  std::vector<std::string> examples;    ///< "command\n  what it does"
  std::vector<std::string> references;
};

/// Adds a verb with --help, --quiet and --threads, and exit codes at the foot of its page.
CLI::App* addVerb(CLI::App& app, Session& session, const VerbHelp& help);

/// The page of `authalic --help`.
void describeProgram(CLI::App& app);

/// "first, second or third": the names an option takes.
[[nodiscard]] std::string oneOf(const std::vector<std::string>& names);

/// Position of `name` in `names`.
/// @throws Failure with UsageProblem naming the choices
[[nodiscard]] int choice(const std::string& option, const std::string& name, const std::vector<std::string>& names);

/// Checks of numbers on the command line, in words of ours.
[[nodiscard]] CLI::Validator notNegative();
[[nodiscard]] CLI::Validator positive();

void addInfo(CLI::App& app, Session& session);
void addMap(CLI::App& app, Session& session);
void addCut(CLI::App& app, Session& session);
void addExtract(CLI::App& app, Session& session);
void addSample(CLI::App& app, Session& session);
void addElements(CLI::App& app, Session& session);
void addWeld(CLI::App& app, Session& session);
void addDensity(CLI::App& app, Session& session);
void addBalance(CLI::App& app, Session& session);
void addConvert(CLI::App& app, Session& session);
void addRepair(CLI::App& app, Session& session);

}  // namespace authalic::cli
