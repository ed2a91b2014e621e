// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the CSV row, the header and derived facts of a cavity.
#include "core/document/cavities/cavity_records.hpp"

#include <algorithm>
#include <numeric>

#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/document/cavities/cavity_columns.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/tables/column.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/shortest_number.hpp"

namespace alphascope {

RecordSource CavityFacts::computed_source() const {
  return source.on(table().ground->balls->lattice);
}

std::vector<std::size_t> ranks_by_exact_volume(const CavityTable& table,
                                               const ExactVolumes& exact) {
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
  CsvRow cells = csv_row_of(cavity_columns(), {facts, row, &facts, first_id});
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
