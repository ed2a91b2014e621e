// SPDX-License-Identifier: GPL-3.0-or-later
// Compares areas and volumes with the tables of an independent program, and times them. The tables
// are not in the repository: reference.tsv, traps.tsv, inputs/, traps/ and NAME_sSOLVENT.tsv.gz.
//
//   alphascope_measure_check tables FOLDER
//   alphascope_measure_check clipped FOLDER [NAME]
//   alphascope_measure_check time FILE.xyzr[.gz] SOLVENT [THREADS [REPEATS]]
#include <zlib.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/cavity/cavities.hpp"
#include "core/cavity/cavity_ground.hpp"
#include "core/engine/engine.hpp"
#include "core/measure/exact_outside.hpp"
#include "core/measure/union_measures.hpp"
#include "core/triangulation/make_triangulation.hpp"
#include "core/triangulation/membership.hpp"

namespace {

using namespace alphascope;

using Clock = std::chrono::steady_clock;
double since(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

// CPU time of all threads.
double milliseconds_of(std::clock_t ticks) {
  return 1e3 * static_cast<double>(ticks) / CLOCKS_PER_SEC;
}

std::vector<std::string> lines_of(const std::string& path) {
  gzFile file = gzopen(path.c_str(), "rb");
  if (file == nullptr) throw std::runtime_error(path + ": cannot be read");
  std::string text;
  char buffer[1 << 16];
  for (int n; (n = gzread(file, buffer, sizeof buffer)) > 0;) {
    text.append(buffer, static_cast<std::size_t>(n));
  }
  gzclose(file);
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// Reads lines of x y z r, on the lattice of all their digits.
std::shared_ptr<BallSet> read_xyzr(const std::string& path) {
  std::vector<std::array<std::string, 4>> rows;
  auto balls = std::make_shared<BallSet>();
  balls->lattice.digits = kMinLatticeDigits;
  for (const std::string& line : lines_of(path)) {
    std::istringstream in(line);
    std::array<std::string, 4> row;
    if (line[0] == '#' || !(in >> row[0] >> row[1] >> row[2] >> row[3])) continue;
    for (const std::string& word : row) {
      const std::size_t point = word.find('.');
      if (point == std::string::npos) continue;
      balls->lattice.digits =
          std::max(balls->lattice.digits, static_cast<int>(word.size() - point - 1));
    }
    rows.push_back(row);
  }
  for (const auto& row : rows) {
    std::int32_t v[4];
    for (int k = 0; k < 4; ++k) {
      v[k] = static_cast<std::int32_t>(
          balls->lattice.nearest_units(std::strtod(row[k].c_str(), nullptr)));
    }
    balls->centres.push_back({v[0], v[1], v[2]});
    balls->radii.push_back(v[3]);
  }
  return balls;
}

std::shared_ptr<const BallSet> grown(const std::string& path, double solvent) {
  return std::make_shared<BallSet>(with_solvent(*read_xyzr(path), solvent));
}

std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words;
  std::istringstream in(line);
  for (std::string word; std::getline(in, word, '\t');) words.push_back(word);
  return words;
}
std::size_t column(const std::vector<std::string>& header, const std::string& name) {
  return static_cast<std::size_t>(std::find(header.begin(), header.end(), name) - header.begin());
}

struct Worst {
  double area = 0, volume = 0;
  int rows = 0, bad = 0;
  void compare(const std::string& what, double a, double b, double v, double w, double printed) {
    const double da = std::fabs(a - b), dv = std::fabs(v - w);
    area = std::max(area, da);
    volume = std::max(volume, dv);
    const double most = 1e-9 + printed + 1e-12 * std::fabs(w);
    ++rows;
    if (da <= most && dv <= most) return;
    ++bad;
    std::printf("DIFFERS %s: area %.12f for %.12f, volume %.12f for %.12f\n", what.c_str(), a, b, v,
                w);
  }
  int report(const char* table) const {
    std::printf("%s: %d rows, %d differ; largest differences %.2e A2, %.2e A3\n", table, rows, bad,
                area, volume);
    return bad;
  }
};

UnionMeasures measured(const std::shared_ptr<const BallSet>& balls) {
  return measure_union(*balls, make_cpu_engine(balls)->compute({}, {}));
}

int compare_table(const std::string& folder, const std::string& table, const std::string& inputs,
                  double printed) {
  const auto lines = lines_of(folder + "/" + table);
  const auto header = words_of(lines[0]);
  const std::size_t solvent = column(header, "solvent"), area = column(header, "area"),
                    volume = column(header, "volume");
  Worst worst;
  for (std::size_t l = 1; l < lines.size(); ++l) {
    const auto words = words_of(lines[l]);
    const std::string s = solvent < words.size() ? words[solvent] : "0";
    const auto ours = measured(
        grown(folder + "/" + inputs + "/" + words[0] + (inputs == "inputs" ? ".xyzr.gz" : ".xyzr"),
              std::stod(s)));
    worst.compare(words[0] + " at " + s, ours.area_angstrom2(), std::stod(words[area]),
                  ours.volume_angstrom3(), std::stod(words[volume]), printed);
  }
  return worst.report(table.c_str());
}

int compare_balls(const std::string& folder, const std::string& name, const std::string& solvent) {
  const auto ours = measured(grown(folder + "/inputs/" + name + ".xyzr.gz", std::stod(solvent)));
  const std::string table = name + "_s" + solvent + ".tsv.gz";
  Worst worst;
  for (const std::string& line : lines_of(folder + "/" + table)) {
    const auto words = words_of(line);
    if (line[0] == '#' || words.size() < 3) continue;
    const std::size_t i = std::stoul(words[0]);
    worst.compare("ball " + words[0], ours.ball_area_angstrom2()[i], std::stod(words[1]),
                  ours.ball_volume_angstrom3()[i], std::stod(words[2]), 0);
  }
  return worst.report(table.c_str());
}

int tables(const std::string& folder) {
  int bad = compare_table(folder, "traps.tsv", "traps", 0);
  bad += compare_balls(folder, "1crn", "1.4");
  bad += compare_balls(folder, "1ubq", "1.4");
  bad += compare_balls(folder, "vol100", "0");
  bad += compare_table(folder, "reference.tsv", "inputs", 5e-9);
  return bad == 0 ? 0 : 1;
}

// The tetrahedra of all cavities at alpha 0, with the cavity of each.
struct InCavities {
  std::shared_ptr<const Triangulation> triangulation;
  std::size_t count = 0;
  std::vector<std::uint32_t> tetrahedra, cavity;
};
InCavities in_cavities(const std::shared_ptr<const BallSet>& balls) {
  InCavities in;
  in.triangulation = std::make_shared<const Triangulation>(make_triangulation(*balls, 0));
  if (in.triangulation->dimension < 3) return in;
  const CavityGround ground = make_cavity_ground(balls, in.triangulation);
  const Membership members =
      membership(*balls, *in.triangulation, ground.incidence, ground.flow, 0.0);
  const Cavities cavities = find_cavities(ground, members);
  in.count = cavities.cavities.size();
  for (std::uint32_t c = 0; c < cavities.cavities.size(); ++c) {
    for (const std::uint32_t t : cavities.cavities[c].tetrahedra) {
      in.tetrahedra.push_back(t);
      in.cavity.push_back(c);
    }
  }
  return in;
}

// Rows of cavities.tsv are found by the volume of their tetrahedra.
int compare_clipped(const std::string& folder, const std::string& only) {
  std::vector<std::string> names;
  std::map<std::string, std::vector<std::vector<std::string>>> rows;
  const auto lines = lines_of(folder + "/cavities.tsv");
  const auto header = words_of(lines[0]);
  const std::size_t whole = column(header, "vol_tets"), volume = column(header, "vol_clipped"),
                    area = column(header, "area_clipped");
  for (std::size_t l = 1; l < lines.size(); ++l) {
    const auto words = words_of(lines[l]);
    if (words[1] != "1.4" || (!only.empty() && words[0] != only)) continue;
    if (!rows.contains(words[0])) names.push_back(words[0]);
    rows[words[0]].push_back(words);
  }
  int bad = 0;
  for (const std::string& name : names) {
    const auto balls = grown(folder + "/inputs/" + name + ".xyzr.gz", 1.4);
    const InCavities in = in_cavities(balls);
    const auto begin = Clock::now();
    const std::clock_t ticks = std::clock();
    const ExactTetrahedra clipped = exact_outside(*in.triangulation, *balls, 0.0, in.tetrahedra);
    std::printf("%s: %zu cavities, %zu tetrahedra, %.1f ms (all threads: %.1f)\n", name.c_str(),
                in.count, in.tetrahedra.size(), since(begin),
                milliseconds_of(std::clock() - ticks));
    const auto sums = [&](const std::vector<double>& values) {
      return sums_by_group(values, in.cavity, in.count);
    };
    const auto volumes = sums(clipped.volume_angstrom3), areas = sums(clipped.area_angstrom2),
               free_volumes = sums(clipped.free_volume_angstrom3);
    if (in.count != rows[name].size()) {
      std::printf("DIFFERS %s: %zu cavities for %zu\n", name.c_str(), in.count, rows[name].size());
      ++bad;
    }
    Worst worst;
    for (const auto& row : rows[name]) {
      const double tets = std::stod(row[whole]);
      std::size_t best = 0;  // among equal ones that of the nearest clipped volume
      double least = HUGE_VAL;
      for (std::size_t c = 0; c < in.count; ++c) {
        const double off = std::fabs(volumes[c] - tets) +
                           1e-3 * std::fabs(free_volumes[c] - std::stod(row[volume]));
        if (off < least) least = off, best = c;
      }
      worst.compare(name + " " + row[2], areas[best], std::stod(row[area]), free_volumes[best],
                    std::stod(row[volume]), 1e-12 * tets);
    }
    bad += worst.report(name.c_str());
  }
  return bad == 0 ? 0 : 1;
}

int time_file(const std::string& path, double solvent, int threads, int repeats) {
  const auto balls = grown(path, solvent);
  const auto begin = Clock::now();
  const std::clock_t first = std::clock();
  const AlphaComplex complex = make_cpu_engine(balls, {threads})->compute({}, {});
  std::printf("%zu balls, %zu tetrahedra; complex %.1f ms (all threads: %.1f)\n", balls->size(),
              complex.tetrahedra.size(), since(begin), milliseconds_of(std::clock() - first));
  for (const bool with_derivatives : {false, true}) {
    UnionDerivatives derivatives;
    std::vector<double> times, processor;
    UnionMeasures of;
    for (int r = 0; r < repeats; ++r) {
      const auto start = Clock::now();
      const std::clock_t ticks = std::clock();
      of = measure_union(*balls, complex, {threads, with_derivatives ? &derivatives : nullptr});
      times.push_back(since(start));
      processor.push_back(milliseconds_of(std::clock() - ticks));
    }
    std::sort(times.begin(), times.end());
    std::sort(processor.begin(), processor.end());
    std::printf(
        "%s: least %.2f, median %.2f ms (all threads: %.2f, %.2f); area %.9f A2, volume %.9f A3\n",
        with_derivatives ? "with derivatives" : "measures", times.front(), times[times.size() / 2],
        processor.front(), processor[times.size() / 2], of.area_angstrom2(), of.volume_angstrom3());
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  try {
    if (words.size() == 2 && words[0] == "tables") return tables(words[1]);
    if (words.size() >= 2 && words[0] == "clipped") {
      return compare_clipped(words[1], words.size() > 2 ? words[2] : "");
    }
    if (words.size() >= 3 && words[0] == "time") {
      return time_file(words[1], std::stod(words[2]), words.size() > 3 ? std::stoi(words[3]) : 0,
                       words.size() > 4 ? std::stoi(words[4]) : 20);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  std::fprintf(stderr, "usage: see the first lines of measure_check.cpp\n");
  return 2;
}
