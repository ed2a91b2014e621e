// SPDX-License-Identifier: GPL-3.0-or-later
// Lists a folder for the file dialog, and chooses among files. Uses std::filesystem, no ImGui.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/run/cancel_token.hpp"

namespace alphascope {

struct FolderEntry {
  std::filesystem::path path;
  std::string name;
  bool folder = false;
  std::uintmax_t bytes = 0;
};

// Which folder is to be listed, and which of its entries.
struct FolderQuery {
  std::filesystem::path folder;
  bool all_files = false;    // also files that look neither like molecules nor like sessions
  bool hidden_ones = false;  // also names that start with a dot
  bool sessions = false;     // sessions instead of molecules
  friend bool operator==(const FolderQuery&, const FolderQuery&) = default;
};

struct FolderListing {
  FolderQuery query;                 // the query that this answers
  std::vector<FolderEntry> entries;  // folders first, then by name without regard to case
  // Number of files that are not listed because of their names.
  std::size_t hidden_by_filter = 0;
  std::string error;  // why the folder cannot be read; empty otherwise
};

// Whether the name ends as a format's names do (core/read/file_format.hpp), with or without .gz.
bool looks_like_molecule(const std::filesystem::path& path);

// Lists a folder. This can take seconds for a large folder or a slow disk. Throws Cancelled.
FolderListing list_folder(const FolderQuery& query, const CancelToken& cancel = {});

// Returns the first entry from `from` on, and around the end, whose name starts with `start`. Case
// is ignored. Returns the number of entries if there is none.
std::size_t find_entry(const FolderListing& listing, std::string_view start, std::size_t from);

// Returns a sentence on why the typed path cannot be opened; empty if it can.
std::string why_not_openable(const std::filesystem::path& path);

// The choice among files dropped at once: the first that looks like a molecule or session, else the
// first.
struct DroppedFiles {
  std::optional<std::filesystem::path> opened;
  std::string note;  // names the opened file and the others, with the reason; empty for one file
};
DroppedFiles choose_dropped(const std::vector<std::filesystem::path>& files);

// "1.2 MB": with one digit more than sizes of memory.
std::string file_size_text(std::uintmax_t bytes);

// Returns the present folder if it holds molecules, else the home folder, else "/".
std::filesystem::path sensible_start_folder();

}  // namespace alphascope
