// Looks beside an installed executable first, then in the source tree that it was built from.
#include "app/viewer/resources.hpp"

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

}  // namespace

std::vector<SampleMolecule> sample_files() {
  static const SampleMolecule kSamples[] = {
      {"crambin", "1CRN: a small protein, 327 atoms", "molecules/1crn.pdb"},
      {"haemoglobin", "4HHB: four chains with haem, 4,779 atoms", "molecules/4hhb.pdb.gz"}};
  std::vector<SampleMolecule> found;
  for (const SampleMolecule& sample : kSamples) {
    for (const fs::path& folder : resource_folders()) {
      std::error_code ignored;
      if (!fs::is_regular_file(folder / sample.path, ignored)) continue;
      found.push_back({sample.name, sample.detail, folder / sample.path});
      break;
    }
  }
  return found;
}

}  // namespace alphascope
