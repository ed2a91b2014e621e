// SPDX-License-Identifier: GPL-3.0-or-later
// Finds resources by their place relative to the running program.
#include "app/viewer/resources.hpp"

#include <utility>

namespace alphascope {
namespace {

namespace fs = std::filesystem;

// The place of a resource, whether it exists or not.
fs::path place_of(const fs::path& name) {
  std::error_code ignored;
  const fs::path self = fs::read_symlink("/proc/self/exe", ignored);
  return (self.parent_path() / ALPHASCOPE_RESOURCES_FROM_PROGRAM / name).lexically_normal();
}

// The path of a file or folder; empty if it is missing. In a build folder the place has a link to
// the source tree, and this is the path there.
fs::path resource(const fs::path& name) {
  std::error_code error;
  const fs::path found = fs::canonical(place_of(name), error);
  return error ? fs::path() : found;
}

}  // namespace

std::vector<SampleMolecule> sample_files() {
  static const SampleMolecule kSamples[] = {
      {"crambin", "1CRN: a small protein, 327 atoms", "molecules/1crn.pdb"},
      {"haemoglobin", "4HHB: four chains with haem, 4,779 atoms", "molecules/4hhb.pdb.gz"}};
  std::vector<SampleMolecule> found;
  for (const SampleMolecule& sample : kSamples) {
    fs::path path = resource(sample.path);
    if (!path.empty()) found.push_back({sample.name, sample.detail, std::move(path)});
  }
  return found;
}

std::vector<SandboxPreset> sandbox_presets() {
  static const SandboxPreset kPresets[] = {
      {"scatter", "Scatter", "24 balls in a plane, of several sizes", {}},
      {"square", "Square", "Four equal balls: two ways to draw the diagonal, so a tie", {}},
      {"circle", "Circle", "Twelve centres on one circle: the largest tie in a plane", {}},
      {"hidden", "Hidden ball", "A ball without a cell: it is in no alpha complex", {}},
      {"equal_centres", "Equal centres", "Balls with the same centre: only the largest counts", {}},
      {"line", "Line", "Centres in a line: no triangle at any alpha", {}},
      {"ring", "Ring", "As alpha grows, the ring closes and then fills", {}},
      {"cube", "Cube, in space", "Eight corners on one sphere: a tie among tetrahedra", {}},
      {"tetrahedra", "Two tetrahedra, in space", "Five balls, one face in common", {}}};
  std::vector<SandboxPreset> found;
  for (SandboxPreset preset : kPresets) {
    preset.path = resource("sandbox/" + preset.id + ".xyzr");
    if (!preset.path.empty()) found.push_back(std::move(preset));
  }
  return found;
}

fs::path lessons_folder() {
  return resource("lessons");
}

fs::path docs_folder() {
  const fs::path found = resource("docs");
  return found.empty() ? place_of("docs") : found;
}

}  // namespace alphascope
