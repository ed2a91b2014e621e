#include "app/cli/cavity_exports.hpp"

#include "app/cli/cavity_records.hpp"
#include "core/cavity/cavity_mesh.hpp"
#include "core/cavity/clearance.hpp"
#include "core/cavity/filling_spheres.hpp"
#include "core/chart/chart.hpp"
#include "core/document/cavity_bars.hpp"
#include "core/io/output_ending.hpp"
#include "core/io/viewer_script.hpp"
#include "core/io/write_mesh.hpp"
#include "core/io/write_spheres.hpp"
#include "core/run/work_threads.hpp"

namespace alphascope::cli {
namespace {

namespace fs = std::filesystem;

std::array<std::uint8_t, 3> colour_of(std::size_t row) {
  const ChartColour c = chart_colour(row);
  return {c.r, c.g, c.b};
}

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
    threads.run([&] { write_spheres(answer, context.cancel); });
  }
  if (surface_ != nullptr) write_surface(answer);
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

void CavityExports::write_spheres(const CavityAnswer& answer, const CancelToken& cancel) {
  const CavityTable& table = answer.table();
  std::vector<CavitySpheres> all;
  if (!answer.rows.empty()) {
    const Clearance clearance(*answer.input.prepared().balls);
    for (const std::size_t row : answer.rows) {
      all.push_back({row + 1, filling_spheres(*table.ground, table.cavity(row), clearance,
                                              kMostFillingSpheres, cancel)});
    }
  }
  write_spheres_pqr(all, noted_header(answer), table.ground->balls->lattice.digits, *spheres_);
}

void CavityExports::write_surface(const CavityAnswer& answer) {
  std::vector<Mesh> meshes;
  for (const std::size_t row : answer.rows) {
    CavityMesh mesh =
        cavity_mesh(*answer.table().ground, answer.table().found, answer.table().order[row]);
    meshes.push_back(
        {"cavity " + std::to_string(row + 1) + " (" + answer.kind(row) + ") " + answer.name(row),
         std::move(mesh.points), std::move(mesh.triangles), colour_of(row)});
  }
  const auto write = ends(options_.surface, ".ply") ? write_ply : write_glb;
  write(meshes, noted_header(answer), *surface_, {});
}

void CavityExports::write_script(const CavityAnswer& answer) {
  const Molecule& molecule = answer.input.molecule();
  if (molecule.format != "PDB" && molecule.format != "mmCIF" && molecule.format != "PQR") {
    throw UsageError("--script: ChimeraX and PyMOL do not open " + molecule.format +
                     " files. Give a PDB, mmCIF or PQR file.");
  }
  ViewerScript script{&molecule,
                      fs::absolute(molecule.source),
                      named(options_.spheres),
                      ends(options_.surface, ".glb") ? named(options_.surface) : fs::path(),
                      {},
                      noted_header(answer)};
  const auto& atom_of_ball = answer.input.prepared().atom_of_ball;
  for (const std::size_t row : answer.rows) {
    ScriptCavity cavity{row + 1, colour_of(row), {}};
    for (const BallIndex ball : answer.table().measure(row).lining) {
      cavity.lining.push_back(atom_of_ball[ball]);
    }
    script.cavities.push_back(std::move(cavity));
  }
  try {
    script_->write(ends(options_.script, ".cxc") ? chimerax_script(script) : pymol_script(script));
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
}

}  // namespace alphascope::cli
