// What a file browser shows of a folder. Pure std::filesystem, no ImGui.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace alphascope {

struct FolderEntry {
  std::filesystem::path path;
  std::string name;
  bool folder = false;
  std::uintmax_t bytes = 0;
};

struct FolderListing {
  std::vector<FolderEntry> entries;  // folders first, then by name without regard to case
  std::size_t hidden_by_filter = 0;  // files that do not look like molecules
  std::string error;                 // why the folder cannot be read; empty otherwise
};

// .pdb .ent .cif .xyzr .pqr .xyz .crd, each also with .gz, in any case.
bool looks_like_molecule(const std::filesystem::path& path);

// Entries whose name starts with a dot are left out.
FolderListing list_folder(const std::filesystem::path& folder, bool all_files);

// The present folder when it holds molecules, else the home folder, else "/".
std::filesystem::path sensible_start_folder();

}  // namespace alphascope
