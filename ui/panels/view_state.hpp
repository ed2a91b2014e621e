// Everything that panels and program exchange, as plain data: what is shown, settings and requests.
// Panels know nothing else of the program.
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/document/export/export_request.hpp"
#include "core/document/export/program_name.hpp"
#include "core/document/reference/ref_set.hpp"
#include "core/document/settings/settings.hpp"
#include "core/engine/cold_and_warm.hpp"
#include "core/engine/gpu_device.hpp"
#include "core/geometry/real_point.hpp"
#include "core/selection/selection_error.hpp"
#include "ui/layer.hpp"
#include "ui/panels/cavities/cavity_state.hpp"
#include "ui/panels/dialogs/benchmark_info.hpp"
#include "ui/panels/dialogs/folder_listing.hpp"
#include "ui/panels/dialogs/picture_requests.hpp"
#include "ui/panels/dialogs/save_state.hpp"
#include "ui/panels/dialogs/table_state.hpp"
#include "ui/panels/explain/steps_state.hpp"
#include "ui/panels/frame/context_state.hpp"
#include "ui/panels/frame/palette_state.hpp"
#include "ui/panels/lessons/lesson_state.hpp"
#include "ui/panels/playback.hpp"
#include "ui/panels/sandbox/sandbox_state.hpp"
#include "ui/panels/view_info.hpp"
#include "ui/panels/viewport_info.hpp"
#include "ui/panels/window_settings.hpp"
#include "ui/running_job.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/key_state.hpp"

namespace alphascope {

class BallReferences;
struct Answer;

struct SampleMolecule {
  std::string name, detail;  // "Crambin", "1CRN · 327 atoms"
  std::filesystem::path path;
};

// A session whose files have changed since it was saved.
struct SessionProblem {
  std::string session, text;  // its path; the message to the user
  bool molecule = false;      // the user may choose another molecule
  bool can_open = false;      // the session can be opened with the files as they are
};

inline constexpr double kTooltipDelaySeconds = 0.4;
// Most balls for which the window compares with CGAL after each change. With more, CGAL would
// occupy the cores for long.
inline constexpr std::size_t kMostBallsToCompareUnasked = 200000;

enum class BrowserPurpose : std::uint8_t { molecule, radii_table, session, session_molecule, save };

struct SharedPanelState;
// Returns the folder that the file dialog wants listed; nothing while the dialog is closed.
std::optional<FolderQuery> wanted_listing(const SharedPanelState& memory);

// Text that was typed into a field and that the field refused.
struct RefusedNumber {
  std::string text, error;
  std::string value;  // value of the field before
  int frame = 0;      // the last frame in which the field was drawn
  bool told = true;   // shown below the field, until a click elsewhere
};

// The number that the user is typing.
struct NumberTyping {
  std::string name;  // name of the field; empty: none
  std::string text;
  bool focus = false;                            // the field is to get the keyboard focus
  std::map<std::string, RefusedNumber> refused;  // by name of the field
};

// The state between frames that no panel owns alone.
struct SharedPanelState {
  bool show_cheat_sheet = false, show_about = false, show_browser = false, show_save = false;
  bool show_benchmark = false, show_export = false, show_save_session = false;
  std::filesystem::path browser_folder;  // empty: the program chooses one
  std::filesystem::path browser_base;    // base of relative paths that are typed
  std::string browser_typed;
  bool browser_by_hand = false;  // the user typed browser_typed; else it is the chosen entry's path
  std::string browser_begun;     // first letters of a name; the first entry with them gets chosen
  std::filesystem::path browser_selected;
  bool browser_all_files = false, browser_hidden_ones = false;
  std::string browser_error;        // why the typed path cannot be opened
  std::string browser_jump;         // letters typed in the list, to jump to a name
  double browser_jump_seconds = 0;  // time of the last such letter, by ImGui's clock
  bool browser_scroll = false;      // the list is to be scrolled to the chosen entry
  BrowserPurpose browser_purpose = BrowserPurpose::molecule;
  SaveState saving;
  std::string save_path;
  RecordState record;
  std::string export_path;
  ExportColours export_colours = ExportColours::element;
  std::string session_path;  // path to save the session to
  NumberTyping number;
  KeyState keys;
  SandboxState sandbox;
  TableState save_table;
  // Open dialogs, as indices into the list of dialog_stack.cpp. The last is on top.
  std::vector<std::size_t> dialogs;
  bool dragging_view = false;
  HandlePart clip_part = HandlePart::none,
             clip_part_hovered = HandlePart::none;  // held by the mouse, and under it or held
  std::string expression_typed;
  bool expression_entered = false;  // the user entered it, and no answer is shown yet
  std::string expression_shown;     // the selection from which expression_typed was last filled
  std::string confirm_assembly;     // id of the assembly that the dialog asks about; empty: none
  std::string reveal;               // a widget to be scrolled into sight, for scripts
  std::string go_to_section;  // id of a section at the left, to be opened and scrolled to the top
  bool sections_overflow = false;  // the sections at the left do not fit
  double mouse_still_seconds = 0;  // since the mouse moved or a button was down
  float mouse_x = 0, mouse_y = 0;  // pixels, in the last frame
};

struct ViewState {
  // Settings for the open file. The panels change them, and the history notes changes once a frame.
  Settings settings;
  std::optional<Ref> hovered;  // thing under the mouse in the picture
  // The selection followed the atoms that line the chosen cavities. The history makes no entry of
  // such a change, and resets this flag.
  bool selection_followed = false;
  WindowSettings window;
  Playback playback;
  LessonState lessons;
  StepsState steps;
  CavityState cavities;
  PaletteState palette;
  ContextState context;

  MoleculeInfo molecule;
  std::shared_ptr<const Answer> result;  // on screen; null: none. Settings may be newer
  std::string pending;  // the complex that is computed and still being drawn; empty: none
  ColdAndWarm ours, cgal, cgal_parallel;             // cgal_parallel: with all threads
  std::shared_ptr<const BallReferences> references;  // to the balls on screen; null: none
  std::string selected_count_text;                   // number of selected items; empty: none
  std::size_t selected_missing = 0;  // number of selected items that are not in the picture
  BadgeInfo badge;
  BenchmarkSettings benchmark_settings;
  BenchmarkInfo benchmark;
  // The folder in the file dialog. While a folder is being read, this is the one before. Null: none
  // yet.
  std::shared_ptr<const FolderListing> listing;
  RunningJobs jobs;  // all that runs and takes long
  BackgroundInfo background;
  Layers layers;                 // layers that the panels want drawn; made anew in each frame
  bool measures_wanted = false;  // areas and volumes are shown; set anew in each frame
  ViewportInfo viewport;
  std::string device_text;       // "CPU · 2 threads"
  std::optional<GpuDevice> gpu;  // empty: the search has not ended
  std::string engine_note;       // why another engine than expected was used; empty: none was
  std::string version;
  ProgramName program;           // as files that are written name it
  std::size_t memory_bytes = 0;  // memory of the whole program
  std::uint64_t free_bytes = 0;  // memory that the machine could still give; 0: unknown
  std::optional<SelectionError> expression_error;  // why the typed expression was refused
  std::string error_title, error;                  // shown in a dialog until dismissed
  // Titles and texts of the errors that come next.
  std::deque<std::pair<std::string, std::string>> more_errors;
  std::string compute_error;  // why the present alpha has no complex; one line over the view
  // Lines that name the opened one of several dropped files. They stay until they are dismissed or
  // another file is opened.
  std::string drop_note;
  std::string notice;                // one line in the status bar: "saved /tmp/a.png"
  std::string undo_text, redo_text;  // the change in words: "alpha"; empty: none
  std::vector<SampleMolecule> samples;
  std::vector<std::filesystem::path> recent;  // files, the latest first
  std::optional<SessionProblem> session_problem;
  // The session opened or saved last for this molecule; may be empty.
  std::filesystem::path session_file;

  SharedPanelState memory;

  // Shows an error in a dialog, after earlier ones that are not dismissed yet. To be used for
  // single requests of the user, since a slider must not open a dialog at each step.
  void show_error(const std::string& title, const std::string& text) {
    const std::pair<std::string, std::string> news{title, text};
    if (error.empty()) {
      std::tie(error_title, error) = news;
    } else if (error != text && (more_errors.empty() || more_errors.back() != news)) {
      more_errors.push_back(news);
    }
  }
};

// Whether a GPU was found that engines can use.
inline bool has_gpu(const ViewState& state) {
  return state.gpu && state.gpu->usable;
}

}  // namespace alphascope
