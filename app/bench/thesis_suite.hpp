// Measures what the thesis' chapter 4 reports, for molecules at hand: times of each stage, speed-up
// over CGAL, the alpha up to which CGAL is beaten, the share of the full triangulation, and what
// each optimisation saves. Times nothing that it does not also check against CGAL; prints nothing.
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
  std::shared_ptr<const BallSet> balls;  // with the solvent radius
  Provenance provenance;
};

struct ThesisOptions {
  std::vector<Alpha> alphas{0, 1.4, 3};  // Å²
  std::vector<EngineChoice> engines;     // neither automatic nor cgal, which is always there
  double solvent_radius_angstrom = 0;    // already in the balls; told again in every row
  int threads = 0;                       // of engines on the CPU; 0: as many as there are
  int repeats = 5;                       // counted runs; one more comes first and is not counted
  double seconds_per_row = 20;           // a row that needs longer is cut short or left out
  bool tetrahedra_only = true;           // the thesis' sub-complex
  bool ablation = true;                  // of the tuple engines, at the smallest alpha
  int bisections = 3;                    // between a won and a lost alpha; 0: only the alphas given
};

// "tuples-cpu", …: those that can run here, all but CGAL.
std::vector<EngineChoice> thesis_engines(const MachineInfo& machine);

// Milliseconds, medians of the counted cold runs; empty where the engine has no such stage.
struct ThesisStages {
  std::optional<double> memcpy, kernel1, prefix_sum, kernel2, kernel3;
  std::optional<double> other;  // grid, coincident centres, classification, hash, triangulation
  bool kernel1_has_kernel2 = false;  // one launch does both: kernel2 is empty
};

struct ThesisRow {
  enum class Kind { cgal, engine, ablation };
  Kind kind = Kind::engine;
  std::string molecule;
  std::size_t molecule_index = 0, balls = 0;
  Alpha alpha_angstrom2;
  EngineChoice choice = EngineChoice::cpu;
  int threads = 0;        // asked for; 0: all
  std::string variant;    // of ablation rows: "without textures"
  std::string skipped;    // why nothing below was measured; empty when it was
  bool too_slow = false;  // skipped for lack of time

  EngineInfo engine;
  ThesisStages stages;
  std::vector<StageTime> stage_medians;  // all stages of the cold runs, in the engine's words
  int runs = 0;                          // counted
  // Median wall times. Cold: a new engine, made and asked once. Warm: the same one asked again for
  // an alpha smaller by 0.001 Å².
  double cold_milliseconds = 0, warm_milliseconds = 0;
  std::optional<double> cgal_cold_milliseconds;           // one thread, in turns with this row
  std::optional<double> cgal_parallel_cold_milliseconds;  // with three threads or more
  std::size_t tetrahedra = 0;
  std::optional<std::size_t> full_tetrahedra;  // of the molecule's whole regular triangulation
  std::uint64_t hash = 0;
  std::optional<bool> same_as_cgal;  // by hash; empty when CGAL was left out

  bool measured() const { return skipped.empty(); }
  std::optional<double> speed_up() const;  // over CGAL with one thread, cold
  std::optional<double> share_of_full() const;
};

// Up to which alpha an engine is faster than CGAL with one thread, both cold.
struct BreakEven {
  std::size_t molecule_index = 0;
  EngineChoice choice = EngineChoice::cpu;
  std::optional<double> alpha_angstrom2;  // the largest alpha won; empty: none of those tried
  bool beyond = false;                    // the largest alpha tried was still won
  // The smallest alpha found lost: the truth is between the two. Empty when `beyond`.
  std::optional<double> lost_at_angstrom2;
};

struct ThesisReport {
  ThesisOptions options;
  MachineInfo machine;
  std::string program;  // name, version and commit
  std::vector<ThesisMolecule> molecules;
  std::vector<ThesisRow> rows;
  std::vector<BreakEven> break_even;
  bool complete = true;  // false: cancelled, and what followed these rows was not measured

  // No measured row differs from CGAL.
  bool all_same() const;
};

// Called on the measuring thread, as each row is complete.
using RowListener = std::function<void(const ThesisRow&)>;

// Everything but the rows: what is measured, where and by what.
ThesisReport thesis_report(const std::vector<ThesisMolecule>& molecules,
                           const ThesisOptions& options);

// `factory` makes all engines, CGAL's too. Progress: what is measured, and the share of the whole.
// Throws Cancelled; std::invalid_argument for options that ask for nothing. An engine that fails
// gives a skipped row with its message.
ThesisReport run_thesis_suite(const std::vector<ThesisMolecule>& molecules,
                              const ThesisOptions& options, const EngineFactory& factory,
                              const RunContext& context, const RowListener& listener = {});

}  // namespace alphascope
