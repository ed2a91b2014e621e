// What the command line can be asked, as plain data, and the commands that do it. Parsing is
// command_line.hpp's; each command returns an ExitCode and throws for what went wrong.
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/options/exit_code.hpp"
#include "app/session/engine_cache.hpp"
#include "app/session/open_molecule.hpp"
#include "core/cavity/cavities.hpp"
#include "core/document/measures/measure_names.hpp"
#include "core/document/picture/caption_parts.hpp"
#include "core/document/picture/recording.hpp"
#include "core/document/reference/annotations.hpp"
#include "core/document/reference/appearance.hpp"
#include "core/document/settings/paint.hpp"

namespace alphascope::cli {

// A sensible-looking command line that asks for what cannot be.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// How much is said besides results and errors. quiet: nothing. verbose: also progress as lines, and
// with each result its stages, the time for opening and the memory used.
enum class Verbosity { quiet, normal, verbose };

struct InputOptions {
  std::filesystem::path file;   // "-" for standard input
  std::string format = "auto";  // or an id of a format, as format_from_id() takes it
  std::string radii = "auto";   // id of a radii set, or a file with a table of radii
  std::string model = "1";      // counted from 1; "all": each by itself; "joined": all as one
  std::string hydrogens = "auto", altlocs = "best";
  bool waters = false, dummies = false, no_ligands = false, no_ions = false, no_polymers = false;
  std::vector<std::string> chains, without_chains, treated;
  std::string select;    // core/selection/selection_expression.hpp
  std::string assembly;  // id, empty = as deposited
};

// The files of a command that takes many.
struct InputFiles {
  std::vector<std::string> named;
  std::string list;             // file with more names, "-" for standard input, empty for none
  bool null_separated = false;  // names in the list end with a NUL byte, not with the line
  // Then results are a table and go on after an error.
  bool many() const { return named.size() > 1 || !list.empty(); }
};

struct InfoOptions {
  InputFiles files;
  InputOptions input;
  // File, "-" for standard output, empty for none; so everywhere.
  std::string json, csv;
  bool residues = false, each_residue = false;
};

struct ComputeOptions {
  InputFiles files;
  InputOptions input;
  Request request;
  std::string json, csv, out;
};

// What belongs to the body whose cavities are looked for, beside proteins and nucleic acids.
struct BodyOptions {
  bool ligands = false, ions = false;
};

// Files for other programs; empty: not wanted.
struct ShapeOptions {
  std::string spheres, surface, script;
  bool any() const { return !spheres.empty() || !surface.empty() || !script.empty(); }
};

struct CavitiesOptions {
  InputFiles files;
  InputOptions input;
  BodyOptions body;
  Request request;  // alpha and threads; no engine is asked
  // Each set with each solvent radius (Å); several are compared. Not input.radii.
  std::vector<std::string> radii{"auto"};
  std::vector<double> solvents;
  OutsideRule rule = OutsideRule::castp;
  FlowTies ties = FlowTies::perturbed;
  bool no_clipped = false;                     // without exact volumes
  bool split_networks = false;                 // networks are listed as their parts
  bool no_network_radius = false;              // nobody asks where networks fall apart
  int shown = 20;                              // rows printed
  std::optional<double> min_volume_angstrom3;  // SA; smaller ones are counted, but not listed
  std::string json, csv, lives;
  ShapeOptions shapes;
  bool compares() const { return radii.size() * solvents.size() > 1; }
};

struct ChannelOptions {
  InputOptions input;
  BodyOptions body;
  // Å, three numbers each, or none. Without a point the channel begins in a cavity; without both it
  // is a way through the molecule.
  std::vector<double> point, to, along;
  int cavity = 0;                      // its rank in the table of `cavities`; 0: none
  std::vector<double> mouths;          // of it: the end, or both ends; from 1
  double solvent_radius_angstrom = 0;  // of that table
  double end_radius_angstrom = 5;
  int way = 0;  // of the list of ways through; 0: none was named, and the best is taken
  int threads = 0;
  std::string json, csv;
  ShapeOptions shapes;

  bool is_way() const { return point.empty() && cavity == 0; }
};

struct MeasureCommandOptions {
  InputFiles files;
  InputOptions input;
  Request request;
  MeasuredPer per = MeasuredPer::all;
  bool derivatives = false;
  std::string json, csv;
};

struct ExportOptions {
  InputOptions input;
  Request request;
  std::filesystem::path out;  // "-" for standard output
  std::string as;  // an id of core/document/export/complex_export.hpp; empty: by out's ending
  std::string colours = "element";
};

struct ExplainOptions {
  InputOptions input;
  std::vector<int> simplex;  // 1 to 4 different balls, from 0; or none, then there are atoms
  std::string atoms;         // 1 to 4 of them by address or expression
  std::optional<Alpha> alpha_angstrom2;
  double solvent_radius_angstrom = 0;
  std::string json;
};

struct VerifyOptions {
  InputOptions input;
  Request request;
  std::vector<Alpha> alphas;  // Å²
  int cgal_threads = 1;
  bool definition = false;  // also check the definition of the complex, without CGAL
  int shown = 10;           // differences printed per kind of simplex
  std::string json;
};

struct BenchOptions {
  InputOptions input;
  std::vector<std::string> files;
  Request request;
  std::vector<Alpha> alphas;  // Å²
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
  Request request;
  std::string size = "1280x800";
  std::filesystem::path out;
  bool transparent = false, light = false, no_balls = false, grown = false, boundary = false;
  double shrink = 0;
  Paint ball_paint{ColourBy::element, {}, {}, {}};
  std::optional<Paint> simplex_paint;  // none: as the balls
  bool no_legend = false, scale_bar = false;
  CaptionParts caption;
  bool orthographic = false;
  std::string preset;  // id of a DisplayPreset, or none
  bool no_shadows = false;
  // None: the preset's, or the window's.
  std::optional<double> depth_cue, outlines, face_lines, edge_thickness, samples;
  bool smooth = false;  // the boundary
  AppearanceWords appearance;
  AnnotationWords annotations;
  std::string clip = "off";                        // as read_clip() takes it
  std::string beside = "ligands,ions";             // kinds of AtomsBesideBody, or "none"
  std::optional<std::uint64_t> drawing_memory_mb;  // taken as free; none: what is
  std::filesystem::path session;                   // empty: none; else input.file may be empty
  std::vector<std::string> beside_session;         // options that a session says itself
  std::vector<std::string> arguments;              // as given, for the program that draws
};

struct FramesCommandOptions {
  ScreenshotCommandOptions picture;  // of each frame; its `out` names all of them, or a movie
  Recording recording;
  bool sweep = false, turntable = false;        // which was asked for
  std::string scaling = "linear", axis = "up";  // kScalings, kTurnAxes
  FramesCommandOptions() { picture.caption = usual_caption(); }
};

ExitCode run_info(const InfoOptions& options);
ExitCode run_compute(const ComputeOptions& options);
ExitCode run_cavities(const CavitiesOptions& options);
ExitCode run_channel(const ChannelOptions& options);
ExitCode run_measure(const MeasureCommandOptions& options);
ExitCode run_export(const ExportOptions& options);
ExitCode run_explain(const ExplainOptions& options);
ExitCode run_verify(const VerifyOptions& options, const EngineFactory& factory = &make_engine);
ExitCode run_bench(const BenchOptions& options);
ExitCode run_thesis_bench(const BenchOptions& options);
ExitCode run_screenshot(const ScreenshotCommandOptions& options);
ExitCode run_frames(const FramesCommandOptions& options);

}  // namespace alphascope::cli
