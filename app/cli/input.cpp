// SPDX-License-Identifier: GPL-3.0-or-later
// Opens molecules by the input options, and checks that the options fit them.
#include "app/cli/input.hpp"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>

#include "app/cli/failure.hpp"
#include "app/cli/text/terminal.hpp"
#include "app/cli/text/text.hpp"
#include "app/options/did_you_mean.hpp"
#include "app/options/fetch_flags.hpp"
#include "app/session/net_library.hpp"
#include "core/document/fetch/fetch.hpp"
#include "core/document/fetch/molecule_id.hpp"
#include "core/document/settings/cavity_preset.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/molecule/molecule.hpp"
#include "core/read/file_format.hpp"
#include "core/read/user_radii.hpp"
#include "core/selection/selection_expression.hpp"
#include "core/selection/treatments.hpp"
#include "core/text/printable.hpp"

namespace alphascope::cli {
namespace {

void set_radii(const std::string& radii, BallOptions& balls, const RunContext& context) {
  if (radii == "auto") return;
  if (find_radii_set(radii, balls.radii) && balls.radii != RadiiSet::user) return;
  // If the path exists but cannot be read, such as a loop of links, its reader reports that.
  std::error_code ignored;
  if (std::filesystem::status(radii, ignored).type() != std::filesystem::file_type::not_found) {
    balls.radii = RadiiSet::user;
    balls.user_radii = read_user_radii(radii, context);
    return;
  }
  std::vector<std::string> ids{"auto"};
  for (const RadiiSetInfo& set : all_radii_sets()) {
    if (set.set != RadiiSet::user && set.id != "auto") ids.emplace_back(set.id);
  }
  std::string known;
  for (const std::string& id : ids) known += (known.empty() ? "" : ", ") + id;
  throw UsageError("There is no radii set \"" + radii + "\", nor a file of that name." +
                   did_you_mean(radii, ids) + " Known sets: " + known +
                   "; or give a file with a table of radii.");
}

int model_index(const std::string& text) {
  if (text == "joined") return kAllModels;
  if (text == "all") return 0;  // begins with the first model
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number < 1) {
    throw UsageError(
        "--model takes a number from 1 up, all (each by itself) or joined (all as one); "
        "not \"" +
        text + "\".");
  }
  return number - 1;
}

// Refuses chains that do not exist. They are probably typing errors, and could leave no balls.
void require_chains(const std::vector<std::string>& asked, const MoleculeContents& contents) {
  constexpr std::size_t kListed = 20;
  for (const std::string& name : asked) {
    const auto named = [&](const ChainContents& chain) { return chain.name == name; };
    if (std::any_of(contents.chains.begin(), contents.chains.end(), named)) continue;
    std::string known;
    for (std::size_t k = 0; k < std::min(kListed, contents.chains.size()); ++k) {
      const std::string& chain = contents.chains[k].name;
      known += (k ? ", " : "") + (chain.empty() ? "one without a name" : chain);
    }
    if (contents.chains.size() > kListed) {
      known += " … " + std::to_string(contents.chains.size()) + " in all";
    }
    throw std::invalid_argument("there is no chain \"" + name + "\": the file has " + known);
  }
}

// The option that brings back atoms dropped for this reason. Commands on cavities drop ligands and
// ions by default, and have other options for them.
const char* remedy_for(DropReason reason, const InputOptions& options) {
  switch (reason) {
    case DropReason::chain:
      return "Change --chain or --without-chain";
    case DropReason::selection:
      return "Change --select";
    case DropReason::dummy:
      return "Add --dummies";
    case DropReason::water:
      return "Add --waters";
    case DropReason::ion:
      return options.no_ions ? "Leave out --no-ions" : "Add --ions";
    case DropReason::ligand:
      return options.no_ligands ? "Leave out --no-ligands" : "Add --ligands";
    case DropReason::polymer:
      return "Leave out --no-polymers";
    case DropReason::hydrogen:
      return "Add --hydrogens keep";
    case DropReason::altloc:
      return "Add --altlocs all";
    case DropReason::zero_radius:
    case DropReason::without_radius:
      break;
  }
  return "Choose a radii set with --radii";
}

// Refuses an empty set of atoms, which is hardly wanted, and says why all atoms were dropped.
[[noreturn]] void refuse_without_atoms(const std::filesystem::path& file,
                                       const InputOptions& options, const SelectionReport& report) {
  const std::vector<CountedReason> reasons = drop_reasons(report);
  std::string dropped;
  for (const CountedReason& r : reasons) dropped += (dropped.empty() ? "" : ", ") + r.text;
  const auto most =
      std::max_element(reasons.begin(), reasons.end(),
                       [](const auto& a, const auto& b) { return a.count < b.count; });
  throw UsageError(file.string() + ": no atom is left" +
                   (most == reasons.end()
                        ? std::string(", because this file contains no such atoms.")
                        : ": dropped " + dropped + ". " + remedy_for(most->reason, options) + "."));
}

Input open_input(const std::filesystem::path& file, const InputOptions& options,
                 const OpenOptions& open, const RunContext& context) {
  Input input;
  input.balls = open.balls;
  const bool standard_input = file == "-";
  const std::filesystem::path name = standard_input ? "stdin" : local_file(file, options, context);
  try {
    input.open_milliseconds = timed([&] {
      OpenOptions this_one = open;
      if (standard_input) this_one.read.descriptor = STDIN_FILENO;
      input.opened = open_molecule(name, this_one, context);
    });
    require_chains(options.chains, *input.opened.contents);
    require_chains(options.without_chains, *input.opened.contents);
  } catch (const SelectionError& error) {
    throw UsageError("--select \"" + options.select + "\", " + error.what() + ".");
  } catch (const std::invalid_argument& error) {
    throw UsageError(name.string() + ": " + error.what() + ".");
  }
  return input;
}

// Checks the treatments before any file is read.
const std::vector<std::string>& checked_treatments(const std::vector<std::string>& treated) {
  try {
    for (const std::string& text : treated) parse_treatment(text);
  } catch (const std::invalid_argument& error) {
    throw UsageError("--treat: " + std::string(error.what()) + ".");
  }
  return treated;
}

}  // namespace

std::filesystem::path fetched_file(const MoleculeId& id, const InputOptions& options,
                                   const RunContext& context) {
  if (options.offline && options.fetch_again) {
    throw UsageError(kOfflineAndAgain);
  }
  FetchOptions fetch = fetch_options_of_program();
  fetch.offline = fetch.offline || options.offline;
  fetch.again = options.fetch_again;
  return fetch_molecule(id, fetch, context).file;
}

std::filesystem::path local_file(const std::filesystem::path& named, const InputOptions& options,
                                 const RunContext& context) {
  try {
    const auto id = molecule_id_unless_file(named);
    return id ? fetched_file(*id, options, context) : named;
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string(error.what()) + ".");
  }
}

OpenOptions open_options(const InputOptions& options, const RunContext& context) {
  OpenOptions open;
  open.read.format = format_from_id(options.format);  // null for auto
  set_radii(options.radii, open.balls, context);
  open.balls.model = model_index(options.model);
  open.balls.hydrogens = options.hydrogens == "keep"   ? HydrogenRule::keep
                         : options.hydrogens == "drop" ? HydrogenRule::drop
                                                       : HydrogenRule::automatic;
  open.balls.altlocs = options.altlocs == "all" ? AltlocRule::all : AltlocRule::best;
  open.balls.waters = options.waters;
  open.balls.dummies = options.dummies;
  open.balls.ligands = !options.no_ligands;
  open.balls.ions = !options.no_ions;
  open.balls.polymers = !options.no_polymers;
  open.balls.chains = options.chains;
  open.balls.without_chains = options.without_chains;
  open.balls.treated = checked_treatments(options.treated);
  open.balls.selection = options.select;
  open.assembly = options.assembly;
  return open;
}

void for_each_model(const InputOptions& options, const RunContext& context,
                    const std::function<void(const Input&)>& use) {
  for_each_model(options.file, options, open_options(options, context), context, use);
}

void for_each_model(const std::filesystem::path& file, const InputOptions& options,
                    const OpenOptions& open, const RunContext& context,
                    const std::function<void(const Input&)>& use) {
  Input input = open_input(file, options, open, context);
  std::size_t used = input.prepared().report.used;
  if (used == 0 && !each_model(options))
    refuse_without_atoms(file, options, input.prepared().report);
  use(input);
  if (!each_model(options)) return;
  const int models = static_cast<int>(input.molecule().models.size());
  for (int model = 1; model < models; ++model) {
    context.cancel.throw_if_cancelled();
    input.balls.model = model;
    input.open_milliseconds = timed([&] {
      input.opened.prepared =
          std::make_shared<const PreparedBalls>(prepare_balls(input.molecule(), input.balls));
    });
    used += input.prepared().report.used;
    use(input);
  }
  // One model may lack the wanted atoms, but not all models.
  if (used == 0) refuse_without_atoms(file, options, input.prepared().report);
}

Input open_one_model(const InputOptions& options, const char* why_one, const RunContext& context) {
  if (each_model(options)) {
    throw UsageError(std::string(why_one) +
                     " Give the number of a model, or joined for all of them as one.");
  }
  Input input = open_input(options.file, options, open_options(options, context), context);
  if (input.prepared().report.used == 0) {
    refuse_without_atoms(options.file, options, input.prepared().report);
  }
  return input;
}

OpenOptions body_options(const InputOptions& options, const BodyOptions& body,
                         const RunContext& context) {
  OpenOptions open = open_options(options, context);
  open.balls.ligands = body.ligands;
  open.balls.ions = body.ions;
  return open;
}

Input with_body_radii(Input input, const InputOptions& options) {
  const RadiiSet radii = cavity_body({}, input.molecule().has_file_radii).radii;
  if (options.radii != "auto" || radii == RadiiSet::file) return input;
  input.balls.radii = radii;
  input.opened.prepared =
      std::make_shared<const PreparedBalls>(prepare_balls(input.molecule(), input.balls));
  return input;
}

std::vector<std::string> input_notes(const Input& input) {
  std::vector<std::string> notes = input.molecule().notes;
  if (input.prepared().balls->size() == 0) {
    notes.push_back(
        "no atom is left, so every complex is empty; --help lists the options that keep more "
        "atoms");
  }
  return notes;
}

std::string input_text(const Input& input) {
  std::string text = printable(input.molecule().source.filename().string()) + ": " +
                     summary(input.prepared().report) + "\n";
  if (input.balls.model == kAllModels && input.molecule().models.size() > 1) {
    text += "  all " + std::to_string(input.molecule().models.size()) + " models as one\n";
  } else if (input.molecule().models.size() > 1) {
    text += "  model " + model_text(input.balls.model) + " of " +
            std::to_string(input.molecule().models.size()) + "\n";
  }
  if (verbosity() == Verbosity::quiet) return text;
  for (const std::string& note : input_notes(input)) text += "  note: " + note + "\n";
  return text;
}

}  // namespace alphascope::cli
