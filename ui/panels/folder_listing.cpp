// See the header.
#include "ui/panels/folder_listing.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace alphascope {
namespace {

namespace fs = std::filesystem;

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

bool looks_like_molecule(const fs::path& path) {
  std::string extension = lower(path.extension().string());
  if (extension == ".gz") extension = lower(path.stem().extension().string());
  static constexpr const char* kKnown[] = {".pdb",  ".ent", ".cif", ".mmcif",
                                           ".xyzr", ".pqr", ".xyz", ".crd"};
  return std::any_of(std::begin(kKnown), std::end(kKnown),
                     [&](const char* known) { return extension == known; });
}

FolderListing list_folder(const fs::path& folder, bool all_files) {
  FolderListing listing;
  std::error_code error;
  fs::directory_iterator it(folder, fs::directory_options::skip_permission_denied, error);
  if (error) {
    listing.error = "Cannot read this folder: " + error.message() + ".";
    return listing;
  }
  for (; !error && it != fs::directory_iterator(); it.increment(error)) {
    FolderEntry entry{it->path(), it->path().filename().string(), false, 0};
    if (entry.name.empty() || entry.name.front() == '.') continue;
    std::error_code ignored;
    entry.folder = it->is_directory(ignored);
    if (!entry.folder) {
      if (!it->is_regular_file(ignored)) continue;
      if (!all_files && !looks_like_molecule(entry.path)) {
        ++listing.hidden_by_filter;
        continue;
      }
      entry.bytes = it->file_size(ignored);
      if (ignored) entry.bytes = 0;
    }
    listing.entries.push_back(std::move(entry));
  }
  std::sort(listing.entries.begin(), listing.entries.end(),
            [](const FolderEntry& a, const FolderEntry& b) {
              if (a.folder != b.folder) return a.folder;
              return lower(a.name) < lower(b.name);
            });
  return listing;
}

fs::path sensible_start_folder() {
  std::error_code error;
  const fs::path here = fs::current_path(error);
  if (!error) {
    const FolderListing listing = list_folder(here, false);
    if (std::any_of(listing.entries.begin(), listing.entries.end(),
                    [](const FolderEntry& e) { return !e.folder; })) {
      return here;
    }
  }
  const char* home = std::getenv("HOME");
  if (home != nullptr && fs::is_directory(home, error)) return home;
  return "/";
}

}  // namespace alphascope
