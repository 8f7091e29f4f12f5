#include <filesystem>
#include <memory>

#include <vtkBalanceCurve.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include "Density.h"
#include "Files.h"
#include "Pipeline.h"

namespace authalic::cli {
namespace {

struct BalanceOptions {
  std::string surface, output;
  std::optional<int> values;
  std::vector<double> at;
  bool allowNonconverged = false;
  DensityOptions density;
  SpaceOption space;
};

VerbHelp balanceHelp() {
  VerbHelp help;
  help.name = "balance";
  help.summary = "what angles cost areas on a surface: the curve by which --balance is chosen";
  help.synopsis = "balance SURFACE -o CURVE.tsv [--values N | --at T...] [OPTIONS]";
  help.description =
      "Maps a disk, or a closed surface of genus 0 to the sphere, with balances from 0 (conformal) to 1 "
      "(area-preserving), and writes one row for each: angle and area distortion (ideal 2), mean angle error and "
      "folded faces of the map, and of the map by transport alone before its finish. To tolerances that are enough to "
      "choose by; authalic map balanced --balance T then makes the map.";
  help.examples = {"authalic balance lh.pial -o lh.curve.tsv\n  11 maps of a closed cortex to the sphere"};
  help.references = {"Nadeem et al. 2017, spherical parameterization balancing angle and area distortions"};
  return help;
}

void runBalance(const BalanceOptions& o, const Session& session) {
  const std::string about = std::filesystem::path(o.output).replace_extension(".json").string();
  requireWritable({o.output, about});
  vtkSmartPointer<vtkPolyData> surface = readSurface(o.surface, session, o.space);
  vtkNew<vtkBalanceCurve> curve;
  if (o.values) curve->SetNumberOfBalances(*o.values);
  for (const double balance : o.at) curve->AddBalance(balance);
  curve->SetMeasureArrayName(o.density.apply(surface, session));
  curve->SetInputData(surface);
  const int code = update(curve.Get(), session);
  writeText(o.output, curve->GetText());
  writeText(about, curve->GetReport());
  if (code != NotConverged || o.allowNonconverged) return;
  throw Failure(NotConverged, "A map of the curve did not reach its tolerance; all rows are in " + o.output +
                                  " (--allow-nonconverged accepts them).");
}

}  // namespace

void addBalance(CLI::App& app, Session& session) {
  auto o = std::make_shared<BalanceOptions>();
  vtkNew<vtkBalanceCurve> defaults;
  CLI::App* verb = addVerb(app, session, balanceHelp());
  verb->add_option("SURFACE", o->surface, "A disk or a closed surface of genus 0, in any format.")->required();
  verb->add_option("-o,--output", o->output, "One row per balance; the description goes beside it as .json.")
      ->type_name("CURVE.tsv")->required();
  CLI::Option* count = verb->add_option("--values", o->values, "How many balances, from 0 to 1 in equal steps.")
                           ->type_name("N")
                           ->check(CLI::Range(defaults->GetNumberOfBalancesMinValue(),
                                              defaults->GetNumberOfBalancesMaxValue()))
                           ->default_str(std::to_string(defaults->GetNumberOfBalances()));
  verb->add_option("--at", o->at, "These balances instead, each 0 to 1, in order.")
      ->type_name("T...")->check(CLI::Range(0.0, 1.0))->excludes(count);
  verb->add_flag("--allow-nonconverged", o->allowNonconverged, "Exit 0 although a tolerance was not reached.");
  o->density.declare(verb);
  o->space.declare(verb);
  verb->callback([o, &session] { runBalance(*o, session); });
}

}  // namespace authalic::cli
