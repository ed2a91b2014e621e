// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the cavities of a molecule, and writes the notes on its result.
#include "app/cli/cavities/cavity_answer.hpp"

#include <memory>

#include "app/cli/derived_results.hpp"
#include "app/cli/report_json.hpp"
#include "app/cli/text/text.hpp"
#include "app/session/rounding_note.hpp"
#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_lives.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/document/cavities/cavity_contents.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/channels/network_results.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/settings/cavity_preset.hpp"
#include "core/document/store/derived.hpp"
#include "core/document/store/inputs.hpp"
#include "core/predicates/flow_predicate.hpp"
#include "core/run/work_threads.hpp"
#include "core/text/grouped_number.hpp"
#include "core/triangulation/triangulation_report.hpp"

namespace alphascope::cli {
namespace {

bool is_wanted(const CavityAnswer& answer, const CavitiesOptions& options, std::size_t row) {
  const double volume = answer.table().measure(row).volume_sa_angstrom3;
  return !options.min_volume_angstrom3 || volume >= *options.min_volume_angstrom3;
}

// Whether to compute at which solvent radius a listed network comes apart. A comparison of radii
// needs no such number.
bool wants_network_end(const CavityAnswer& answer, const CavitiesOptions& options,
                       std::size_t row) {
  return !options.no_network_radius && !options.compares() &&
         answer.table().cavity(row).is_network() && is_wanted(answer, options, row);
}

Inputs inputs_of(const CavityAnswer& answer, const CavitiesOptions& options, int threads) {
  const Request& request = answer.request;
  Inputs inputs =
      derived_inputs(answer.input, request.solvent_radius_angstrom, request.alpha_angstrom2);
  inputs.atoms = answer.atoms;
  inputs.split_networks = options.split_networks;
  inputs.flow_ties = options.ties;
  inputs.outside_rule = options.rule;
  inputs.triangulation_threads = threads;
  return inputs;
}

void fill(CavityAnswer& answer, const CavitiesOptions& options, int threads,
          const RunContext& context) {
  StageTimer timer(answer.times);
  const Inputs inputs = inputs_of(answer, options, threads);
  Evaluator evaluator = make_evaluator();
  const auto made = [&](const auto& definition) {
    return evaluator.evaluate(definition, inputs, context);
  };
  const auto triangulation = made(whole_triangulation());
  timer.lap(stage::kTriangulation, true);
  if (made_by_device(*triangulation)) {
    answer.device += ", triangulation on " + triangulation->report->maker;
  }
  made(cavity_ground());
  timer.lap(stage::kFlow, true);
  answer.all = made(cavity_table());
  timer.lap(stage::kCavities);
  if (!options.no_exact_volumes) {
    answer.exact = made(cavity_volumes());
    timer.lap(stage::kExactVolumes);
    answer.exact_rank = ranks_by_exact_volume(answer.table(), *answer.exact);
  }
  answer.depths = made(cavity_depths());
  answer.lives = answer.table().size() > 0 || !options.lives.empty()
                     ? made(whole_cavity_lives())
                     : std::make_shared<const CavityLives>();
  answer.contents = made(cavity_contents());
  timer.lap("depths, lives, contents");
  for (std::size_t row = 0; row < answer.table().size(); ++row) {
    if (!wants_network_end(answer, options, row)) continue;
    answer.network_ends[row] = made(network_end(answer.table().sink(row)))->end;
  }
  if (!answer.network_ends.empty()) timer.lap(kNetworkStage);
  timer.finish();
}

}  // namespace

CavityAnswer::CavityAnswer(const Input& of) : input(of) {
  source = source_of(of);
  atoms = std::make_shared<const BallReferences>(of.opened.molecule, of.opened.prepared);
}

CavityAnswer find_cavities_of(const Input& input, const CavitiesOptions& options,
                              double solvent_radius_angstrom, const RunContext& context) {
  CavityAnswer answer(input);
  answer.request = options.request;
  answer.request.solvent_radius_angstrom = solvent_radius_angstrom;
  answer.differences = differences_from_castp(input.balls, input.prepared().report, answer.request);
  if (options.rule == OutsideRule::pocket)
    answer.differences.push_back("the rule of the program Pocket for what is outside");
  if (options.split_networks) answer.differences.push_back(kNetworksAreSplit);
  if (options.ties == FlowTies::strict) answer.differences.push_back("ties do not flow");
  WorkThreads threads(answer.request.threads);
  answer.device = threads.text();
  threads.run([&] { fill(answer, options, threads.used(), context); });
  for (std::size_t row = 0; row < answer.table().size(); ++row) {
    if (is_wanted(answer, options, row)) answer.rows.push_back(row);
  }
  return answer;
}

namespace {

constexpr double kNarrowAngstrom = 0.5;

// Says at which solvent radius and alpha no network is left, and into how many cavities it falls
// apart.
std::string parting_text(const NetworkEnd* end) {
  if (!end) return "a larger --solvent divides it";
  const auto cavities = [](std::size_t n) {
    return n == 0 ? std::string("no cavity") : counted(n, "cavity", "cavities");
  };
  std::string text;
  if (end->radius_angstrom) {
    text = "at --solvent " + radius_text(*end) + ", to " + shortest_number(kNetworkStepAngstrom) +
           " Å, no network is left of it, but " + cavities(end->cavities);
    if (end->cavities > 0) {
      text += ", the largest of " + format_text("%.3f", end->largest_volume_sa_angstrom3) + " Å³";
    }
  } else {
    text = "at --solvent " + shortest_number(end->largest_radius_angstrom) +
           " a network still remains";
  }
  if (end->alpha_angstrom2) {
    text += "; with this solvent radius none is left at --alpha " + alpha_text(*end) + ", but " +
            cavities(end->parts);
  }
  return text;
}

// Returns a note that networks are listed as their parts.
std::string split_note(const CavityTable& table) {
  std::string text;
  for (const SplitNetwork& network : table.found.networks) {
    text += (text.empty() ? "" : ", and ") + std::string("a network of ") +
            counted(network.mouths, "mouth", "mouths") + " is listed as " +
            counted(network.parts, "part", "parts") + ", which are apart at alpha " +
            shortest_number(network.falls_apart_angstrom2) + " Å²";
  }
  return text.empty() ? text : text + "; passages between parts are no mouths";
}

// Returns a note on listed networks; empty if the solvent radius already explains them.
std::string network_note(const CavityAnswer& answer) {
  const CavityTable& table = answer.table();
  std::string text;
  std::size_t networks = 0;
  for (const std::size_t row : answer.rows) {
    if (!table.cavity(row).is_network() || ++networks > 1) continue;
    text = "cavity " + grouped(row + 1) + " has " + grouped(table.cavity(row).mouths.size()) +
           " mouths: it is a network of connected gaps, and not a single hole; " +
           parting_text(answer.network_end(row)) + "; --split-networks lists its parts";
  }
  if (networks == 0) return {};
  if (networks > 1) text += "; further networks: " + grouped(networks - 1);
  return text;
}

}  // namespace

std::vector<std::string> notes_of(const CavityAnswer& answer, const CavitiesOptions& options) {
  std::vector<std::string> notes;
  const CavityTable& table = answer.table();
  const std::string rounding = rounding_note(answer.request, table.ground->balls->lattice);
  if (!rounding.empty()) notes.push_back(rounding);
  if (table.ground->triangulation->dimension < 3) {
    notes.push_back("the centres lie in one plane, so there are no cavities");
  }
  if (table.found.components > 1) {
    notes.push_back("the body has " + grouped(static_cast<std::uint64_t>(table.found.components)) +
                    " separate parts: spaces between them count as pockets");
  }
  if (answer.request.solvent_radius_angstrom < kNarrowAngstrom && table.size() > 0) {
    notes.push_back(
        "with this small solvent radius, the gaps between atoms form one large pocket; use "
        "--solvent 1.4 to divide it");
  } else if (const std::string network = network_note(answer); !network.empty()) {
    notes.push_back(network);
  }
  if (const std::string split = split_note(table); !split.empty()) notes.push_back(split);
  if (!answer.exact && table.size() > 0) {
    notes.push_back("exact (clipped) volumes are left out because of --no-clipped");
  }
  if (answer.rows.size() < table.size()) {
    notes.push_back(counted(table.size() - answer.rows.size(), "cavity", "cavities") + " below " +
                    shortest_number(*options.min_volume_angstrom3) +
                    " Å³ are counted, but not listed");
  }
  return notes;
}

}  // namespace alphascope::cli
