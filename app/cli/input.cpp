#include "app/cli/input.hpp"

#include <charconv>
#include <chrono>

#include "core/io/user_radii.hpp"

namespace alphascope::cli {
namespace {

void set_radii(const std::string& radii, BallOptions& balls, const RunContext& context) {
  if (radii == "auto") return;
  if (find_radii_set(radii, balls.radii) && balls.radii != RadiiSet::user) return;
  if (std::filesystem::exists(radii)) {
    balls.radii = RadiiSet::user;
    balls.user_radii = read_user_radii(radii, context);
    return;
  }
  std::string known = "auto";
  for (const RadiiSetInfo& set : all_radii_sets()) {
    if (set.set != RadiiSet::user && set.id != "auto") known += ", " + std::string(set.id);
  }
  throw UsageError("There is no radii set \"" + radii + "\", nor a file of that name. Known sets: " +
                   known + "; or give a file with a table of radii.");
}

int model_index(const std::string& text) {
  if (text == "all") return kAllModels;
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number < 1) {
    throw UsageError("--model takes a number from 1 up, or all; not \"" + text + "\".");
  }
  return number - 1;
}

}  // namespace

Input open_input(const InputOptions& options, const RunContext& context) {
  OpenOptions open;
  set_radii(options.radii, open.balls, context);
  open.balls.model = model_index(options.model);
  open.balls.hydrogens = options.hydrogens == "keep"   ? HydrogenRule::keep
                         : options.hydrogens == "drop" ? HydrogenRule::drop
                                                       : HydrogenRule::automatic;
  open.balls.altlocs = options.altlocs == "all" ? AltlocRule::all : AltlocRule::best;
  open.balls.waters = options.waters;
  open.balls.ligands = !options.no_ligands;
  open.balls.ions = !options.no_ions;
  open.balls.chains = options.chains;
  open.balls.selection = options.select;
  open.assembly = options.assembly;

  Input input;
  input.selection_expression = options.select;
  const auto start = std::chrono::steady_clock::now();
  input.opened = open_molecule(options.file, open, context);
  input.open_milliseconds = std::chrono::duration<double, std::milli>(
                                std::chrono::steady_clock::now() - start).count();
  return input;
}

std::string input_text(const Input& input) {
  std::string text = input.molecule().source.filename().string() + ": " +
                     summary(input.prepared().report) + "\n";
  for (const std::string& note : input.molecule().notes) text += "  note: " + note + "\n";
  if (input.prepared().balls->size() == 0) {
    text += "  note: no atom is left, so every complex is empty; see --help for what is kept\n";
  }
  return text;
}

}  // namespace alphascope::cli
