// SPDX-License-Identifier: GPL-3.0-or-later
// Converts CavityFacts into JSON.
#include "core/document/cavities/cavity_json.hpp"

#include "core/cavity/cavities.hpp"
#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_measures.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/document/cavities/cavity_columns.hpp"
#include "core/document/cavities/cavity_contents.hpp"
#include "core/document/cavities/cavity_names.hpp"
#include "core/document/tables/column_json.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/selection/atom_address.hpp"

namespace alphascope {
namespace {

Json mouths_json(const Cavity& cavity, const CavityMeasures& m) {
  Json mouths = Json::array();
  for (std::size_t k = 0; k < m.mouths.size(); ++k) {
    mouths.push_back({{"triangles", cavity.mouths[k].triangles.size()},
                      {"area_angstrom2", m.mouths[k].area_angstrom2},
                      {"length_angstrom", m.mouths[k].length_angstrom}});
  }
  return mouths;
}

const char* held_kind(DropReason reason) {
  return reason == DropReason::ligand ? "ligand" : reason == DropReason::ion ? "ion" : "water";
}

Json holds_json(const CavityFacts& facts, std::size_t row) {
  Json list = Json::array();
  if (facts.contents->of.empty()) return list;
  for (const std::uint32_t k : facts.contents->of[facts.table().order[row]]) {
    const ContainedResidue& held = facts.contents->residues[k];
    list.push_back({{"residue", residue_address(*facts.source.molecule, held.atom)},
                    {"kind", held_kind(held.kind)},
                    {"atoms", held.atoms},
                    {"atoms_inside", held.inside}});
  }
  return list;
}

Json residues_json(const CavityFacts& facts, std::size_t row) {
  Json residues = Json::array();
  for (const LiningResidue& residue : lining_residues(*facts.atoms, facts.table(), row)) {
    residues.push_back({{"residue", residue.address}, {"atoms", residue.balls}});
  }
  return residues;
}

// Null if the end is unknown, or if the cavity is not a network.
Json falls_apart_json(const NetworkEnd* end) {
  if (!end) return {};
  Json json{{"alpha_angstrom2", nullptr},
            {"cavities_at_alpha", nullptr},
            {"solvent_radius_angstrom", nullptr},
            {"solvent_radius_step_angstrom", kNetworkStepAngstrom},
            {"cavities", nullptr},
            {"largest_volume_sa_angstrom3", nullptr}};
  if (end->alpha_angstrom2) {
    json["alpha_angstrom2"] = *end->alpha_angstrom2;
    json["cavities_at_alpha"] = end->parts;
  }
  if (end->radius_angstrom) {
    json["solvent_radius_angstrom"] = *end->radius_angstrom;
    json["cavities"] = end->cavities;
    json["largest_volume_sa_angstrom3"] = end->largest_volume_sa_angstrom3;
  }
  return json;
}

// The networks that are listed as their parts.
Json split_networks_json(const CavityTable& table) {
  Json networks = Json::array();
  for (std::size_t n = 0; n < table.found.networks.size(); ++n) {
    const SplitNetwork& network = table.found.networks[n];
    networks.push_back({{"number", n + 1},
                        {"mouths", network.mouths},
                        {"tetrahedra", network.tetrahedra},
                        {"parts", network.parts},
                        {"falls_apart_alpha_angstrom2", network.falls_apart_angstrom2}});
  }
  return networks;
}

// Flat keys come from the columns; lists are written here. Their order is that of earlier versions.
Json cavity_json(const CavityFacts& facts, std::size_t row) {
  const Cavity& cavity = facts.table().cavity(row);
  const CavityMeasures& m = facts.table().measure(row);
  const CavityRow of{facts, row, &facts};
  Json json = Json::object();
  add_keys(json, cavity_columns(), of, {"id", "name", "kind", "mouths", "network"});
  json["falls_apart"] = falls_apart_json(facts.network_end(row));
  add_keys(json, cavity_columns(), of, {"part_of", "passages", "tetrahedra"});
  add_keys_up_to(json, cavity_columns(), of, "mouth_length_angstrom");
  json["mouth_list"] = mouths_json(cavity, m);
  add_keys_up_to(json, cavity_columns(), of);
  json["sink_atoms"] = facts.table().sink(row);
  json["atoms"] = cavity.atoms;
  json["lining_atoms"] = m.lining;
  json["residues"] = residues_json(facts, row);
  json["holds"] = holds_json(facts, row);
  return json;
}

}  // namespace

Json cavities_json(const CavityFacts& facts) {
  const CavityTable& table = facts.table();
  Json cavities = Json::array();
  for (const std::size_t row : facts.rows) cavities.push_back(cavity_json(facts, row));
  Json request = request_json(facts.request, table.ground->balls->lattice);
  for (const char* unused : {"tetrahedra_only", "engine"}) request.erase(unused);
  request["split_networks"] = table.question.split_networks;
  return {{"comparable_with_castp", facts.differences.empty()},
          {"differences_from_castp", facts.differences},
          {"counts",
           {{"voids", table.voids},
            {"pockets", table.pockets},
            {"mouths", table.mouths},
            {"components", table.found.components},
            {"tunnels", table.found.tunnels}}},
          {"cavities", cavities},
          {"split_networks", split_networks_json(table)},
          {"request", request},
          {"input", input_json(facts.computed_source())}};
}

}  // namespace alphascope
