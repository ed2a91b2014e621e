#include "app/cli/cavity_exports.hpp"

#include "app/cli/cavity_records.hpp"
#include "core/document/cavity_bars.hpp"
#include "core/document/cavity_export.hpp"
#include "core/io/output_ending.hpp"
#include "core/run/work_threads.hpp"

namespace alphascope::cli {
namespace {

namespace fs = std::filesystem;

bool ends(const std::string& path, const char* ending) {
  return output_ending(path) == ending;
}

void require_ending(const char* option, const std::string& path, const char* one,
                    const char* other) {
  if (path.empty() || ends(path, one) || ends(path, other)) return;
  throw UsageError(std::string(option) + " " + path + ": the name must end in " + one + " or " +
                   other + ".");
}

// A result on standard output has no name that a script could open.
fs::path named(const std::string& path) {
  return path.empty() || path == "-" ? fs::path() : fs::absolute(path);
}

}  // namespace

CavityExports::CavityExports(const CavitiesOptions& options, Outputs& outputs) : options_(options) {
  require_ending("--surface", options.surface, ".ply", ".glb");
  require_ending("--script", options.script, ".cxc", ".pml");
  const bool any = !options.lives.empty() || !options.spheres.empty() || !options.surface.empty() ||
                   !options.script.empty();
  if (any && (options.files.many() || each_model(options.input) || options.compares())) {
    throw UsageError(
        "--lives, --spheres, --surface and --script are of the cavities of one file and one model, "
        "with one radii set and one solvent radius.");
  }
  if (!options.script.empty() && options.files.named.front() == "-") {
    throw UsageError("--script opens the molecule's file, which standard input is not.");
  }
  lives_ = outputs.add("--lives", options.lives, Outputs::kCsv);
  spheres_ = outputs.add("--spheres", options.spheres, {".pqr"});
  surface_ = outputs.add("--surface", options.surface, {".ply", ".glb"});
  script_ = outputs.add("--script", options.script, {".cxc", ".pml"});
}

void CavityExports::write(const CavityAnswer& answer, const RunContext& context) {
  if (lives_ != nullptr) write_lives(answer);
  if (spheres_ != nullptr) {
    WorkThreads threads(answer.request.threads);
    threads.run([&] {
      write_cavity_spheres({answer, noted_header(answer)}, *spheres_, context.cancel);
    });
  }
  if (surface_ != nullptr) {
    write_cavity_surfaces({answer, noted_header(answer)}, ends(options_.surface, ".glb"),
                          *surface_);
  }
  if (script_ != nullptr) write_script(answer);
}

void CavityExports::write_lives(const CavityAnswer& answer) {
  std::vector<std::string> comments;
  for (const auto& [key, value] : noted_header(answer)) {
    if (!value.empty()) comments.push_back(key + ": " + value);
  }
  const CavityGround& ground = *answer.table().ground;
  const CavityBars bars = longest_bars(*answer.lives, ground.balls->lattice, -kMaxAlphaAngstrom2,
                                       answer.lives->sinks.size());
  lives_->write(bars_csv(bars.longest, *ground.triangulation, *answer.atoms, comments));
}

void CavityExports::write_script(const CavityAnswer& answer) {
  const std::string why = why_no_cavity_script(answer.input.molecule());
  if (!why.empty()) throw UsageError("--script: " + why);
  const bool chimerax = ends(options_.script, ".cxc");
  const CavityScriptFiles files{named(options_.spheres), ends(options_.surface, ".glb")
                                                             ? named(options_.surface)
                                                             : fs::path()};
  try {
    script_->write(cavity_script({answer, noted_header(answer)},
                                 chimerax ? CavityExport::chimerax : CavityExport::pymol, files));
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
}

}  // namespace alphascope::cli
