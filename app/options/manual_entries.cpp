// SPDX-License-Identifier: GPL-3.0-or-later
// The list of files, variables and pages. tests/manuals/check compares the variables with those
// that the sources read.
#include "app/options/manual_entries.hpp"

namespace alphascope {
namespace {

enum class Read { by_both, by_window, by_command_line };

struct Entry {
  ManualEntry entry;
  Read read = Read::by_both;
};

// Paths in the installation have no / at the beginning.
std::vector<Entry> all_files() {
  return {{{"~/.config/alphascope/preferences.json",
            "Preferences and recent files. XDG_CONFIG_HOME replaces ~/.config"},
           Read::by_window},
          {{ALPHASCOPE_LIBRARY_FOLDER "/alphascope-gpu.so",
            "The GPU engines, below the folder of the installation, such as /usr. Without this "
            "file the CPU engine computes the same results"}},
          {{ALPHASCOPE_LIBRARY_FOLDER "/alphascope-net.so",
            "Fetches molecules by their id, below the same folder"}},
          {{"~/.cache/alphascope",
            "Fetched files, each below its address. XDG_CACHE_HOME replaces ~/.cache"}},
          {{ALPHASCOPE_RESOURCES_FOLDER,
            "Sample molecules, lessons and presets of the sandbox, below the same folder"}},
          {{ALPHASCOPE_DOCS_FOLDER,
            "User guide (docs/guide), formats of files and licences, below the same folder. Help > "
            "User guide shows the guide in the window"}}};
}

std::vector<Entry> all_variables() {
  return {{{"ALPHASCOPE_FETCH_BASE",
            "Address of a server on this computer that takes the place of the public ones, such as "
            "http://127.0.0.1:8080, for tests"}},
          {{"ALPHASCOPE_GPU_LIBRARY",
            "Absolute path of the file with the GPU engines, in place of the installed one. Empty: "
            "no GPU is used"}},
          {{"ALPHASCOPE_GPU_MEMORY",
            "The most memory that the engines take on the GPU, in MB. Without it they take what "
            "there is"}},
          {{"ALPHASCOPE_NET_LIBRARY",
            "Absolute path of the file that fetches molecules, in place of the installed one"}},
          {{"ALPHASCOPE_OFFLINE", "1: nothing is fetched, as with --offline"}},
          {{"DISPLAY, WAYLAND_DISPLAY",
            "The display for the window; not needed with --shot, "
            "--script and --record"},
           Read::by_window},
          {{"HOME", "The user's folder: ~ in typed paths, and the place of .config and .cache"}},
          {{"http_proxy, https_proxy, no_proxy", "Proxies for fetching"}},
          {{"LIBGL_ALWAYS_SOFTWARE", "1: Mesa's OpenGL draws on the CPU"}},
          {{"PATH", "Where ffmpeg is looked for, which writes movies"}},
          {{"TERM", "A line of progress is shown on terminals, but not on one that is \"dumb\""},
           Read::by_command_line},
          {{"XDG_CACHE_HOME", "Folder of fetched files, in place of ~/.cache"}},
          {{"XDG_CONFIG_HOME", "Folder of preferences, in place of ~/.config"}, Read::by_window}};
}

std::vector<ManualEntry> read_by(Read program, const std::vector<Entry>& all) {
  std::vector<ManualEntry> entries;
  for (const Entry& entry : all) {
    if (entry.read == Read::by_both || entry.read == program) entries.push_back(entry.entry);
  }
  return entries;
}

}  // namespace

void add_manual_entries(OptionProgram& program) {
  const Read read = program.commands.empty() ? Read::by_window : Read::by_command_line;
  program.date = ALPHASCOPE_DATE;
  program.files = read_by(read, all_files());
  program.environment = read_by(read, all_variables());
  program.see_also = {read == Read::by_window ? "alphascope-cli(1)" : "alphascope(1)"};
}

}  // namespace alphascope
