// SPDX-License-Identifier: GPL-3.0-or-later
// Finds and loads the library with the GPU engines, and refuses one of another build.
#include "app/session/gpu_engines.hpp"

#include <dlfcn.h>
#include <elf.h>

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/geometry/ball_set.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFileName = "alphascope-gpu.so";
constexpr const char* kVariable = "ALPHASCOPE_GPU_LIBRARY";
constexpr const char* kFallback = " The CPU engine gives the same results.";

// A library that cannot be used. what() is a sentence with the remedy.
struct Unusable : std::runtime_error {
  using std::runtime_error::runtime_error;
};

template <class Function>
Function function_of(void* library, const char* name) {
  return reinterpret_cast<Function>(::dlsym(library, name));
}

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

// Loads a file that exists. It is never unloaded, because results refer to it.
const GpuLibrary& load(const fs::path& file) {
  const std::string named = "The GPU library " + file.string();
  if (!file.is_absolute()) {
    throw Unusable(named + " is not used, because its path is not absolute. Correct or unset " +
                   kVariable + ".");
  }
  if (is_cut_off(file)) throw Unusable(named + " is not complete. Reinstall it.");
  void* const library = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (library == nullptr) {
    const char* const reason = ::dlerror();
    throw Unusable(named + " cannot be loaded (" + (reason != nullptr ? reason : "unknown error") +
                   "). Reinstall it.");
  }
  const auto build = function_of<decltype(&alphascope_gpu_build)>(library, "alphascope_gpu_build");
  const auto table =
      function_of<decltype(&alphascope_gpu_library)>(library, "alphascope_gpu_library");
  if (build == nullptr || table == nullptr) {
    throw Unusable("The file " + file.string() + " is not a GPU library of Alphascope. Install " +
                   kFileName + " anew.");
  }
  if (std::string_view(build()) != gpu_build()) {
    throw Unusable(named + " belongs to another build of Alphascope (" + build() + "; this is " +
                   gpu_build() + "). Install the programs and the library from the same build.");
  }
  return *table();
}

const GpuLibrary& load_first(const std::vector<fs::path>& places) {
  for (const fs::path& file : places) {
    std::error_code ignored;
    if (fs::exists(file, ignored)) return load(file);
  }
  if (std::getenv(kVariable) != nullptr) {
    throw Unusable("No GPU library was found: " + std::string(kVariable) + " names " +
                   (places.empty() ? std::string("nothing") : places.front().string()) +
                   ". Correct or unset it.");
  }
  throw Unusable(std::string("No GPU library was found. Install ") + kFileName +
                 ", or install NVIDIA's CUDA compiler (nvcc) and run scripts/run again.");
}

}  // namespace

const GpuEngines& GpuEngines::of_program() {
  static const GpuEngines engines([] {
    std::error_code ignored;  // an empty path belongs to no installation
    return gpu_library_places(fs::read_symlink("/proc/self/exe", ignored));
  }());
  return engines;
}

GpuEngines::GpuEngines(const std::vector<fs::path>& places) {
  try {
    library_ = &load_first(places);
  } catch (const Unusable& error) {
    none_.why_not = error.what() + std::string(kFallback);
  }
}

const GpuDevice& GpuEngines::device() const {
  return library_ != nullptr ? library_->device() : none_;
}

std::unique_ptr<Engine> GpuEngines::make_engine(std::shared_ptr<const BallSet> balls,
                                                const EngineOptions& options,
                                                std::string& why_not) const {
  if (library_ != nullptr) return make_gpu_engine(*library_, std::move(balls), options, &why_not);
  why_not = none_.why_not;
  return nullptr;
}

std::unique_ptr<Engine> GpuEngines::make_tuple_engine(std::shared_ptr<const BallSet> balls,
                                                      const TupleOptions& tuples,
                                                      std::string& why_not) const {
  if (library_ != nullptr) return library_->make_tuple_engine(std::move(balls), tuples, &why_not);
  why_not = none_.why_not;
  return nullptr;
}

std::vector<fs::path> gpu_library_places(const fs::path& program) {
  if (const char* const named = std::getenv(kVariable)) {
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
    if (rest.empty()) places.push_back(root / ALPHASCOPE_GPU_FOLDER / kFileName);
  }
  return places;
}

}  // namespace alphascope
