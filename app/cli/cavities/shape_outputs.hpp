// SPDX-License-Identifier: GPL-3.0-or-later
// Options of commands that write the shapes of cavities or channels for other programs.
#pragma once

#include <string>

#include "app/cli/option_groups.hpp"
#include "app/cli/outputs.hpp"
#include "core/document/export/shape_export.hpp"

namespace alphascope::cli {

// Paths of files for other programs; empty: not requested.
struct ShapeOptions {
  std::string spheres, surface, script;
  bool any() const { return !spheres.empty() || !surface.empty() || !script.empty(); }
};

// The options --spheres, --surface and --script, with these help texts.
Options shape_options(ShapeOptions& options, const char* spheres, const char* surface,
                      const char* script);

// The files are opened before the computation. Null: not requested.
class ShapeOutputs {
 public:
  // `molecule`: the path as it was given. Throws UsageError for an unknown ending and for a script
  // of standard input, and as Outputs::add() does.
  ShapeOutputs(const ShapeOptions& options, const std::string& molecule, Outputs& outputs);

  // Call before the computation. Throws UsageError if a script is requested for a molecule that
  // other programs cannot open.
  void require_openable(const Molecule& molecule) const;

  AtomicFile* spheres() const { return spheres_; }
  AtomicFile* surface() const { return surface_; }
  AtomicFile* script() const { return script_; }

  bool surface_is_glb() const;
  ShapeExport script_format() const;
  // The files that the script opens. A file on standard output has no name and is left out.
  ShapeScriptFiles script_files() const;

 private:
  const ShapeOptions& options_;
  AtomicFile *spheres_, *surface_, *script_;
};

}  // namespace alphascope::cli
