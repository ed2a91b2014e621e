#include "app/cli/cavity_records.hpp"

#include <cmath>

#include "app/cli/text.hpp"
#include "core/molecule/atom_address.hpp"

namespace alphascope::cli {
namespace {

std::string addresses(const std::vector<LiningResidue>& residues) {
  std::string text;
  for (const LiningResidue& residue : residues)
    text += (text.empty() ? "" : "; ") + residue.address;
  return text;
}

std::string finite_digits(double value) {
  return std::isfinite(value) ? all_digits(value) : "";
}

void add_measures(CsvRow& cells, const CavityAnswer& answer, std::size_t row) {
  const CavityMeasures& m = answer.table.measure(row);
  const ClippedMeasures& clipped = answer.clipped(row);
  const MouthMeasures mouths = m.all_mouths();
  const CavityAnswer::Life life = answer.life(row);
  const CsvRow more{
      {"volume_sa_angstrom3", all_digits(m.volume_sa_angstrom3)},
      {"area_sa_angstrom2", all_digits(m.area_sa_angstrom2)},
      {"volume_sa_clipped_angstrom3", all_digits(clipped.volume_sa_angstrom3)},
      {"area_sa_clipped_angstrom2", all_digits(clipped.area_sa_angstrom2)},
      {"rank_by_clipped_volume", std::to_string(answer.clipped_rank[row])},
      {"doubtful", answer.is_doubtful(row) ? "1" : "0"},
      {"volume_ms_angstrom3", all_digits(m.volume_ms_angstrom3)},
      {"area_ms_angstrom2", all_digits(m.area_ms_angstrom2)},
      {"area_ms_steiner_angstrom2", all_digits(m.area_ms_steiner_angstrom2)},
      {"volume_of_tetrahedra_angstrom3", all_digits(m.volume_of_tetrahedra_angstrom3)},
      {"mouths", std::to_string(m.mouths.size())},
      {"mouth_triangles", std::to_string(answer.table.cavity(row).mouth_triangles())},
      {"mouth_area_angstrom2", all_digits(mouths.area_angstrom2)},
      {"mouth_length_angstrom", all_digits(mouths.length_angstrom)},
      {"depth_angstrom", all_digits(answer.depth_angstrom[row])},
      {"born_alpha_angstrom2", finite_digits(life.born)},
      {"closed_alpha_angstrom2", life.closes ? finite_digits(life.closed) : ""},
      {"gone_alpha_angstrom2", finite_digits(life.gone)},
      {"arc_length_angstrom", all_digits(m.arc_length_angstrom)},
      {"corners", std::to_string(m.corners)}};
  cells.insert(cells.end(), more.begin(), more.end());
}

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

Json holds_json(const CavityAnswer& answer, std::size_t row) {
  Json list = Json::array();
  if (answer.contents.of.empty()) return list;
  for (const std::uint32_t k : answer.contents.of[answer.table.order[row]]) {
    const HeldResidue& held = answer.contents.residues[k];
    list.push_back({{"residue", residue_address(answer.input.molecule(), held.atom)},
                    {"kind", held_kind(held.kind)},
                    {"atoms", held.atoms},
                    {"atoms_inside", held.inside}});
  }
  return list;
}

Json residues_json(const CavityAnswer& answer, std::size_t row) {
  Json residues = Json::array();
  for (const LiningResidue& residue : lining_residues(answer.atoms, answer.table, row)) {
    residues.push_back({{"residue", residue.address}, {"atoms", residue.balls}});
  }
  return residues;
}

// A number that is none is null in JSON.
Json cavity_json(const CavityAnswer& answer, std::size_t row) {
  const Cavity& cavity = answer.table.cavity(row);
  const CavityMeasures& m = answer.table.measure(row);
  const CavityAnswer::Life life = answer.life(row);
  const MouthMeasures mouths = m.all_mouths();
  return {{"id", row + 1},
          {"name", cavity_name(answer.atoms, answer.table, row)},
          {"kind", answer.kind(row)},
          {"mouths", cavity.mouths.size()},
          {"tetrahedra", cavity.tetrahedra.size()},
          {"volume_sa_angstrom3", m.volume_sa_angstrom3},
          {"area_sa_angstrom2", m.area_sa_angstrom2},
          {"volume_sa_clipped_angstrom3", answer.clipped(row).volume_sa_angstrom3},
          {"area_sa_clipped_angstrom2", answer.clipped(row).area_sa_angstrom2},
          {"rank_by_clipped_volume", answer.clipped_rank[row]},
          {"doubtful", answer.is_doubtful(row)},
          {"volume_ms_angstrom3", m.volume_ms_angstrom3},
          {"area_ms_angstrom2", m.area_ms_angstrom2},
          {"area_ms_steiner_angstrom2", m.area_ms_steiner_angstrom2},
          {"volume_of_tetrahedra_angstrom3", m.volume_of_tetrahedra_angstrom3},
          {"mouth_triangles", cavity.mouth_triangles()},
          {"mouth_area_angstrom2", mouths.area_angstrom2},
          {"mouth_length_angstrom", mouths.length_angstrom},
          {"mouth_list", mouths_json(cavity, m)},
          {"depth_angstrom", answer.depth_angstrom[row]},
          {"born_alpha_angstrom2", life.born},
          {"closed_alpha_angstrom2", life.closes ? Json(life.closed) : Json()},
          {"gone_alpha_angstrom2", life.gone},
          {"arc_length_angstrom", m.arc_length_angstrom},
          {"corners", m.corners},
          {"sinks", cavity.sinks},
          {"sink_atoms", answer.table.sink(row)},
          {"atoms", cavity.atoms},
          {"lining_atoms", m.lining},
          {"residues", residues_json(answer, row)},
          {"holds", holds_json(answer, row)}};
}

}  // namespace

CsvRow csv_row(const CavityAnswer& answer, std::size_t row, std::size_t first_id) {
  const Cavity& cavity = answer.table.cavity(row);
  CsvRow cells{{"model", model_text(answer.input.balls.model)},
               {"id", std::to_string(row + 1)},
               {"first_id", first_id ? std::to_string(first_id) : ""},
               {"kind", answer.kind(row)},
               {"name", cavity_name(answer.atoms, answer.table, row)}};
  add_measures(cells, answer, row);
  const CsvRow more{
      {"tetrahedra", std::to_string(cavity.tetrahedra.size())},
      {"sinks", std::to_string(cavity.sinks)},
      {"atoms", std::to_string(cavity.atoms.size())},
      {"lining_atoms", std::to_string(answer.table.measure(row).lining.size())},
      {"residues", addresses(lining_residues(answer.atoms, answer.table, row))},
      {"holds", answer.contents_text(row)},
      {"alpha_angstrom2", number_text(answer.request.alpha_angstrom2)},
      {"solvent_radius_angstrom", number_text(answer.request.solvent_radius_angstrom)},
      {"choices", comparable_text(answer)}};
  cells.insert(cells.end(), more.begin(), more.end());
  for (auto& [key, value] : answer.input.provenance()) {
    if (key != "model") cells.emplace_back(key, std::move(value));
  }
  cells.emplace_back("program", program_text());
  return cells;
}

Json result_json(const CavityAnswer& answer, const CavitiesOptions& options) {
  const CavityTable& table = answer.table;
  Json cavities = Json::array(), stages = Json::array();
  for (const std::size_t row : answer.rows) cavities.push_back(cavity_json(answer, row));
  for (const StageTime& s : answer.times.stages) {
    stages.push_back({{"stage", s.label}, {"ms", s.milliseconds}, {"setup", s.setup}});
  }
  Json request = request_json(answer.request, table.ground->balls->lattice);
  for (const char* unused : {"tetrahedra_only", "engine"}) request.erase(unused);
  return {
      {"comparable_with_castp", answer.differences.empty()},
      {"differences_from_castp", answer.differences},
      {"counts",
       {{"voids", table.voids},
        {"pockets", table.pockets},
        {"mouths", table.mouths},
        {"components", table.found.components},
        {"tunnels", table.found.tunnels}}},
      {"cavities", cavities},
      {"notes", notes_of(answer, options)},
      {"timings_ms",
       {{"wall", answer.times.wall_milliseconds}, {"device", answer.device}, {"stages", stages}}},
      {"request", request},
      {"input", input_json(answer.input)}};
}

std::vector<std::pair<std::string, std::string>> cavity_header(const CavityAnswer& answer) {
  std::vector<std::pair<std::string, std::string>> header{{"program", program_text()}};
  for (auto& line : answer.input.provenance()) header.push_back(std::move(line));
  header.emplace_back("alpha_angstrom2", number_text(answer.request.alpha_angstrom2));
  header.emplace_back("solvent_radius_angstrom",
                      number_text(answer.request.solvent_radius_angstrom));
  header.emplace_back("choices", comparable_text(answer));
  for (const std::string& note : input_notes(answer.input)) header.emplace_back("note", note);
  return header;
}

}  // namespace alphascope::cli
