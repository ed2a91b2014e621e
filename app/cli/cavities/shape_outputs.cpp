// SPDX-License-Identifier: GPL-3.0-or-later
// Options and names of the files with shapes.
#include "app/cli/cavities/shape_outputs.hpp"

#include "app/cli/failure.hpp"
#include "core/files/output_ending.hpp"
#include "core/molecule/molecule.hpp"

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

fs::path named(const std::string& path) {
  return path.empty() || path == "-" ? fs::path() : fs::absolute(path);
}

}  // namespace

Options shape_options(ShapeOptions& options, const char* spheres, const char* surface,
                      const char* script) {
  return {text_option({"--spheres", "OUT.pqr", spheres}, options.spheres),
          text_option({"--surface", "OUT.ply|OUT.glb", surface}, options.surface),
          text_option({"--script", "OUT.cxc|OUT.pml", script}, options.script)};
}

ShapeOutputs::ShapeOutputs(const ShapeOptions& options, const std::string& molecule,
                           Outputs& outputs)
    : options_(options) {
  require_ending("--surface", options.surface, ".ply", ".glb");
  require_ending("--script", options.script, ".cxc", ".pml");
  if (!options.script.empty() && molecule == "-") {
    throw UsageError(
        "--script needs the molecule as a file, not standard input. Save the input to a file "
        "first.");
  }
  spheres_ = outputs.add("--spheres", options.spheres, {".pqr"});
  surface_ = outputs.add("--surface", options.surface, {".ply", ".glb"});
  script_ = outputs.add("--script", options.script, {".cxc", ".pml"});
}

bool ShapeOutputs::surface_is_glb() const {
  return ends(options_.surface, ".glb");
}

ShapeExport ShapeOutputs::script_format() const {
  return ends(options_.script, ".cxc") ? ShapeExport::chimerax : ShapeExport::pymol;
}

ShapeScriptFiles ShapeOutputs::script_files() const {
  return {named(options_.spheres), surface_is_glb() ? named(options_.surface) : fs::path()};
}

void ShapeOutputs::require_openable(const Molecule& molecule) const {
  if (script_ == nullptr) return;
  const std::string why = why_no_script(molecule);
  if (!why.empty()) throw UsageError("--script: " + why);
}

}  // namespace alphascope::cli
