#include <exception>

#include "Console.h"
#include "Reports/Version.h"
#include "Verb.h"

int main(int argc, char** argv) {
  using namespace authalic::cli;
  prepareConsole();
  CLI::App app;
  Session session;
  describeProgram(app);
  app.set_version_flag("--version", authalic::version());
  app.require_subcommand(1);
  for (const auto add :
       {addInfo, addMap, addBalance, addWeld, addCut, addExtract, addSample, addElements, addDensity, addConvert,
        addRepair}) {
    add(app, session);
  }
  try {
    app.parse(argc, argv);
    return Success;
  } catch (const CLI::Success& e) {
    return app.exit(e);
  } catch (const CLI::ParseError& e) {
    sayError(std::string(e.what()) + "; authalic --help lists verbs and options.");
    return UsageProblem;
  } catch (const Failure& e) {
    sayError(e.what());
    return e.code();
  } catch (const std::exception& e) {
    sayError(e.what());
    return SolverProblem;
  }
}
