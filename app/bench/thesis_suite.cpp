// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the suite and fills its rows. The thesis compares with gReg3d or sequential CGAL. This suite
// always compares with CGAL, which runs in turns with each engine. Alphas ascend, since the work of
// every engine grows with alpha. An engine that is too slow at one alpha is left out at larger
// ones.
#include "app/bench/thesis_suite.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "app/bench/thesis_contest.hpp"
#include "app/session/version.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/shortest_number.hpp"
#include "core/molecule/name_table.hpp"
#include "core/radii/amber_radii.hpp"
#include "core/radii/radii_set.hpp"

namespace alphascope {
namespace {

struct Ablation {
  const char* name;
  bool of_gpu;  // has no effect on the CPU
  void (*apply)(TupleOptions&);
};

constexpr Ablation kAblations[] = {
    {"without edge optimisation", false, [](TupleOptions& t) { t.edge_optimisation = false; }},
    {"without alpha optimisation", false, [](TupleOptions& t) { t.alpha_optimisation = false; }},
    {"100 x 100 x 100 grid", false, [](TupleOptions& t) { t.grid = TupleGridKind::thesis; }},
    {"without pinned memory", true, [](TupleOptions& t) { t.pinned = false; }},
    {"without streams", true, [](TupleOptions& t) { t.streams = 1; }},
    {"without textures", true, [](TupleOptions& t) { t.texture = false; }},
    {"without pinned memory, streams and textures", true,
     [](TupleOptions& t) {
       t.pinned = t.texture = false;
       t.streams = 1;
     }},
};

void add(std::optional<double>& column, double milliseconds) {
  column = column.value_or(0) + milliseconds;
}

// The column of the thesis' Table 4.1 to which each stage belongs.
ThesisStages to_columns(const std::vector<StageTime>& stages) {
  ThesisStages columns;
  for (const StageTime& s : stages) {
    if (s.label == stage::kHostToDevice || s.label == stage::kDeviceToHost) {
      add(columns.memcpy, s.milliseconds);
    } else if (s.label == stage::kCandidates || s.label == stage::kCandidatesAndFiltered) {
      add(columns.kernel1, s.milliseconds);
      columns.kernel1_has_kernel2 |= s.label == stage::kCandidatesAndFiltered;
    } else if (s.label == stage::kPrefixSum) {
      add(columns.prefix_sum, s.milliseconds);
    } else if (s.label == stage::kFilteredValidity) {
      add(columns.kernel2, s.milliseconds);
    } else if (s.label == stage::kExactValidity) {
      add(columns.kernel3, s.milliseconds);
    } else {
      add(columns.other, s.milliseconds);
    }
  }
  return columns;
}

// One engine of the suite, with or without one of its optimisations.
struct Entrant {
  ThesisRow::Kind kind;
  EngineChoice choice;
  int threads;
  std::string variant;
  TupleOptions tuples;
  std::string skipped;  // why larger alphas are not measured; empty: they are
};

class Suite {
 public:
  Suite(ThesisReport& report, const EngineFactory& factory, const RunContext& context,
        const RowListener& listener)
      : report_(report),
        options_(report.options),
        factory_(factory),
        context_(context),
        listener_(listener) {}

  void run() {
    for (std::size_t m = 0; m < report_.molecules.size(); ++m) {
      const std::optional<std::size_t> full = full_triangulation(m);
      std::vector<Entrant> field = entrants();
      for (const Alpha& alpha : options_.alphas) {
        compete(m, alpha, full, field);
        std::erase_if(field, [](const Entrant& e) { return e.kind == ThesisRow::Kind::ablation; });
      }
      for (const EngineChoice choice : options_.engines) find_break_even(m, choice);
      ++done_molecules_;
    }
  }

 private:
  ContestRules rules(std::size_t molecule, const Alpha& alpha) const {
    return {report_.molecules[molecule].balls,
            {alpha, options_.tetrahedra_only},
            options_.repeats,
            options_.seconds_per_row};
  }

  void tell(std::size_t molecule, const std::string& what, double share_of_molecule) const {
    const double molecules = static_cast<double>(report_.molecules.size());
    context_.report(report_.molecules[molecule].name + ", " + what,
                    (static_cast<double>(done_molecules_) + share_of_molecule) / molecules);
  }

  std::optional<std::size_t> full_triangulation(std::size_t molecule) const {
    tell(molecule, "whole triangulation", 0);
    std::vector<Contestant> cgal(1);
    cgal[0].choice = EngineChoice::cgal;
    cgal[0].settings.threads = options_.threads;
    ContestRules once = rules(molecule, std::numeric_limits<double>::infinity());
    once.request.tetrahedra_only = true;
    once.repeats = 0;
    run_contest(cgal, once, factory_, context_.cancel);
    if (!cgal[0].measured()) return std::nullopt;
    return cgal[0].tetrahedra;
  }

  std::vector<Entrant> entrants() const {
    using Kind = ThesisRow::Kind;
    std::vector<Entrant> field{{Kind::cgal, EngineChoice::cgal, 1, "one thread", {}, {}}};
    const int threads = options_.threads > 0 ? options_.threads : report_.machine.threads;
    // CGAL's parallel code needs three threads (core/engine/engine.hpp).
    if (threads >= 3) {
      field.push_back({Kind::cgal, EngineChoice::cgal, threads, "parallel", {}, {}});
    }
    for (const EngineChoice choice : options_.engines) {
      field.push_back({Kind::engine, choice, options_.threads, {}, {}, {}});
    }
    for (const EngineChoice choice : options_.engines) {
      if (!options_.ablation || !is_tuple_engine(choice)) continue;
      for (const Ablation& ablation : kAblations) {
        if (ablation.of_gpu && choice != EngineChoice::tuples_gpu) continue;
        TupleOptions tuples;
        ablation.apply(tuples);
        field.push_back({Kind::ablation, choice, options_.threads, ablation.name, tuples, {}});
      }
    }
    return field;
  }

  void compete(std::size_t molecule, const Alpha& alpha, std::optional<std::size_t> full,
               std::vector<Entrant>& field) {
    const auto at = std::find(options_.alphas.begin(), options_.alphas.end(), alpha);
    tell(molecule, "α = " + shortest_number(alpha) + " Å²",
         0.8 * static_cast<double>(at - options_.alphas.begin()) /
             static_cast<double>(options_.alphas.size()));
    std::vector<Contestant> contestants;
    for (const Entrant& e : field) {
      Contestant c;
      c.choice = e.choice;
      c.settings = {e.threads, e.tuples};
      c.skipped = e.skipped;
      contestants.push_back(std::move(c));
    }
    run_contest(contestants, rules(molecule, alpha), factory_, context_.cancel);
    for (std::size_t n = 0; n < field.size(); ++n) {
      if (contestants[n].too_slow) {
        field[n].skipped =
            contestants[n].skipped + " at α = " + shortest_number(alpha) + " Å² already";
      }
      ThesisRow row = to_row(field[n], contestants[n], contestants);
      row.molecule = report_.molecules[molecule].name;
      row.molecule_index = molecule;
      row.balls = report_.molecules[molecule].balls->size();
      row.alpha_angstrom2 = alpha;
      row.full_tetrahedra = full;
      if (listener_) listener_(row);
      report_.rows.push_back(std::move(row));
    }
  }

  static ThesisRow to_row(const Entrant& entrant, const Contestant& c,
                          const std::vector<Contestant>& all) {
    ThesisRow row;
    row.kind = entrant.kind;
    row.choice = entrant.choice;
    row.threads = entrant.threads;
    row.variant = entrant.variant;
    row.skipped = c.skipped;
    row.too_slow = c.too_slow || !entrant.skipped.empty();
    if (!c.measured()) return row;
    row.engine = c.engine;
    row.stage_medians = c.stage_medians();
    row.stages = to_columns(row.stage_medians);
    row.runs = static_cast<int>(c.cold.size());
    row.cold_milliseconds = median(c.cold);
    row.warm_milliseconds = median(c.warm);
    row.tetrahedra = c.tetrahedra;
    row.hash = c.hash;
    const Contestant& cgal = all.front();
    if (cgal.measured()) {
      row.cgal_cold_milliseconds = median(cgal.cold);
      row.same_as_cgal = c.hashes_agree && c.hash == cgal.hash;
    }
    if (all.size() > 1 && all[1].choice == EngineChoice::cgal && all[1].measured()) {
      row.cgal_parallel_cold_milliseconds = median(all[1].cold);
    }
    return row;
  }

  // Whether the engine is faster than CGAL at this alpha. Empty if CGAL could not be measured.
  std::optional<bool> wins(std::size_t molecule, EngineChoice choice, const Alpha& alpha) const {
    std::vector<Contestant> two(2);
    two[0].choice = EngineChoice::cgal;
    two[0].settings.threads = 1;
    two[1].choice = choice;
    two[1].settings.threads = options_.threads;
    run_contest(two, rules(molecule, alpha), factory_, context_.cancel);
    if (!two[0].measured()) return std::nullopt;
    if (two[1].too_slow) return false;
    if (!two[1].measured()) return std::nullopt;
    return median(two[1].cold) < median(two[0].cold);
  }

  void find_break_even(std::size_t molecule, EngineChoice choice) {
    BreakEven found{molecule, choice, {}, false, {}};
    for (const ThesisRow& row : report_.rows) {
      if (row.molecule_index != molecule || row.choice != choice ||
          row.kind != ThesisRow::Kind::engine || found.lost_at_angstrom2) {
        continue;
      }
      // An engine that ran out of time has lost. After any other failure it is unknown who is
      // faster.
      if (!row.speed_up() && !row.too_slow) return;
      if (!row.too_slow && *row.speed_up() > 1) {
        found.alpha_angstrom2 = row.alpha_angstrom2;
      } else {
        found.lost_at_angstrom2 = row.alpha_angstrom2;
      }
    }
    found.beyond = !found.lost_at_angstrom2;
    if (found.alpha_angstrom2 && found.lost_at_angstrom2) bisect(molecule, choice, found);
    report_.break_even.push_back(found);
  }

  void bisect(std::size_t molecule, EngineChoice choice, BreakEven& found) const {
    for (int n = 0; n < options_.bisections; ++n) {
      double middle = (*found.alpha_angstrom2 + *found.lost_at_angstrom2) / 2;
      middle = std::round(middle * 1000) / 1000;
      tell(molecule, "where CGAL overtakes " + std::string(engine_id(choice)), 0.9);
      const std::optional<bool> won = wins(molecule, choice, middle);
      if (!won) return;
      (*won ? found.alpha_angstrom2 : found.lost_at_angstrom2) = middle;
    }
  }

  ThesisReport& report_;
  const ThesisOptions& options_;
  const EngineFactory& factory_;
  const RunContext& context_;
  const RowListener& listener_;
  std::size_t done_molecules_ = 0;
};

void check(const std::vector<ThesisMolecule>& molecules, const ThesisOptions& options) {
  const auto finite = [](const Alpha& alpha) { return std::isfinite(alpha.nearest()); };
  if (molecules.empty()) throw std::invalid_argument("Name at least one molecule for the suite.");
  if (options.alphas.empty() ||
      !std::all_of(options.alphas.begin(), options.alphas.end(), finite)) {
    throw std::invalid_argument("The suite needs alphas, each a finite number of Å².");
  }
  for (const EngineChoice choice : options.engines) {
    if (engine_entry(choice).suite_place == 0) {
      throw std::invalid_argument("Choose the suite's engines from " +
                                  engine_ids(EngineGroup::suite, ", ") + "; CGAL is always there.");
    }
  }
  if (options.repeats < 1 || !(options.seconds_per_row > 0)) {
    throw std::invalid_argument("The suite needs at least one run, and some time for each row.");
  }
}

}  // namespace

std::vector<EngineChoice> thesis_engines(const MachineInfo& machine) {
  std::vector<EngineChoice> engines = suite_engines();
  if (!machine.gpu.usable) std::erase_if(engines, &needs_gpu);
  return engines;
}

std::optional<double> ThesisRow::speed_up() const {
  if (!measured() || !cgal_cold_milliseconds || cold_milliseconds <= 0) return std::nullopt;
  return *cgal_cold_milliseconds / cold_milliseconds;
}

std::optional<double> ThesisRow::share_of_full() const {
  if (!measured() || full_tetrahedra.value_or(0) == 0) return std::nullopt;
  return static_cast<double>(tetrahedra) / static_cast<double>(*full_tetrahedra);
}

bool ThesisReport::all_same() const {
  return std::none_of(rows.begin(), rows.end(),
                      [](const ThesisRow& row) { return row.same_as_cgal == false; });
}

ThesisReport thesis_report(const std::vector<ThesisMolecule>& molecules,
                           const ThesisOptions& options) {
  ThesisReport report;
  report.options = options;
  std::vector<Alpha>& alphas = report.options.alphas;
  std::sort(alphas.begin(), alphas.end());
  alphas.erase(std::unique(alphas.begin(), alphas.end()), alphas.end());
  report.machine = machine_info();
  report.program =
      "Alphascope " + std::string(program_version()) + " (" + std::string(program_commit()) + ")";
  report.molecules = molecules;
  return report;
}

ThesisReport run_thesis_suite(const std::vector<ThesisMolecule>& molecules,
                              const ThesisOptions& options, const EngineFactory& factory,
                              const RunContext& context, const RowListener& listener) {
  check(molecules, options);
  ThesisReport report = thesis_report(molecules, options);
  Suite(report, factory, context, listener).run();
  return report;
}

}  // namespace alphascope
