// SPDX-License-Identifier: GPL-3.0-or-later
// Finds and loads the program's own libraries, which it needs for some work only: the GPU engines
// and the transfer from servers. One that is damaged or of another build is refused.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace alphascope {

// All texts live as long as the program.
struct LibraryKind {
  const char* file_name;     // "alphascope-gpu.so"
  const char* variable;      // of the environment, with another absolute path
  const char* title;         // "GPU library"
  const char* build_symbol;  // a function without arguments that returns library_build()
  const char* table_symbol;
  const char* if_missing;  // a sentence: how to get the library
};

// A library that cannot be used. what() is a sentence with the remedy.
struct UnusableLibrary : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Returns absolute paths at which the library of an executable may be. The environment variable of
// the kind replaces them all by one path; if it is empty, there is none. Otherwise the library
// belongs to the installation of which `program` is a part; a build folder has the same layout.
std::vector<std::filesystem::path> library_places(const LibraryKind& kind,
                                                  const std::filesystem::path& program);
// The same for the running program.
std::vector<std::filesystem::path> library_places(const LibraryKind& kind);

// Loads the first of these files that exists, and returns the address of its table_symbol. If that
// file cannot be used, later ones are not tried. The library is never unloaded. Throws
// UnusableLibrary.
void* load_library(const LibraryKind& kind, const std::vector<std::filesystem::path>& places);

}  // namespace alphascope
