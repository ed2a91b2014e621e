// SPDX-License-Identifier: GPL-3.0-or-later
// Lists folders, and chooses among dropped files.
#include "ui/panels/dialogs/folder_listing.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "core/document/session/session_name.hpp"
#include "core/read/file_format.hpp"
#include "core/text/letter_case.hpp"
#include "ui/number_text.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;

}  // namespace

bool looks_like_molecule(const fs::path& path) {
  return has_molecule_ending(path);
}

namespace {

bool is_shown(const fs::directory_entry& found, const FolderQuery& query, FolderListing& listing,
              FolderEntry& entry) {
  if (entry.name.empty() || (entry.name.front() == '.' && !query.hidden_ones)) return false;
  std::error_code ignored;
  entry.folder = found.is_directory(ignored);
  if (entry.folder) return true;
  if (!found.is_regular_file(ignored)) return false;
  const bool wanted =
      query.sessions ? looks_like_session(entry.path) : looks_like_molecule(entry.path);
  if (!query.all_files && !wanted) {
    ++listing.hidden_by_filter;
    return false;
  }
  entry.bytes = found.file_size(ignored);
  if (ignored) entry.bytes = 0;
  return true;
}

// Sorts folders before files, each by name. Names in small letters are made once, since each
// comparison would make them again.
void sort_entries(std::vector<FolderEntry>& entries) {
  std::vector<std::pair<std::string, std::size_t>> order;
  order.reserve(entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    order.emplace_back((entries[i].folder ? '0' : '1') + lower_case(entries[i].name), i);
  }
  std::sort(order.begin(), order.end());
  std::vector<FolderEntry> sorted;
  sorted.reserve(entries.size());
  for (const auto& [name, i] : order) sorted.push_back(std::move(entries[i]));
  entries = std::move(sorted);
}

}  // namespace

FolderListing list_folder(const FolderQuery& query, const CancelToken& cancel) {
  FolderListing listing;
  listing.query = query;
  std::error_code error;
  fs::directory_iterator it(query.folder, error);
  if (error) {
    listing.error = "Cannot read this folder: " + error.message() + ".";
    return listing;
  }
  for (; !error && it != fs::directory_iterator(); it.increment(error)) {
    cancel.throw_if_cancelled();
    FolderEntry entry{it->path(), it->path().filename().string(), false, 0};
    if (is_shown(*it, query, listing, entry)) listing.entries.push_back(std::move(entry));
  }
  sort_entries(listing.entries);
  return listing;
}

std::size_t find_entry(const FolderListing& listing, std::string_view start, std::size_t from) {
  const std::string wanted = lower_case(start);
  const std::size_t count = listing.entries.size();
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = (from + k) % count;
    const std::string& name = listing.entries[i].name;
    if (lower_case(name.substr(0, wanted.size())) == wanted) return i;
  }
  return count;
}

std::string why_not_openable(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) {
    const fs::path folder = path.parent_path();
    std::error_code ignored;
    if (!folder.empty() && !fs::is_directory(folder, ignored)) {
      return "There is no folder " + folder.string() + ".";
    }
    return "There is no file or folder " + path.string() + ".";
  }
  if (error) return "Cannot open " + path.string() + ": " + error.message() + ".";
  if (status.type() != fs::file_type::regular) return path.string() + " is not a file.";
  if (access(path.c_str(), R_OK) != 0) {
    return "Cannot open " + path.string() + ": you have no permission to read it.";
  }
  return {};
}

DroppedFiles choose_dropped(const std::vector<fs::path>& files) {
  DroppedFiles dropped;
  if (files.empty()) return dropped;
  const auto openable = [](const fs::path& file) {
    return looks_like_molecule(file) || looks_like_session(file);
  };
  const auto found = std::find_if(files.begin(), files.end(), openable);
  const auto chosen = found == files.end() ? files.begin() : found;
  dropped.opened = *chosen;
  if (files.size() == 1) return dropped;
  constexpr std::size_t kNamed = 8;
  dropped.note = "Opened: " + chosen->filename().string() + "\n";
  std::size_t others = 0;
  for (auto it = files.begin(); it != files.end(); ++it) {
    if (it == chosen || ++others > kNamed) continue;
    dropped.note += "Not opened: " + it->filename().string() +
                    (openable(*it) ? "" : " (its name is not that of a molecule)") + "\n";
  }
  if (others > kNamed) {
    dropped.note += "and " + std::to_string(others - kNamed) + " more that are not opened\n";
  }
  dropped.note += "The window shows one molecule at a time.";
  return dropped;
}

std::string file_size_text(std::uintmax_t bytes) {
  const double value = static_cast<double>(bytes);
  for (const auto& [unit, name] : {std::pair{1e9, " GB"}, {1e6, " MB"}, {1e3, " kB"}}) {
    if (value < 0.9995 * unit) continue;
    return number_text(value / unit, value < 99.95 * unit ? 1 : 0) + name;
  }
  return number_text(value, 0) + (bytes == 1 ? " byte" : " bytes");
}

fs::path sensible_start_folder() {
  std::error_code error;
  fs::path here = fs::current_path(error);
  if (!error) {
    for (fs::directory_iterator it(here, error), end; !error && it != end; it.increment(error)) {
      if (looks_like_molecule(it->path())) return here;
    }
  }
  const char* home = std::getenv("HOME");
  if (home != nullptr && fs::is_directory(home, error)) return home;
  return "/";
}

}  // namespace alphascope
