// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the files that come with the program: samples, presets of the sandbox, lessons, docs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ui/panels/view_state.hpp"

namespace alphascope {

// The sample files that exist. Empty if the program was moved without its resources.
std::vector<SampleMolecule> sample_files();

// A preset of the sandbox: a few balls to start from.
struct SandboxPreset {
  std::string id, title, detail;  // for example "square", "Square", a sentence on what it shows
  std::filesystem::path path;
};
std::vector<SandboxPreset> sandbox_presets();  // the presets whose files exist

// The folder of lessons. Empty if the program was moved without its resources.
std::filesystem::path lessons_folder();

// The folder of docs, or the place where it would be if it is missing.
std::filesystem::path docs_folder();

}  // namespace alphascope
