// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the reference tables and compares our cavities with them.
#include "tests/support/reference/cavity_reference.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <sstream>

#include "core/cavity/cavity_ground.hpp"
#include "core/complex/triangulation.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/text_files/text_file.hpp"
#include "core/triangulation/filtration.hpp"

namespace alphascope::testing {
namespace {

std::vector<TableRow> read_table(const std::filesystem::path& path) {
  const LoadedText loaded = load_text(path, 1 << 26, {});
  std::istringstream lines{std::string(loaded.text)};
  const auto split = [](const std::string& line) {
    std::vector<std::string> fields;
    std::istringstream stream(line);
    for (std::string field; std::getline(stream, field, '\t');) fields.push_back(field);
    return fields;
  };
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> names = split(line);
  std::vector<TableRow> rows;
  while (std::getline(lines, line)) {
    std::vector<std::string> fields = split(line);
    fields.resize(names.size());
    TableRow row;
    for (std::size_t n = 0; n < names.size(); ++n) row[names[n]] = fields[n];
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<BallIndex> numbers(const std::string& text) {
  std::istringstream stream(text);
  std::vector<BallIndex> found;
  for (BallIndex n = 0; stream >> n;) found.push_back(n);
  return found;
}

std::string key_of(const TableRow& row) {
  return row.at("input") + " " + row.at("solvent");
}

// Counts and collects differences between found and expected values.
class Differences {
 public:
  explicit Differences(std::string of) : of_(std::move(of)) {}
  void count(const TableRow& row, const std::string& column, std::size_t found) {
    const auto expected = row.find(column);
    if (expected == row.end() || expected->second.empty()) return;
    if (std::to_string(found) == expected->second) return;
    say(column + " is " + std::to_string(found) + ", expected " + expected->second);
  }
  // |found - expected| <= 1e-9 + `relative` times `scale`.
  void number(const TableRow& row, const std::string& column, double found, double relative,
              double scale) {
    const double expected = std::stod(row.at(column));
    const double off = std::fabs(found - expected), most = 1e-9 + relative * std::fabs(scale);
    if (off <= most) return;
    char text[160];
    std::snprintf(text, sizeof text,
                  "%s of %s %s (%s tetrahedra) is %.15g, off by %.3g, at most %.3g", column.c_str(),
                  row.at("kind").c_str(), row.at("id").c_str(), row.at("tets").c_str(), found, off,
                  most);
    say(text);
  }
  void say(const std::string& what) { list_.push_back(of_ + ": " + what); }
  std::vector<std::string>& list() { return list_; }

 private:
  std::string of_;
  std::vector<std::string> list_;
};

void compare_measures(const TableRow& row, const CavityMeasures& found,
                      const ExactCavityMeasures& clipped, Differences& differences) {
  const double tetrahedra = found.volume_of_tetrahedra_angstrom3;
  const auto to_the_last_digit = [&](const char* column, double number) {
    differences.number(row, column, number, 1e-12, tetrahedra);
  };
  to_the_last_digit("vol_tets", found.volume_of_tetrahedra_angstrom3);
  to_the_last_digit("vol_sa", found.volume_sa_angstrom3);
  to_the_last_digit("area_sa", found.area_sa_angstrom2);
  to_the_last_digit("vol_clipped", clipped.volume_sa_angstrom3);
  to_the_last_digit("area_clipped", clipped.area_sa_angstrom2);
  const auto to_nine_digits = [&](const char* column, double number) {
    differences.number(row, column, number, 1e-12, tetrahedra + 6e3 * std::fabs(number));
  };
  to_nine_digits("vol_ms", found.volume_ms_angstrom3);
  to_nine_digits("area_ms", found.area_ms_steiner_angstrom2);
  to_nine_digits("arc_len", found.arc_length_angstrom);
  to_nine_digits("mouth_area", found.all_mouths().area_angstrom2);
  to_nine_digits("mouth_len", found.all_mouths().length_angstrom);
  differences.count(row, "corners", found.corners);
}

}  // namespace

CavityReference::CavityReference(std::filesystem::path folder) : folder_(std::move(folder)) {
  runs_ = read_table(folder_ / "reference.tsv");
  for (TableRow& row : runs_) row["path"] = "inputs/" + row.at("input") + ".xyzr.gz";
  for (TableRow& row : read_table(folder_ / "traps.tsv")) {
    row["path"] = "traps/" + row.at("input") + ".xyzr";
    runs_.push_back(std::move(row));
  }
  for (TableRow& row : read_table(folder_ / "cavities.tsv")) {
    cavities_[key_of(row)].push_back({std::move(row), {}, {}});
  }
  for (const TableRow& row : read_table(folder_ / "lining.tsv.gz")) {
    for (KnownCavity& known : cavities_.at(key_of(row))) {
      if (known.row.at("id") != row.at("id")) continue;
      known.atoms = numbers(row.at("atoms_of_its_tetrahedra (0-based)"));
      known.lining = numbers(row.at("lining (exposed inside)"));
    }
  }
}

std::shared_ptr<const BallSet> CavityReference::balls(const TableRow& run) const {
  // Reads balls directly, because a molecule has no atom of radius 0 but some inputs have one.
  const LoadedText loaded = load_text(folder_ / run.at("path"), 1 << 26, {});
  std::istringstream lines{std::string(loaded.text)};
  BallSet balls;
  balls.lattice.digits = run.at("path").starts_with("traps") ? 6 : 4;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    double v[4];
    if (!(words >> v[0] >> v[1] >> v[2] >> v[3])) continue;
    const auto at = [&](int n) {
      return static_cast<std::int32_t>(balls.lattice.nearest_units(v[n]));
    };
    balls.centres.push_back({at(0), at(1), at(2)});
    balls.radii.push_back(at(3));
  }
  return std::make_shared<BallSet>(with_solvent(balls, std::stod(run.at("solvent"))));
}

std::vector<std::string> CavityReference::differences(
    const TableRow& run, const CavityGround& ground, const Cavities& found,
    const std::vector<CavityMeasures>& measures) const {
  Differences differences(key_of(run));
  const Triangulation& triangulation = *ground.triangulation;
  differences.count(run, "dimension", static_cast<std::size_t>(triangulation.dimension));
  if (triangulation.dimension < 3) {
    differences.count(run, "voids", found.cavities.size());
    differences.count(run, "pockets", found.cavities.size());
    return differences.list();
  }
  std::size_t mouths = 0, pockets = 0;
  for (const Cavity& cavity : found.cavities) {
    mouths += cavity.mouths.size();
    pockets += !cavity.is_void();
  }
  differences.count(run, "T_tets", triangulation.tetrahedra.size());
  differences.count(run, "ties_flow", ground.flow.ties);
  differences.count(run, "K_v", found.simplices[0]);
  differences.count(run, "K_e", found.simplices[1]);
  differences.count(run, "K_f", found.simplices[2]);
  differences.count(run, "K_t", found.simplices[3]);
  differences.count(run, "b0", static_cast<std::size_t>(found.components));
  differences.count(run, "b1", static_cast<std::size_t>(found.tunnels));
  differences.count(run, "b2", static_cast<std::size_t>(found.voids));
  differences.count(run, "voids", found.cavities.size() - pockets);
  differences.count(run, "pockets", pockets);
  differences.count(run, "mouths", mouths);

  const auto known_here = cavities_.find(key_of(run));
  if (known_here == cavities_.end()) return differences.list();
  std::vector<std::uint32_t> all(found.cavities.size());
  std::iota(all.begin(), all.end(), 0u);
  const std::vector<ExactCavityMeasures> clipped = measure_cavities_exactly(ground, found, all, 0);
  std::vector<const KnownCavity*> left;
  for (const KnownCavity& known : known_here->second) left.push_back(&known);
  for (std::size_t c = 0; c < found.cavities.size(); ++c) {
    const Cavity& cavity = found.cavities[c];
    // Cavities of the same atoms are told apart by their tetrahedra.
    const auto same = std::find_if(left.begin(), left.end(), [&](const KnownCavity* known) {
      return known->atoms == cavity.atoms &&
             known->row.at("tets") == std::to_string(cavity.tetrahedra.size());
    });
    if (same == left.end()) {
      differences.say("no such cavity of " + std::to_string(cavity.tetrahedra.size()) +
                      " tetrahedra, the first " + std::to_string(cavity.tetrahedra[0]) +
                      ", at atom " + std::to_string(cavity.atoms[0]));
      continue;
    }
    const TableRow& row = (*same)->row;
    if ((row.at("kind") == "void") != cavity.is_void()) differences.say("kind of " + row.at("id"));
    differences.count(row, "sinks", cavity.sinks);
    differences.count(row, "mouths", cavity.mouths.size());
    differences.count(row, "mouth_triangles", cavity.mouth_triangles());
    differences.count(row, "n_atoms", cavity.atoms.size());
    compare_measures(row, measures.at(c), clipped[c], differences);
    if (measures[c].lining != (*same)->lining) {
      differences.say("lining of " + row.at("id") + ": " +
                      std::to_string(measures[c].lining.size()) + " atoms, expected " +
                      std::to_string((*same)->lining.size()));
    }
    left.erase(same);
  }
  if (!left.empty()) differences.say(std::to_string(left.size()) + " cavities are missing");
  return differences.list();
}

}  // namespace alphascope::testing
