// Finds resources beside an installed executable first, then in the source tree of the build.
#include "app/viewer/resources.hpp"

#include <utility>

namespace alphascope {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> resource_folders() {
  std::vector<fs::path> folders;
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  if (!error) {
    folders.push_back((self.parent_path() / ALPHASCOPE_INSTALLED_RESOURCES).lexically_normal());
  }
  folders.emplace_back(ALPHASCOPE_RESOURCES);
  return folders;
}

// The path of the file; empty if no folder has it.
fs::path resource(const fs::path& name) {
  for (const fs::path& folder : resource_folders()) {
    std::error_code ignored;
    if (fs::is_regular_file(folder / name, ignored)) return folder / name;
  }
  return {};
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
  for (const fs::path& folder : resource_folders()) {
    std::error_code ignored;
    if (fs::is_directory(folder / "lessons", ignored)) return folder / "lessons";
  }
  return {};
}

}  // namespace alphascope
