// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the quantities of the thesis' chapter 4 for given molecules. These are times of stages,
// speed-up over CGAL, and the largest alpha at which an engine is faster than CGAL. Others are the
// share of the full triangulation, and the gain by each optimisation. Each timed result is also
// checked against CGAL. Prints nothing.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/session/engines.hpp"
#include "app/session/machine.hpp"
#include "core/geometry/alpha.hpp"
#include "core/selection/provenance.hpp"

namespace alphascope {

struct ThesisMolecule {
  std::string name;
  std::shared_ptr<const BallSet> balls;  // grown by the solvent radius
  Provenance provenance;
};

struct ThesisOptions {
  std::vector<Alpha> alphas{0, 1.4, 3};  // Å²
  std::vector<EngineChoice> engines;     // without `automatic` and `cgal`; CGAL always runs
  double solvent_radius_angstrom = 0;  // Å; the balls already contain it, and each row repeats it
  int threads = 0;                     // of engines on the CPU; 0: all
  int repeats = 5;                     // counted runs; one more run comes first
  double seconds_per_row = 20;         // limit; a row that needs longer is cut short or left out
  bool tetrahedra_only = true;         // as in the thesis
  bool ablation = true;                // for the tuple engines, at the smallest alpha
  int bisections = 3;                  // steps that narrow the interval between a won and a lost
                                       // alpha; 0: only the given alphas
};

// All engines that can run here without CGAL, such as "tuples-cpu".
std::vector<EngineChoice> thesis_engines(const MachineInfo& machine);

// Medians of the counted cold runs in milliseconds. Empty if the engine has no such stage.
struct ThesisStages {
  std::optional<double> memcpy, kernel1, prefix_sum, kernel2, kernel3;
  std::optional<double> other;  // grid, coincident centres, classification, hash, triangulation
  bool kernel1_has_kernel2 = false;  // one launch does both, and kernel2 is empty
};

struct ThesisRow {
  enum class Kind { cgal, engine, ablation };
  Kind kind = Kind::engine;
  std::string molecule;
  std::size_t molecule_index = 0, balls = 0;
  Alpha alpha_angstrom2;
  EngineChoice choice = EngineChoice::cpu;
  int threads = 0;        // requested number; 0: all
  std::string variant;    // of ablation rows, such as "without textures"
  std::string skipped;    // why nothing below was measured; empty: measured
  bool too_slow = false;  // skipped because its time was over

  EngineInfo engine;
  ThesisStages stages;
  std::vector<StageTime> stage_medians;  // all stages of the cold runs, named as by the engine
  int runs = 0;                          // number of counted runs
  // Median wall times. Cold: a new engine, made and asked once. Warm: the same engine, asked again
  // at an alpha smaller by 0.001 Å².
  double cold_milliseconds = 0, warm_milliseconds = 0;
  std::optional<double> cgal_cold_milliseconds;           // one thread, in turns with this row
  std::optional<double> cgal_parallel_cold_milliseconds;  // with three threads or more
  std::size_t tetrahedra = 0;
  std::optional<std::size_t> full_tetrahedra;  // of the molecule's whole regular triangulation
  std::uint64_t hash = 0;
  std::optional<bool> same_as_cgal;  // by hash; empty if CGAL was left out

  bool measured() const { return skipped.empty(); }
  std::optional<double> speed_up() const;  // over CGAL with one thread, cold
  std::optional<double> share_of_full() const;
};

// The largest alpha at which an engine is faster than CGAL with one thread, both cold.
struct BreakEven {
  std::size_t molecule_index = 0;
  EngineChoice choice = EngineChoice::cpu;
  std::optional<double> alpha_angstrom2;  // the largest alpha won; empty: none was won
  bool beyond = false;                    // the largest tried alpha was won
  // The smallest alpha lost. The break-even lies between the two. Empty if `beyond`.
  std::optional<double> lost_at_angstrom2;
};

struct ThesisReport {
  ThesisOptions options;
  MachineInfo machine;
  std::string program;  // name, version and commit
  std::vector<ThesisMolecule> molecules;
  std::vector<ThesisRow> rows;
  std::vector<BreakEven> break_even;
  bool complete = true;  // false: the run was cancelled, so later rows are missing

  // True if no measured row differs from CGAL.
  bool all_same() const;
};

// Called on the measuring thread when a row is complete.
using RowListener = std::function<void(const ThesisRow&)>;

// The report without rows: molecules, options, machine and program.
ThesisReport thesis_report(const std::vector<ThesisMolecule>& molecules,
                           const ThesisOptions& options);

// `factory` makes all engines, also CGAL's. Progress reports name the present measurement and the
// finished share. Throws Cancelled, and std::invalid_argument for options that request nothing. A
// failing engine gives a skipped row with its message.
ThesisReport run_thesis_suite(const std::vector<ThesisMolecule>& molecules,
                              const ThesisOptions& options, const EngineFactory& factory,
                              const RunContext& context, const RowListener& listener = {});

}  // namespace alphascope
