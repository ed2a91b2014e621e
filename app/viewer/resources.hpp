// Files that come with the program.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ui/panels/view_state.hpp"

namespace alphascope {

// Those that are there; empty when the program was moved without its resources.
std::vector<SampleMolecule> sample_files();

// A few balls to begin with.
struct SandboxPreset {
  std::string id, title, detail;  // "square", "Square", what it shows
  std::filesystem::path path;
};
std::vector<SandboxPreset> sandbox_presets();  // those that are there

// The folder of lessons; empty likewise.
std::filesystem::path lessons_folder();

}  // namespace alphascope
