// SPDX-License-Identifier: GPL-3.0-or-later
// Counts secondary structure and bonds of an input.
#include "app/cli/commands/info_structure.hpp"

#include <array>
#include <span>
#include <utility>

#include "app/cli/input.hpp"
#include "app/cli/text/terminal.hpp"
#include "core/bonds/bonds.hpp"
#include "core/molecule/molecule.hpp"
#include "core/selection/ball_options.hpp"
#include "core/selection/residue_list.hpp"

namespace alphascope::cli {
namespace {

// The models that are used: one, or all where they are joined.
std::span<const ModelRange> models_of(const Input& input) {
  const std::vector<ModelRange>& models = input.molecule().models;
  if (input.balls.model == kAllModels) return models;
  return std::span(models).subspan(static_cast<std::size_t>(input.balls.model), 1);
}

// Counts of stretches and of residues of each kind.
Json secondary_json(const SecondaryModel& secondary) {
  std::array<std::size_t, kSecondaryStructures> residues{};
  for (const SecondaryStructure kind : secondary.kinds) ++residues[static_cast<std::size_t>(kind)];
  Json kinds = Json::object();
  for (std::size_t k = 0; k < kSecondaryStructures; ++k) {
    kinds[secondary_id(static_cast<SecondaryStructure>(k))] = {{"stretches", secondary.runs[k]},
                                                               {"residues", residues[k]}};
  }
  return {{"source", secondary_source_id(secondary.source)},
          {"kinds", std::move(kinds)},
          {"residues_without_backbone", secondary.incomplete}};
}

Json bonds_json(const BondList& list) {
  const auto reason = [&](BondReason why) { return list.reasons[static_cast<std::size_t>(why)]; };
  return {{"bonds", list.bonds.size()},
          {"from_file", reason(BondReason::file)},
          {"of_known_residues", reason(BondReason::residue)},
          {"between_neighbours", reason(BondReason::chain_link)},
          {"guessed", list.guessed()},
          {"to_metals", list.coordinations},
          {"left_out", list.too_long + list.other_copies + list.unresolved},
          {"crowded_atoms", list.crowded}};
}

}  // namespace

std::vector<SecondaryModel> secondary_of(const Input& input) {
  std::vector<SecondaryModel> list;
  for (const ModelRange& model : models_of(input)) {
    list.push_back(
        find_secondary(input.molecule(), model, SecondaryChoice::automatic, run_context()));
  }
  return list;
}

SecondaryKinds kinds_by_atom(const std::vector<SecondaryModel>& models) {
  SecondaryKinds kinds;
  for (const SecondaryModel& model : models) {
    for (std::size_t k = 0; k < model.residues.size(); ++k) {
      kinds.emplace_hint(kinds.end(), model.residues[k].ca, model.kinds[k]);
    }
  }
  return kinds;
}

std::string secondary_of(const SecondaryKinds& kinds, const ListedResidues& residue) {
  const auto found = kinds.lower_bound(residue.first_atom);
  const bool inside = found != kinds.end() && found->first < residue.first_atom + residue.atoms;
  return inside ? secondary_id(found->second) : std::string();
}

std::string structure_text(const Input& input) {
  const std::span<const ModelRange> models = models_of(input);
  if (models.size() != 1) return {};
  std::string text;
  const std::string secondary = summary(secondary_of(input).front());
  if (!secondary.empty()) text += "secondary   " + secondary + "\n";
  const BondList bonds = find_bonds(input.molecule(), models.front(), run_context());
  if (!bonds.bonds.empty()) text += "bonds       " + summary(bonds) + "\n";
  return text;
}

void add_structure_json(const Input& input, const std::vector<SecondaryModel>& secondary,
                        Json& json) {
  if (secondary.size() != 1) return;
  json["secondary_structure"] = secondary_json(secondary.front());
  json["bonds"] = bonds_json(find_bonds(input.molecule(), models_of(input).front(), run_context()));
}

}  // namespace alphascope::cli
