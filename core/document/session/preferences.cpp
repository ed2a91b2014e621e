// SPDX-License-Identifier: GPL-3.0-or-later
// Reads, merges and writes the file of preferences.
#include "core/document/session/preferences.hpp"

#include <algorithm>

#include "core/document/session/json_fields.hpp"
#include "core/files/atomic_file.hpp"
#include "core/files/read_error.hpp"
#include "core/files/user_folder.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/radii/radii_set.hpp"
#include "core/selection/selection_expression.hpp"
#include "core/text_files/text_file.hpp"

namespace alphascope {

namespace fs = std::filesystem;

namespace {

constexpr const char* kVersionName = "alphascope_preferences";
constexpr const char* kFileName = "preferences.json";
constexpr std::uint64_t kMostBytes = 1 << 20;
constexpr const char* kRemedy =
    "Correct or remove the file; without it, the program starts with its defaults";
constexpr NumberRule kScaleRule{"The scale", 0, kControlScaleRule.most};
constexpr NumberRule kWindowRule{"The size", 480, 16384, "pixels", true};

template <class Visitor>
void visit_fields(Visitor& v, Preferences& p) {
  v("light_theme", p.light_theme);
  v("scale", p.scale, kScaleRule);
  v("presenter_size", p.presenter_size);
  v("glide", p.glide);
  v("width", p.width, kWindowRule);
  v("height", p.height, kWindowRule);
  v("engine", p.engine);
  v("page", p.page);
  v("last_folder", p.last_folder);
  v("recent_files", p.recent);
}

WrittenJson to_json(Preferences preferences) {
  WrittenJson json;
  FieldWriter writer(json);
  visit_fields(writer, preferences);
  return json;
}

// Null if there is no file.
ReadJson read_file(const fs::path& file, std::string& text) {
  std::error_code ignored;
  if (fs::status(file, ignored).type() == fs::file_type::not_found) return nullptr;
  const LoadedText loaded = load_text(file, kMostBytes, {}, {}, FileKind::preferences);
  text = loaded.text;
  const ReadJson json = parse_json_object(file, text, "file of preferences", kRemedy);
  if (json.contains(kVersionName)) return json;
  throw ReadError(
      file, 0, std::string("this is not a file of preferences: it has no \"") + kVersionName + "\"",
      kRemedy);
}

Preferences take_preferences(const ReadJson& json, JsonFindings& findings) {
  Preferences preferences;
  FieldReader reader(json, {}, findings);
  visit_fields(reader, preferences);
  auto& recent = preferences.recent;
  std::erase_if(recent, [](const fs::path& path) { return !path.is_absolute(); });
  recent.resize(std::min(recent.size(), kMostRecentFiles));
  return preferences;
}

bool is_subsequence(const fs::path* from, const fs::path* end, const std::vector<fs::path>& of) {
  for (const fs::path& path : of) {
    if (from != end && *from == path) ++from;
  }
  return from == end;
}

bool contains(const std::vector<fs::path>& list, const fs::path& path) {
  return std::find(list.begin(), list.end(), path) != list.end();
}

// The recent files to write: those that this window has opened since it read `before`, then those
// that are in the file now. Left out are files that this window has removed from the list.
std::vector<fs::path> merged_recent(const std::vector<fs::path>& before,
                                    const std::vector<fs::path>& now,
                                    const std::vector<fs::path>& file) {
  std::size_t added = 0;
  while (!is_subsequence(now.data() + added, now.data() + now.size(), before)) ++added;
  std::vector<fs::path> merged(now.begin(), now.begin() + static_cast<std::ptrdiff_t>(added));
  for (const fs::path& path : file) {
    const bool taken_out = contains(before, path) && !contains(now, path);
    if (!taken_out && !contains(merged, path)) merged.push_back(path);
  }
  merged.resize(std::min(merged.size(), kMostRecentFiles));
  return merged;
}

}  // namespace

fs::path preferences_folder() {
  return user_folder("XDG_CONFIG_HOME", ".config");
}

ReadPreferences read_preferences(const fs::path& folder) {
  ReadPreferences read;
  const fs::path file = folder / kFileName;
  try {
    std::string text;
    const ReadJson json = read_file(file, text);
    if (json.is_null()) return read;
    JsonFindings findings;
    read.preferences = take_preferences(json, findings);
    for (const JsonFindings::Wrong& wrong : findings.wrong) {
      const ReadError error(file, line_of(text, wrong.place),
                            "\"" + place_text(wrong.place) + "\" " + wrong.reason, "");
      read.problem += (read.problem.empty() ? "" : "\n") + std::string(error.what());
    }
    if (!read.problem.empty())
      read.problem += "\nThe value is ignored; all other preferences are used.";
  } catch (const std::exception& error) {
    read.problem = std::string(error.what()) +
                   " The program works without preferences, and leaves the file as it is.";
    read.keep_file = true;
  }
  return read;
}

void save_preferences(const fs::path& folder, const Preferences& before, const Preferences& now) {
  if (before == now) return;
  make_output_folder(folder);
  const fs::path file = folder / kFileName;
  std::string text;
  ReadJson on_disk = read_file(file, text);
  if (on_disk.is_null()) on_disk = ReadJson::object();
  JsonFindings ignored;
  Preferences wanted = now;
  wanted.recent =
      merged_recent(before.recent, now.recent, take_preferences(on_disk, ignored).recent);
  const WrittenJson old_values = to_json(before), new_values = to_json(wanted);
  WrittenJson json;
  json[kVersionName] = 1;
  for (const auto& [name, value] : on_disk.items()) json[name] = WrittenJson::parse(value.dump());
  for (const auto& [name, value] : new_values.items()) {
    if (!json.contains(name) || old_values[name] != value) json[name] = value;
  }
  AtomicFile written(file, FileKind::preferences);
  written.write(json_file_text(json));
  written.commit();
}

void note_recent(Preferences& preferences, const fs::path& file) {
  std::error_code error;
  const fs::path absolute = fs::absolute(file, error).lexically_normal();
  if (error) return;
  auto& recent = preferences.recent;
  std::erase(recent, absolute);
  recent.insert(recent.begin(), absolute);
  recent.resize(std::min(recent.size(), kMostRecentFiles));
}

}  // namespace alphascope
