// See the header.
#include "core/document/cavity_json.hpp"

#include "core/molecule/atom_address.hpp"

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
    const HeldResidue& held = facts.contents->residues[k];
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

// A number that is none is null in JSON.
Json cavity_json(const CavityFacts& facts, std::size_t row) {
  const Cavity& cavity = facts.table().cavity(row);
  const CavityMeasures& m = facts.table().measure(row);
  const CavityFacts::Life life = facts.life(row);
  const bool exact = facts.exact != nullptr;
  const MouthMeasures mouths = m.all_mouths();
  return {
      {"id", row + 1},
      {"name", facts.name(row)},
      {"kind", facts.kind(row)},
      {"mouths", cavity.mouths.size()},
      {"network", cavity.is_network()},
      {"tetrahedra", cavity.tetrahedra.size()},
      {"volume_sa_angstrom3", m.volume_sa_angstrom3},
      {"area_sa_angstrom2", m.area_sa_angstrom2},
      {"volume_sa_clipped_angstrom3",
       exact ? Json(facts.clipped(row).volume_sa_angstrom3) : Json()},
      {"area_sa_clipped_angstrom2", exact ? Json(facts.clipped(row).area_sa_angstrom2) : Json()},
      {"rank_by_clipped_volume", exact ? Json(facts.clipped_rank[row]) : Json()},
      {"doubtful", exact ? Json(facts.is_doubtful(row)) : Json()},
      {"volume_ms_angstrom3", m.volume_ms_angstrom3},
      {"area_ms_angstrom2", m.area_ms_angstrom2},
      {"area_ms_steiner_angstrom2", m.area_ms_steiner_angstrom2},
      {"volume_of_tetrahedra_angstrom3", m.volume_of_tetrahedra_angstrom3},
      {"mouth_triangles", cavity.mouth_triangles()},
      {"mouth_area_angstrom2", mouths.area_angstrom2},
      {"mouth_length_angstrom", mouths.length_angstrom},
      {"mouth_list", mouths_json(cavity, m)},
      {"depth_angstrom", facts.depths->of_angstrom[row]},
      {"born_alpha_angstrom2", life.born},
      {"closed_alpha_angstrom2", life.closes ? Json(life.closed) : Json()},
      {"gone_alpha_angstrom2", life.gone},
      {"arc_length_angstrom", m.arc_length_angstrom},
      {"corners", m.corners},
      {"sinks", cavity.sinks},
      {"sink_atoms", facts.table().sink(row)},
      {"atoms", cavity.atoms},
      {"lining_atoms", m.lining},
      {"residues", residues_json(facts, row)},
      {"holds", holds_json(facts, row)}};
}

}  // namespace

Json cavities_json(const CavityFacts& facts) {
  const CavityTable& table = facts.table();
  Json cavities = Json::array();
  for (const std::size_t row : facts.rows) cavities.push_back(cavity_json(facts, row));
  Json request = request_json(facts.request, table.ground->balls->lattice);
  for (const char* unused : {"tetrahedra_only", "engine"}) request.erase(unused);
  return {{"comparable_with_castp", facts.differences.empty()},
          {"differences_from_castp", facts.differences},
          {"counts",
           {{"voids", table.voids},
            {"pockets", table.pockets},
            {"mouths", table.mouths},
            {"components", table.found.components},
            {"tunnels", table.found.tunnels}}},
          {"cavities", cavities},
          {"request", request},
          {"input", input_json(facts.computed_source())}};
}

}  // namespace alphascope
