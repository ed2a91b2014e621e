// Makes the CSV row, the header and derived facts of a cavity.
#include "core/document/cavities/cavity_records.hpp"

#include <algorithm>
#include <numeric>

#include "core/geometry/shortest_number.hpp"

namespace alphascope {
namespace {

std::string addresses(const std::vector<LiningResidue>& residues) {
  std::string text;
  for (const LiningResidue& residue : residues)
    text += (text.empty() ? "" : "; ") + residue.address;
  return text;
}

void add_measures(CsvRow& cells, const CavityFacts& facts, std::size_t row) {
  const CavityMeasures& m = facts.table().measure(row);
  const bool exact = facts.exact != nullptr;
  const MouthMeasures mouths = m.all_mouths();
  const CavityFacts::Life life = facts.life(row);
  const Cavity& cavity = facts.table().cavity(row);
  const NetworkEnd* end = facts.network_end(row);
  const CsvRow more{
      {"volume_sa_angstrom3", all_digits(m.volume_sa_angstrom3)},
      {"area_sa_angstrom2", all_digits(m.area_sa_angstrom2)},
      {"volume_sa_clipped_angstrom3",
       exact ? all_digits(facts.clipped(row).volume_sa_angstrom3) : ""},
      {"area_sa_clipped_angstrom2", exact ? all_digits(facts.clipped(row).area_sa_angstrom2) : ""},
      {"rank_by_clipped_volume", exact ? std::to_string(facts.clipped_rank[row]) : ""},
      {"doubtful", !exact                   ? ""
                   : facts.is_doubtful(row) ? "1"
                                            : "0"},
      {"volume_ms_angstrom3", all_digits(m.volume_ms_angstrom3)},
      {"area_ms_angstrom2", all_digits(m.area_ms_angstrom2)},
      {"area_ms_steiner_angstrom2", all_digits(m.area_ms_steiner_angstrom2)},
      {"volume_of_tetrahedra_angstrom3", all_digits(m.volume_of_tetrahedra_angstrom3)},
      {"mouths", std::to_string(m.mouths.size())},
      {"network", cavity.is_network() ? "1" : "0"},
      {"falls_apart_alpha_angstrom2", end ? alpha_text(*end) : ""},
      {"falls_apart_solvent_radius_angstrom", end ? radius_text(*end) : ""},
      {"part_of", cavity.is_part() ? std::to_string(cavity.network + 1) : ""},
      {"passages", std::to_string(cavity.passages.size())},
      {"mouth_triangles", std::to_string(cavity.mouth_triangles())},
      {"mouth_area_angstrom2", all_digits(mouths.area_angstrom2)},
      {"mouth_length_angstrom", all_digits(mouths.length_angstrom)},
      {"depth_angstrom", all_digits(facts.depths->of_angstrom[row])},
      {"born_alpha_angstrom2", finite_digits(life.born)},
      {"closed_alpha_angstrom2", life.closes ? finite_digits(life.closed) : ""},
      {"gone_alpha_angstrom2", finite_digits(life.gone)},
      {"arc_length_angstrom", all_digits(m.arc_length_angstrom)},
      {"corners", std::to_string(m.corners)}};
  cells.insert(cells.end(), more.begin(), more.end());
}

}  // namespace

bool CavityFacts::is_doubtful(std::size_t row) const {
  return alphascope::is_doubtful(table().measure(row).volume_sa_angstrom3,
                                 clipped(row).volume_sa_angstrom3);
}

std::string CavityFacts::contents_text(std::size_t row) const {
  return alphascope::contents_text(*source.molecule, *contents, table().order[row]);
}

CavityFacts::Life CavityFacts::life(std::size_t row) const {
  const CavityLife& life = lives->of(table().cavity(row).deepest_sink);
  const Lattice& lattice = table().ground->balls->lattice;
  return {lattice.square_angstrom(life.born), lattice.square_angstrom(life.closed),
          lattice.square_angstrom(life.gone), life.closed < life.gone};
}

std::vector<std::size_t> ranks_by_clipped(const CavityTable& table, const ExactVolumes& exact) {
  const auto volume = [&](std::size_t row) {
    return exact.of[table.order[row]].volume_sa_angstrom3;
  };
  std::vector<std::size_t> order(table.size()), rank(order.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return volume(a) > volume(b); });
  for (std::size_t k = 0; k < order.size(); ++k) rank[order[k]] = k + 1;
  return rank;
}

std::string alpha_text(const NetworkEnd& end) {
  return end.alpha_angstrom2 ? shortest_number(*end.alpha_angstrom2) : std::string();
}
std::string radius_text(const NetworkEnd& end) {
  return end.radius_angstrom ? shortest_number(*end.radius_angstrom) : std::string();
}

std::string comparable_text(const std::vector<std::string>& differences_from_castp) {
  if (differences_from_castp.empty()) return "comparable with CASTp";
  std::string text = "not comparable with CASTp: ";
  for (std::size_t k = 0; k < differences_from_castp.size(); ++k) {
    text += (k ? "; " : "") + differences_from_castp[k];
  }
  return text;
}

CsvRow cavity_csv(const CavityFacts& facts, std::size_t row, std::size_t first_id) {
  const Cavity& cavity = facts.table().cavity(row);
  CsvRow cells{{"model", model_text(facts.source.options.model)},
               {"id", std::to_string(row + 1)},
               {"first_id", first_id ? std::to_string(first_id) : ""},
               {"kind", facts.kind(row)},
               {"name", facts.name(row)}};
  add_measures(cells, facts, row);
  const CsvRow more{
      {"tetrahedra", std::to_string(cavity.tetrahedra.size())},
      {"sinks", std::to_string(cavity.sinks)},
      {"atoms", std::to_string(cavity.atoms.size())},
      {"lining_atoms", std::to_string(facts.table().measure(row).lining.size())},
      {"residues", addresses(lining_residues(*facts.atoms, facts.table(), row))},
      {"holds", facts.contents_text(row)},
      {"alpha_angstrom2", shortest_number(facts.request.alpha_angstrom2)},
      {"solvent_radius_angstrom", shortest_number(facts.request.solvent_radius_angstrom)},
      {"choices", comparable_text(facts.differences)}};
  cells.insert(cells.end(), more.begin(), more.end());
  for (auto& [key, value] : facts.computed_source().provenance()) {
    if (key != "model") cells.emplace_back(key, std::move(value));
  }
  cells.emplace_back("program", facts.source.program.text());
  return cells;
}

std::vector<std::pair<std::string, std::string>> cavity_header(const CavityFacts& facts) {
  std::vector<std::pair<std::string, std::string>> header{{"program", facts.source.program.text()}};
  for (auto& line : facts.computed_source().provenance()) header.push_back(std::move(line));
  header.emplace_back("alpha_angstrom2", shortest_number(facts.request.alpha_angstrom2));
  header.emplace_back("solvent_radius_angstrom",
                      shortest_number(facts.request.solvent_radius_angstrom));
  header.emplace_back("choices", comparable_text(facts.differences));
  return header;
}

}  // namespace alphascope
