// What the command line can be asked, as plain data, and the commands that do it. Parsing is
// command_line.hpp's; each command returns an ExitCode and throws for what went wrong.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/session/engine_cache.hpp"
#include "app/session/open_molecule.hpp"

namespace alphascope::cli {

// Documented in --help and docs/user-guide.md; scripts rely on them.
enum class ExitCode : int {
  ok = 0,
  differs = 1,            // verify and bench: not the same as CGAL
  usage = 2,              // the command line makes no sense
  unreadable_input = 3,   // a file cannot be read or understood
  computing_failed = 4,   // engine unavailable, out of memory, internal error
  unwritable_output = 5,  // an output file cannot be written
  cancelled = 130,        // Ctrl-C, as shells expect (128 + SIGINT); other signals likewise
};

// A sensible-looking command line that asks for what cannot be.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct InputOptions {
  std::filesystem::path file;
  std::string radii = "auto";  // id of a radii set, or a file with a table of radii
  std::string model = "1";     // counted from 1; "all": each by itself; "joined": all as one
  std::string hydrogens = "auto", altlocs = "best";
  bool waters = false, dummies = false, no_ligands = false, no_ions = false, no_polymers = false;
  std::vector<std::string> chains, without_chains;
  std::string select;    // core/molecule/selection_expression.hpp
  std::string assembly;  // id, empty = as deposited
};

struct InfoOptions {
  InputOptions input;
  std::string json;  // file, "-" for standard output, empty for none; so everywhere
};

struct ComputeOptions {
  InputOptions input;
  SessionRequest request;
  std::string json, csv, out;
};

struct VerifyOptions {
  InputOptions input;
  SessionRequest request;
  std::vector<double> alphas;  // Å²
  int cgal_threads = 1;
  bool definition = false;  // also check the definition of the complex, without CGAL
  std::size_t shown = 10;   // differences printed per kind of simplex
  std::string json;
};

struct BenchOptions {
  InputOptions input;
  std::vector<std::filesystem::path> files;
  SessionRequest request;
  std::vector<double> alphas;  // Å²
  std::vector<int> threads{1};
  int runs = 5;
  std::string csv;
  // What follows is of --suite thesis.
  std::string suite;                 // "thesis", or empty
  std::vector<std::string> engines;  // ids; empty: all that can run here
  double seconds_per_row = 20;
  bool ablation = true;
  std::string json, charts;  // charts: a folder
};

struct ScreenshotCommandOptions {
  InputOptions input;
  SessionRequest request;
  std::string size = "1280x800";
  std::filesystem::path out;
  bool transparent = false, light = false, no_balls = false, grown = false, boundary = false;
  double shrink = 0;
  std::string colours = "element", simplex_colours = "balls";
  bool no_legend = false, scale_bar = false;
  std::optional<std::uint64_t> drawing_memory_mb;  // taken as free; none: what is
};

ExitCode run_info(const InfoOptions& options);
ExitCode run_compute(const ComputeOptions& options);
ExitCode run_verify(const VerifyOptions& options);
ExitCode run_bench(const BenchOptions& options);
ExitCode run_thesis_bench(const BenchOptions& options);
ExitCode run_screenshot(const ScreenshotCommandOptions& options);

}  // namespace alphascope::cli
