// The options of every command (CLI11), their help, and exceptions as messages and exit codes.
#include "app/cli/command_line.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <functional>
#include <iostream>
#include <new>

#include "app/cli/commands.hpp"
#include "app/cli/terminal.hpp"
#include "app/cli/text.hpp"
#include "app/session/version.hpp"
#include "core/io/atomic_file.hpp"

namespace alphascope::cli {
namespace {

using Command = std::function<ExitCode()>;

constexpr const char* kExamples = R"(
Examples:
  alphascope-cli info 1crn.pdb
  alphascope-cli compute 1crn.pdb --alpha 0 --solvent 1.4 --json 1crn.json
  alphascope-cli compute 1k4c.crd.gz --alpha 1.4 --out 1k4c.alpha
  alphascope-cli compute 1d3z.cif.gz --model all --alpha 0 --solvent 1.4 --csv models.csv
  alphascope-cli verify 1crn.pdb --alpha -1,0,1.4,10
  alphascope-cli bench 1k4c.crd.gz --alpha 0,1.4,3 --tetrahedra-only --csv times.csv
  alphascope-cli screenshot 1crn.pdb --alpha 1.4 --size 1920x1080 -o 1crn.png

Lengths are in Å. Alpha is in Å²: a ball of radius r grows to sqrt(r² + alpha); negative alpha
shrinks it. The solvent radius is added to every radius first (1.4 for water).

Exit codes: 0 done; 1 differs from CGAL (verify, bench); 2 wrong usage; 3 a file cannot be read;
4 computing failed; 5 an output cannot be written; 130 cancelled (Ctrl-C; 143 by SIGTERM,
129 by SIGHUP); 141 nobody reads the pipe any more.
)";

const CLI::Validator kFinite(
    [](std::string& text) {
      double value = 0;
      if (!CLI::detail::lexical_cast(text, value) || !std::isfinite(value)) {
        return "\"" + text + "\" is not a finite number";
      }
      return std::string();
    },
    "NUMBER");

const CLI::Validator kAlpha(
    [](std::string& text) {
      double value = 0;
      if (!CLI::detail::lexical_cast(text, value) || !is_alpha(value)) {
        return "\"" + text + "\" is not a number from -" + number_text(kMaxAlphaAngstrom2) +
               " to " + number_text(kMaxAlphaAngstrom2);
      }
      return std::string();
    },
    "NUMBER");

void add_input(CLI::App& command, InputOptions& input) {
  command
      .add_option("--radii", input.radii,
                  "Radii: auto, file (the file's own), bondi, protor, alvarez, amber, naccess, "
                  "rasmol; or a file with a table of your own")
      ->type_name("SET");
  command
      .add_option("--model", input.model,
                  "Model, counted from 1; all for each by itself, joined for all as one")
      ->type_name("N|all|joined");
  command.add_option("--hydrogens", input.hydrogens, "auto drops them with united-atom radii")
      ->check(CLI::IsMember({"auto", "keep", "drop"}));
  command.add_option("--altlocs", input.altlocs, "Alternative locations: the best, or all")
      ->check(CLI::IsMember({"best", "all"}));
  command.add_option("--chain", input.chains, "Only these chains, such as A,B")
      ->delimiter(',')
      ->type_name("ID");
  command.add_option("--without-chain", input.without_chains, "All but these chains")
      ->delimiter(',')
      ->type_name("ID");
  command
      .add_option("--select", input.select,
                  "Only what this picks, such as \"chain A and not resn HEM\"")
      ->type_name("EXPRESSION");
  command.add_option("--assembly", input.assembly, "Expand a biological assembly; info lists them")
      ->type_name("ID");
  command.add_flag("--waters", input.waters, "Keep waters");
  command.add_flag("--dummies", input.dummies, "Keep dummy atoms, such as OPM's membrane planes");
  command.add_flag("--no-polymers", input.no_polymers, "Drop proteins and nucleic acids");
  command.add_flag("--no-ligands", input.no_ligands, "Drop ligands");
  command.add_flag("--no-ions", input.no_ions, "Drop ions");
}

void add_file(CLI::App& command, InputOptions& input) {
  command.add_option("FILE", input.file, "Molecule: PDB, mmCIF, XYZR, PQR, XYZ, CRD; also .gz")
      ->required();
  add_input(command, input);
}

void add_alpha(CLI::App& command, SessionRequest& request) {
  command.add_option("--alpha", request.alpha_angstrom2, "Alpha in Å², negative too")
      ->required()
      ->check(kAlpha)
      ->type_name("A");
}

void add_alphas(CLI::App& command, std::vector<double>& alphas) {
  command.add_option("--alpha", alphas, "Alphas in Å², such as -1,0,1.4")
      ->required()
      ->delimiter(',')
      ->check(kAlpha)
      ->type_name("A,B,...");
}

// The switches of the tuple engines; refused with another engine, where they would do nothing.
void add_tuples(CLI::App& command, SessionRequest& request) {
  constexpr const char* kGroup = "Options of --engine tuples-cpu and tuples-gpu (same result)";
  TupleOptions& tuples = request.tuples;
  command
      .add_option_function<std::string>(
          "--tuple-grid",
          [&tuples](const std::string& id) {
            tuples.grid = id == "100" ? TupleGridKind::thesis : TupleGridKind::automatic;
          },
          "Cells: auto, or 100 for 100 x 100 x 100")
      ->check(CLI::IsMember({"auto", "100"}))
      ->group(kGroup);
  const auto off = [&](const char* name, bool& value, const char* help) {
    command
        .add_flag_callback(
            name, [&value] { value = false; }, help)
        ->group(kGroup);
  };
  off("--no-edge-optimisation", tuples.edge_optimisation,
      "Enumerate tuples of balls that do not all meet, too");
  off("--no-alpha-optimisation", tuples.alpha_optimisation,
      "Send tuples of ortho-radius above alpha to kernel II, too");
  off("--pageable", tuples.pinned, "GPU: pageable host memory instead of pinned");
  off("--no-texture", tuples.texture, "GPU: read balls from plain memory, not through textures");
  command.add_option("--streams", tuples.streams, "GPU: streams side by side, 1 for none")
      ->check(CLI::Range(1, 8))
      ->type_name("N")
      ->group(kGroup);
  command
      .add_option("--tuples-per-batch", tuples.tuples_per_batch, "Tuples held at once, 0 to choose")
      ->check(CLI::Range(0, 100'000'000))
      ->type_name("N")
      ->group(kGroup);
  command.parse_complete_callback([&request] {
    if (is_tuple_engine(request.engine) || request.tuples == TupleOptions{}) return;
    throw CLI::ValidationError("The options of the tuple engines",
                               "need --engine tuples-cpu or tuples-gpu");
  });
}

void add_engine(CLI::App& command, SessionRequest& request, bool threads) {
  command
      .add_option("--solvent", request.solvent_radius_angstrom, "Solvent radius in Å, from 0 up")
      ->check(kFinite)
      ->check(CLI::Range(0.0, 100.0))
      ->type_name("S");
  command
      .add_option_function<std::string>(
          "--engine", [&request](const std::string& id) { request.engine = *engine_from_id(id); },
          "auto takes the GPU when there is one; the result is the same")
      ->check(CLI::IsMember({"auto", "cpu", "cgal", "gpu", "tuples-cpu", "tuples-gpu"}));
  if (threads) {
    command.add_option("--threads", request.threads, "CPU threads; 0 for all")
        ->check(CLI::Range(0, 1024))
        ->type_name("N");
  }
  command.add_flag("--tetrahedra-only", request.tetrahedra_only,
                   "Only tetrahedra (without vertices, edges, triangles and classes)");
  add_tuples(command, request);
}

void add_info(CLI::App& app, InfoOptions& options, Command& chosen) {
  CLI::App& command = *app.add_subcommand("info", "Tell what is in a file and what is used of it");
  add_file(command, options.input);
  command.add_option("--json", options.json, "The same as JSON, - for standard output")
      ->type_name("OUT");
  command.callback([&] { chosen = [&] { return run_info(options); }; });
}

void add_compute(CLI::App& app, ComputeOptions& options, Command& chosen) {
  CLI::App& command = *app.add_subcommand("compute", "Compute the alpha complex");
  add_file(command, options.input);
  add_alpha(command, options.request);
  add_engine(command, options.request, true);
  command
      .add_option("--json", options.json,
                  "Counts, hash, times and provenance as JSON, - for standard output")
      ->type_name("OUT");
  command
      .add_option("--csv", options.csv,
                  "Counts and provenance as CSV, one row for each model; - for standard output")
      ->type_name("OUT");
  command.add_option("--out", options.out, "All simplices with their alpha values, as text")
      ->type_name("COMPLEX");
  command.callback([&] { chosen = [&] { return run_compute(options); }; });
}

void add_verify(CLI::App& app, VerifyOptions& options, Command& chosen) {
  CLI::App& command = *app.add_subcommand(
      "verify", "Compare with CGAL as sets of simplices; exit code 0 only if identical");
  add_file(command, options.input);
  add_alphas(command, options.alphas);
  add_engine(command, options.request, true);
  command.add_option("--cgal-threads", options.cgal_threads, "Threads for CGAL; 0 for all")
      ->check(CLI::Range(0, 1024))
      ->type_name("N");
  command.add_flag("--definition", options.definition,
                   "Also prove from the definition, without CGAL, that all is right and nothing missing");
  command.add_option("--show", options.shown, "Differences printed for each kind of simplex")
      ->type_name("N");
  command.add_option("--json", options.json, "The comparison as JSON, - for standard output")
      ->type_name("OUT");
  command.callback([&] { chosen = [&] { return run_verify(options); }; });
}

// What only --suite thesis has.
void add_thesis_suite(CLI::App& command, BenchOptions& options) {
  constexpr const char* kGroup = "The thesis' table and figures";
  command
      .add_option("--suite", options.suite,
                  "thesis: all engines, stages, ablations and figures of the thesis' chapter 4")
      ->check(CLI::IsMember({"thesis"}))
      ->group(kGroup);
  command
      .add_option("--engines", options.engines, "Those of the suite; all that can run if left out")
      ->delimiter(',')
      ->check(CLI::IsMember({"cpu", "gpu", "tuples-cpu", "tuples-gpu"}))
      ->type_name("ID,...")
      ->group(kGroup);
  command
      .add_option("--seconds", options.seconds_per_row,
                  "Most time for a row; what needs longer for one run is left out")
      ->check(CLI::Range(0.1, 86400.0))
      ->type_name("S")
      ->group(kGroup);
  command
      .add_flag_callback(
          "--no-ablation", [&options] { options.ablation = false; },
          "Without the rows that switch optimisations off")
      ->group(kGroup);
  command.add_option("--json", options.json, "The table as JSON, - for standard output")
      ->type_name("OUT")
      ->group(kGroup);
  command.add_option("--charts", options.charts, "The figures as SVG, into this folder")
      ->type_name("DIR")
      ->group(kGroup);
}

void add_bench(CLI::App& app, BenchOptions& options, Command& chosen) {
  CLI::App& command = *app.add_subcommand(
      "bench", "Time our engine and CGAL in one process, cold and warm; medians");
  command.add_option("FILE", options.files, "Molecules")->required();
  add_input(command, options.input);
  command
      .add_option("--alpha", options.alphas,
                  "Alphas in Å², such as -1,0,1.4; the suite takes 0,1.4,3 if left out")
      ->delimiter(',')
      ->check(kAlpha)
      ->type_name("A,B,...");
  add_engine(command, options.request, false);
  command.add_option("--threads", options.threads, "CPU threads for both, such as 1,2; 0 for all")
      ->delimiter(',')
      ->check(CLI::Range(0, 1024))
      ->type_name("N,...");
  command.add_option("--runs", options.runs, "Runs of each")
      ->check(CLI::Range(1, 1000))
      ->type_name("N");
  command.add_option("--csv", options.csv, "The table as CSV, - for standard output")
      ->type_name("OUT");
  add_thesis_suite(command, options);
  command.callback([&] { chosen = [&] { return run_bench(options); }; });
}

void add_screenshot(CLI::App& app, ScreenshotCommandOptions& options, Command& chosen) {
  CLI::App& command = *app.add_subcommand("screenshot", "Draw the complex; needs no display");
  add_file(command, options.input);
  add_alpha(command, options.request);
  add_engine(command, options.request, true);
  command.add_option("--size", options.size, "In pixels")->type_name("WxH");
  command.add_option("-o,--output", options.out, "Picture to write")
      ->required()
      ->type_name("OUT.png");
  command.add_flag("--transparent", options.transparent, "No background");
  command.add_flag("--light", options.light, "Light background");
  command.add_flag("--no-balls", options.no_balls, "Without the balls");
  command.add_flag("--grown", options.grown, "Balls as large as alpha and solvent make them");
  command.add_flag("--boundary", options.boundary, "Only the boundary of the tetrahedra");
  command.add_option("--shrink", options.shrink, "Draw tetrahedra apart, from 0 to 0.9")
      ->check(CLI::Range(0.0, 0.9));
  command.add_option("--colours", options.colours, "Colour balls by element or chain")
      ->check(CLI::IsMember({"element", "chain"}));
  command
      .add_option("--simplex-colours", options.simplex_colours,
                  "Colour simplices as their balls are, or by alpha value, with a legend")
      ->check(CLI::IsMember({"balls", "alpha"}));
  command.add_flag("--no-legend", options.no_legend, "Without the legend of the alpha values");
  command.add_flag("--scale-bar", options.scale_bar, "With a bar of a round length in Å");
  command
      .add_option("--drawing-memory", options.drawing_memory_mb,
                  "Draw as if so much memory were free; otherwise what the system says")
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{1} << 40))
      ->type_name("MB");
  command.callback([&] { chosen = [&] { return run_screenshot(options); }; });
}

int fail(ExitCode code, const std::string& message) {
  clear_progress();
  std::cout.flush();
  std::cerr << "alphascope-cli: " << message << std::endl;
  return static_cast<int>(code);
}

int run(const Command& command) {
  try {
    return static_cast<int>(command());
  } catch (const Cancelled&) {
    fail(ExitCode::cancelled, "cancelled; nothing was written.");
    return cancelled_status();
  } catch (const UsageError& e) {
    return fail(ExitCode::usage, e.what());
  } catch (const ReadError& e) {
    return fail(ExitCode::unreadable_input, e.what());
  } catch (const WriteError& e) {
    return fail(ExitCode::unwritable_output, e.what());
  } catch (const std::invalid_argument& e) {
    return fail(ExitCode::usage, e.what());
  } catch (const std::bad_alloc&) {
    return fail(ExitCode::computing_failed,
                "Not enough memory. Use a smaller alpha or solvent radius, or --tetrahedra-only.");
  } catch (const std::exception& e) {
    return fail(ExitCode::computing_failed, e.what());
  }
}

}  // namespace

int run_command_line(int argc, const char* const* argv) {
  InfoOptions info;
  ComputeOptions compute;
  VerifyOptions verify;
  BenchOptions bench;
  ScreenshotCommandOptions screenshot;
  Command chosen;
  CLI::App app("The exact alpha complex of molecules, equal to CGAL's simplex by simplex.",
               "alphascope-cli");
  app.set_version_flag("--version", "alphascope-cli " + std::string(program_version()) + " (" +
                                        std::string(program_commit()) + ")");
  app.require_subcommand(1);
  app.footer(kExamples);
  add_info(app, info, chosen);
  add_compute(app, compute, chosen);
  add_verify(app, verify, chosen);
  add_bench(app, bench, chosen);
  add_screenshot(app, screenshot, chosen);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : static_cast<int>(ExitCode::usage);
  }
  return run(chosen);
}

}  // namespace alphascope::cli
