// The options of commands that write shapes for other programs, of cavities or of a channel.
#pragma once

#include <string>

#include "app/cli/option_groups.hpp"
#include "app/cli/outputs.hpp"
#include "core/document/export/shape_export.hpp"

namespace alphascope::cli {

// Files for other programs; empty: not wanted.
struct ShapeOptions {
  std::string spheres, surface, script;
  bool any() const { return !spheres.empty() || !surface.empty() || !script.empty(); }
};

// --spheres, --surface and --script; the texts say what of.
Options shape_options(ShapeOptions& options, const char* spheres, const char* surface,
                      const char* script);

// Opened before anything is computed; null is not asked for.
class ShapeOutputs {
 public:
  // `molecule`: the file as it was named. Throws UsageError for a name with another ending than
  // there are formats and for a script of standard input; and what Outputs::add() throws.
  ShapeOutputs(const ShapeOptions& options, const std::string& molecule, Outputs& outputs);

  // Before anything is computed: throws UsageError where a script is asked for of a molecule that
  // other programs do not open.
  void require_openable(const Molecule& molecule) const;

  AtomicFile* spheres() const { return spheres_; }
  AtomicFile* surface() const { return surface_; }
  AtomicFile* script() const { return script_; }

  bool surface_is_glb() const;
  ShapeExport script_format() const;
  // What the script opens: no result on standard output, which has no name.
  ShapeScriptFiles script_files() const;

 private:
  const ShapeOptions& options_;
  AtomicFile *spheres_, *surface_, *script_;
};

}  // namespace alphascope::cli
