// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "nearest_name.hpp"
#include "planescope/error.hpp"
#include "planescope/render.hpp"

namespace planescope::cli {
namespace {

std::string version() {
  std::string text = "planescope " PLANESCOPE_VERSION "\nVTK " + vtk_version();
#ifdef PLANESCOPE_PCL_VERSION
  text += "\nPCL " PLANESCOPE_PCL_VERSION;
#endif
  try {
    return text + "\nGL renderer " + gl_renderer();
  } catch (const Error& error) {
    return text + "\nGL renderer none: " + error.what();
  }
}

/// "; did you mean ...?" for a word that nothing took: an option of the chosen subcommand, or a
/// subcommand.
std::string suggestion(const CLI::App& program, const std::string& word) {
  std::vector<std::string> names;
  const auto chosen = program.get_subcommands();
  if (chosen.empty()) {
    for (const CLI::App* command : program.get_subcommands({}))
      names.push_back(command->get_name());
  } else if (word.starts_with("--")) {
    for (const CLI::Option* option : chosen.front()->get_options()) {
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
  }
  const std::string nearest = nearest_name(word.substr(0, word.find('=')), names);
  return nearest.empty() ? nearest : "; did you mean " + nearest + "?";
}

/// What is wrong, in one line. CLI11 says it well but for words that it does not know.
std::string describe(const CLI::App& program, const CLI::ParseError& error) {
  const auto words = program.remaining(true);
  const bool extra = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
  if (words.empty() || (!extra && !program.get_subcommands().empty())) return error.what();
  const bool option_sought = !program.get_subcommands().empty();
  const auto found = std::ranges::find_if(
      words, [&](const std::string& w) { return w.starts_with("-") == option_sought; });
  const std::string word = found != words.end() ? *found : words.back();
  return "`" + word + "` is not expected here" + suggestion(program, word);
}

[[noreturn]] void refuse(const CLI::App& program, const CLI::ParseError& error) {
  const auto chosen = program.get_subcommands();
  throw Error(Error::Kind::Usage, describe(program, error) + "; see planescope " +
                                      (chosen.empty() ? "" : chosen.front()->get_name() + " ") +
                                      "--help");
}

}  // namespace

int run_program(int argc, char** argv) {
  CLI::App program("Segments indoor 3D maps into planes and objects, and draws it.", "planescope");
  program.require_subcommand(1);
  program.set_version_flag("--version", version, "Versions of planescope, VTK, PCL and OpenGL");
  const std::vector<Command> commands = {
      add_segment(program),     add_render(program),     add_evaluate(program),
      add_compare(program),     add_figure(program),     add_batch(program),
      add_reconstruct(program), add_synthesize(program), add_track(program)};
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& help) {  // --help, --version
    return program.exit(help);
  } catch (const CLI::ParseError& error) {
    refuse(program, error);
  }
  for (const Command& command : commands) {
    if (command.app->parsed()) command.run();
  }
  return 0;
}

}  // namespace planescope::cli
