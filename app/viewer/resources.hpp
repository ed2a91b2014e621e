// Files that come with the program.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace alphascope {

struct SampleFile {
  std::string name, detail;
  std::filesystem::path path;
};

// Those that are there; empty when the program was moved without its resources.
std::vector<SampleFile> sample_files();

}  // namespace alphascope
