#include "Verb.h"

#include <algorithm>
#include <memory>
#include <sstream>

#include "Console.h"

namespace authalic::cli {
namespace {

constexpr std::size_t pageWidth = 88;

/// Breaks text at blanks; blank lines between paragraphs stay.
std::string wrapped(const std::string& text, std::size_t indent) {
  std::istringstream lines(text);
  std::ostringstream out;
  const std::string margin(indent, ' ');
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string current;
    for (std::string word; words >> word;) {
      if (!current.empty() && indent + current.size() + 1 + word.size() > pageWidth) {
        out << margin << current << "\n";
        current.clear();
      }
      current += (current.empty() ? "" : " ") + word;
    }
    out << (current.empty() ? "" : margin + current) << "\n";
  }
  return out.str();
}

const char* exitCodes =
    "0    success\n\n1    a solver failed\n\n2    wrong use of the command, or an option out of range\n\n"
    "3    the surface has the wrong topology or bad geometry\n\n"
    "4    not converged (the best result is written; --allow-nonconverged makes it 0)\n\n"
    "5    a file is missing, unreadable, malformed or cannot be written\n\n130  interrupted; nothing is written";

class Page : public CLI::Formatter {
 public:
  explicit Page(VerbHelp help) : help_(std::move(help)) {}

  std::string make_help(const CLI::App* app, std::string, CLI::AppFormatMode) const override {
    std::ostringstream out;
    out << "authalic " << help_.name << (help_.name.empty() ? "" : " ") << "- " << help_.summary << "\n\nSYNOPSIS\n\n"
        << wrapped("authalic " + help_.synopsis, 4) << "\nDESCRIPTION\n\n" << wrapped(help_.description, 4);
    out << section("VERBS", verbs(app)) << make_positionals(app)
        << compact(make_groups(app, CLI::AppFormatMode::Normal), "\n\n\n");
    if (!help_.examples.empty()) out << "\nEXAMPLES\n";
    for (const std::string& example : help_.examples) out << "\n" << indented(example);
    std::string references;
    for (const std::string& reference : help_.references) {
      references += (references.empty() ? "" : "\n") + reference + "\n";
    }
    out << section("REFERENCES", references) << section("EXIT CODES", compact(exitCodes, "\n\n"));
    return out.str();
  }

  std::string make_group(std::string group, bool positional, std::vector<const CLI::Option*> options) const override {
    std::transform(group.begin(), group.end(), group.begin(), [](unsigned char c) { return std::toupper(c); });
    std::string out = "\n" + group + "\n";
    for (const CLI::Option* option : options) out += make_option(option, positional);
    return out;
  }

  std::string make_option(const CLI::Option* option, bool positional) const override {
    std::string line = positional ? option->get_name(true, false) : option->get_name(false, true);
    std::replace(line.begin(), line.end(), ',', ' ');
    const std::string type = option->get_type_name();  // "N:INT in [0 - 1024]": what checks add is not for readers
    if (!positional && option->get_type_size() != 0) line += " " + type.substr(0, type.find(':'));
    std::string text = option->get_description();
    if (!option->get_default_str().empty()) text += " (default: " + option->get_default_str() + ")";
    if (option->get_required() && !positional) text += " (required)";
    return "\n    " + line + "\n" + wrapped(text, 8);
  }

 private:
  static std::string section(const std::string& title, const std::string& text) {
    return text.empty() ? std::string() : "\n" + title + "\n\n" + wrapped(text, 4);
  }
  /// Takes one line break out of every run that `breaks` spells.
  static std::string compact(std::string text, const std::string& breaks) {
    for (std::size_t at = text.find(breaks); at != std::string::npos; at = text.find(breaks, at)) text.erase(at, 1);
    return text;
  }
  static std::string indented(const std::string& example) {
    std::istringstream lines(example);
    std::string out;
    for (std::string line; std::getline(lines, line);) out += "    " + line + "\n";
    return out;
  }
  static std::string verbs(const CLI::App* app) {
    std::string out;
    for (const CLI::App* verb : app->get_subcommands([](const CLI::App* sub) { return !sub->get_name().empty(); })) {
      out += verb->get_name() + ": " + verb->get_description() + "\n";
    }
    return out;
  }

  VerbHelp help_;
};

CLI::Validator numberCheck(const std::string& required, bool (*holds)(double)) {
  return CLI::Validator(
      [required, holds](std::string& text) {
        double value = 0;
        const bool good = CLI::detail::lexical_cast(text, value) && holds(value);
        return good ? std::string() : required + " is required; it is '" + text + "'";
      },
      std::string());
}

}  // namespace

CLI::Validator notNegative() {
  return numberCheck("a number of 0 or more", [](double value) { return value >= 0; });
}

CLI::Validator positive() {
  return numberCheck("a number above 0", [](double value) { return value > 0; });
}

CLI::App* addVerb(CLI::App& app, Session& session, const VerbHelp& help) {
  CLI::App* verb = app.add_subcommand(help.name, help.summary);
  auto page = std::make_shared<Page>(help);
  page->label("Positionals", "Arguments");
  verb->formatter(page);
  verb->set_help_flag("-h,--help", "Show this page.");
  verb->add_flag("-q,--quiet", session.quiet, "No progress bar and no warnings.");
  verb->add_option("--threads", session.threads, "Threads to use; 0 is every core. Results do not depend on it.")
      ->type_name("N")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  return verb;
}

void describeProgram(CLI::App& app) {
  VerbHelp help;
  help.summary = "area-preserving maps of cortical surfaces";
  help.synopsis = "VERB ARGUMENTS [OPTIONS]";
  help.description =
      "Turns a T1 volume into cortical surfaces, opens them to disks, maps them to the plane without changing "
      "areas, and makes statistics on elements of equal native area. Each verb does one step and leaves files "
      "that the next one reads; authalic VERB --help describes it.\n\n"
      "stdout is data, stderr is words. Files appear whole or not at all. Coordinates are scanner RAS in mm.";
  help.examples = {
      "authalic extract t1.nii.gz --labels aal.nii.gz -o surfaces\nauthalic cut surfaces/lh.white.vtp -o lh.disk.vtp\n"
      "authalic map lie-flow lh.disk.vtp -o lh.map.vtp --report lh.map.json\n"
      "authalic sample pet.nii.gz lh.map.vtp -o lh.pet.vtp --mode along-normal\n"
      "authalic elements lh.pet.vtp -o lh.elements.tsv\n"};
  auto page = std::make_shared<Page>(help);
  app.formatter(page);
  app.set_help_flag("-h,--help", "Show this page.");
}

std::string oneOf(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == names.size() ? " or " : ", ") + names[i];
  }
  return text;
}

int choice(const std::string& option, const std::string& name, const std::vector<std::string>& names) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    throw Failure(UsageProblem, option + " must be " + oneOf(names) + "; it is '" + name + "'.");
  }
  return static_cast<int>(found - names.begin());
}

}  // namespace authalic::cli
