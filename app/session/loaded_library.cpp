// SPDX-License-Identifier: GPL-3.0-or-later
// Finds and loads the program's own libraries, and refuses those of another build.
#include "app/session/loaded_library.hpp"

#include <dlfcn.h>
#include <elf.h>

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <string_view>
#include <system_error>

#include "core/run/library_build.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;

// Whether the file ends before the parts that its own header names. The dynamic linker maps such a
// file, and the program then dies by a bus error. Any other damage is left to the linker.
bool is_cut_off(const fs::path& file) {
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  const std::streamoff end = in.tellg();
  const auto has = [&](std::uint64_t offset, std::uint64_t bytes) {
    const auto size = static_cast<std::uint64_t>(end);
    return offset <= size && bytes <= size - offset;
  };
  const auto read = [&](auto& part, std::uint64_t offset) {
    in.seekg(static_cast<std::streamoff>(offset));
    return static_cast<bool>(in.read(reinterpret_cast<char*>(&part), sizeof part));
  };
  Elf64_Ehdr header{};
  if (end < 0 || !read(header, 0) || header.e_ident[EI_CLASS] != ELFCLASS64) return false;
  if (!has(header.e_shoff, std::uint64_t{header.e_shnum} * sizeof(Elf64_Shdr))) return true;
  for (std::uint64_t n = 0; n < header.e_phnum; ++n) {
    Elf64_Phdr part{};
    if (!read(part, header.e_phoff + n * sizeof part)) return true;
    if (!has(part.p_offset, part.p_filesz)) return true;
  }
  return false;
}

// Loads a file that exists.
void* load(const LibraryKind& kind, const fs::path& file) {
  const std::string named = "The " + std::string(kind.title) + " " + file.string();
  if (!file.is_absolute()) {
    throw UnusableLibrary(named +
                          " is not used, because its path is not absolute. Correct or unset " +
                          kind.variable + ".");
  }
  if (is_cut_off(file)) throw UnusableLibrary(named + " is not complete. Reinstall it.");
  void* const library = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (library == nullptr) {
    const char* const reason = ::dlerror();
    throw UnusableLibrary(named + " cannot be loaded (" +
                          (reason != nullptr ? reason : "unknown error") + "). Reinstall it.");
  }
  const auto build =
      reinterpret_cast<decltype(&library_build)>(::dlsym(library, kind.build_symbol));
  void* const table = ::dlsym(library, kind.table_symbol);
  if (build == nullptr || table == nullptr) {
    throw UnusableLibrary("The file " + file.string() + " is not a " + kind.title +
                          " of Alphascope. Install " + kind.file_name + " anew.");
  }
  if (std::string_view(build()) != library_build()) {
    throw UnusableLibrary(named + " belongs to another build of Alphascope (" + build() +
                          "; this is " + library_build() +
                          "). Install the programs and the library from the same build.");
  }
  return table;
}

}  // namespace

void* load_library(const LibraryKind& kind, const std::vector<fs::path>& places) {
  for (const fs::path& file : places) {
    std::error_code ignored;
    if (fs::exists(file, ignored)) return load(kind, file);
  }
  const std::string missing = "No " + std::string(kind.title) + " was found";
  if (std::getenv(kind.variable) != nullptr) {
    throw UnusableLibrary(missing + ": " + kind.variable + " names " +
                          (places.empty() ? std::string("nothing") : places.front().string()) +
                          ". Correct or unset it.");
  }
  throw UnusableLibrary(missing + ". " + kind.if_missing);
}

std::vector<fs::path> library_places(const LibraryKind& kind, const fs::path& program) {
  if (const char* const named = std::getenv(kind.variable)) {
    if (*named == '\0') return {};
    return {named};
  }
  // Programs are in one of two folders of an installation. The part of the path before that folder
  // is the installation's root.
  std::vector<fs::path> places;
  for (const fs::path own : {ALPHASCOPE_PROGRAM_FOLDER, ALPHASCOPE_DRAWING_PROGRAM_FOLDER}) {
    fs::path root = program.parent_path();
    fs::path rest = own;
    while (!rest.empty() && root.filename() == rest.filename()) {
      root = root.parent_path();
      rest = rest.parent_path();
    }
    if (rest.empty()) places.push_back(root / ALPHASCOPE_LIBRARY_FOLDER / kind.file_name);
  }
  return places;
}

std::vector<fs::path> library_places(const LibraryKind& kind) {
  std::error_code ignored;  // an empty path belongs to no installation
  return library_places(kind, fs::read_symlink("/proc/self/exe", ignored));
}

}  // namespace alphascope
