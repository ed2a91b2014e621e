// Everything between the panels and the program, as plain data: what is shown, what was set, what
// was asked for. Panels know nothing else.
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

#include "core/document/export/complex_export.hpp"
#include "core/document/export/record_source.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/settings/settings.hpp"
#include "core/document/store/answer.hpp"
#include "core/engine/cold_and_warm.hpp"
#include "core/engine/gpu_device.hpp"
#include "core/geometry/real_point.hpp"
#include "core/selection/selection_expression.hpp"
#include "ui/layer.hpp"
#include "ui/panels/cavities/cavity_memory.hpp"
#include "ui/panels/dialogs/benchmark_info.hpp"
#include "ui/panels/dialogs/folder_listing.hpp"
#include "ui/panels/dialogs/picture_memory.hpp"
#include "ui/panels/dialogs/save_memory.hpp"
#include "ui/panels/dialogs/table_memory.hpp"
#include "ui/panels/explain/steps_memory.hpp"
#include "ui/panels/frame/context_memory.hpp"
#include "ui/panels/frame/palette_memory.hpp"
#include "ui/panels/lessons/lesson_memory.hpp"
#include "ui/panels/playback.hpp"
#include "ui/panels/sandbox/sandbox_memory.hpp"
#include "ui/panels/view_info.hpp"
#include "ui/panels/window_settings.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/controls.hpp"
#include "ui/widgets/key_memory.hpp"

namespace alphascope {

struct SampleMolecule {
  std::string name, detail;  // "Crambin", "1CRN · 327 atoms"
  std::filesystem::path path;
};

// A session was read whose files are not as they were when it was saved.
struct SessionProblem {
  std::string session, text;  // its path; what is told
  bool molecule = false;      // another may be chosen
  bool can_open = false;      // with the files as they are
};

inline constexpr double kTooltipDelaySeconds = 0.4;
// Comparing by itself is switched off beyond: CGAL would keep the second half of the cores busy.
inline constexpr std::size_t kMostBallsToCompareUnasked = 200000;

enum class BrowserPurpose : std::uint8_t { molecule, radii_table, session, session_molecule, save };

struct PanelMemory;
// What the file dialog wants to have listed; nothing while it is closed.
std::optional<FolderQuery> wanted_listing(const PanelMemory& memory);

// What was typed and is no number that its field takes.
struct RefusedNumber {
  std::string text, error;
  std::string value;  // that the field had
  int frame = 0;      // in which the field was last there
  bool told = true;   // below the field, until a click elsewhere
};

// The number that is being typed.
struct NumberTyping {
  std::string name;  // of the field; empty: none
  std::string text;
  bool focus = false;                            // to be given to the field
  std::map<std::string, RefusedNumber> refused;  // by field
};

// What the panels remember between frames.
struct PanelMemory {
  bool show_cheat_sheet = false, show_about = false, show_browser = false, show_save = false;
  bool show_benchmark = false, show_export = false, show_save_session = false;
  std::filesystem::path browser_folder;  // empty: choose a sensible one
  std::filesystem::path browser_base;    // that what is typed is relative to
  std::string browser_typed;
  bool browser_by_hand = false;  // typed, and not the name of what is chosen in the list
  std::string browser_begun;     // the beginning of a name: the first such is to be chosen
  std::filesystem::path browser_selected;
  bool browser_all_files = false, browser_hidden_ones = false;
  std::string browser_error;        // why what was typed cannot be opened
  std::string browser_jump;         // what was typed to jump to a name, and when the last letter
  double browser_jump_seconds = 0;  // of it came (ImGui's time)
  bool browser_scroll = false;      // the chosen entry is to be scrolled into sight
  BrowserPurpose browser_purpose = BrowserPurpose::molecule;
  SaveMemory saving;
  std::string save_path;
  RecordMemory record;
  std::string export_path;
  ExportColours export_colours = ExportColours::element;
  std::string session_path;  // to save to
  NumberTyping number;
  KeyMemory keys;
  SandboxMemory sandbox;
  TableMemory save_table;
  std::vector<std::size_t> dialogs;  // that are open, by dialog_stack.cpp; the last is on top
  bool dragging_view = false;
  HandlePart clip_part = HandlePart::none,
             clip_part_hovered = HandlePart::none;  // held by the mouse
  std::string expression_typed;
  bool expression_entered = false;  // and nothing said of it yet
  std::string expression_shown;     // the one in force when expression_typed was last taken over
  std::string confirm_assembly;     // id of the one that is asked about; empty: none
  std::string reveal;               // a widget to be scrolled into sight, for scripts
  std::string go_to_section;        // of the left side: to be opened and scrolled to its top
  bool sections_overflow = false;   // the left side is longer than the window
  double mouse_still_seconds = 0;   // since the mouse moved or a button was down
  float mouse_x = 0, mouse_y = 0;   // pixels, in the last frame
};

struct ViewState {
  // What is set for the open file: the panels change it, the history notes it once a frame.
  Settings settings;
  std::optional<Ref> hovered;  // under the mouse in the picture
  // Its items were changed since other atoms line what is chosen: that is no entry of the history,
  // which takes this back.
  bool selection_followed = false;
  WindowSettings window;
  Playback playback;
  LessonMemory lessons;
  StepsMemory steps;
  CavityMemory cavities;
  PaletteMemory palette;
  ContextMemory context;

  MoleculeInfo molecule;
  std::shared_ptr<const Answer> result;   // on screen; null: none. The controls may be ahead
  std::string pending;                    // what is computed and still being drawn; empty: nothing
  ColdAndWarm ours, cgal, cgal_parallel;  // the last: with all threads
  std::shared_ptr<const BallReferences> references;  // of the balls on screen; null: none
  std::string picked_text;                           // how many are selected; empty: none
  std::size_t picked_missing = 0;                    // of them, those not in the picture
  BadgeInfo badge;
  BenchmarkControls benchmark_controls;
  BenchmarkInfo benchmark;
  // Of the folder in the file dialog, or of the one before while that is being read; null: none
  // yet.
  std::shared_ptr<const FolderListing> listing;
  BusyInfo busy, saving;  // saving: a picture, a table or an export, which hold nothing up
  BackgroundInfo background;
  Layers layers;                 // that the panels want drawn; filled anew in each frame
  bool measures_wanted = false;  // areas and volumes are shown; said anew in each frame
  ViewportInfo viewport;
  std::string device_text;       // "CPU · 2 threads"
  std::optional<GpuDevice> gpu;  // nothing: still being looked for
  std::string engine_note;       // why another engine than hoped for was used; may be empty
  std::string version;
  ProgramName program;                             // for what is written
  std::size_t memory_bytes = 0;                    // of the whole program
  std::uint64_t free_bytes = 0;                    // that the machine could still give; 0: unknown
  std::optional<SelectionError> expression_error;  // why what was typed was not taken
  std::string error_title, error;                  // shown as a dialog until dismissed
  std::deque<std::pair<std::string, std::string>> more_errors;  // titles and texts that come next
  std::string compute_error;  // why the present alpha has no complex; one line over the view
  // Lines that say which of several dropped files is open; until dismissed, or another is opened.
  std::string drop_note;
  std::string notice;                // one line in the status bar, "saved /tmp/a.png"
  std::string undo_text, redo_text;  // what would change, "alpha"; empty: nothing
  std::vector<SampleMolecule> samples;
  std::vector<std::filesystem::path> recent;  // files, the latest first
  std::optional<SessionProblem> session_problem;
  std::filesystem::path session_file;  // that was opened or saved last, of this molecule; or empty

  PanelMemory memory;

  // Shows an error, after those that are not dismissed yet. For what the user asked for once; what
  // follows a slider must not open a dialog at each step.
  void tell(const std::string& title, const std::string& text) {
    const std::pair<std::string, std::string> news{title, text};
    if (error.empty()) {
      std::tie(error_title, error) = news;
    } else if (error != text && (more_errors.empty() || more_errors.back() != news)) {
      more_errors.push_back(news);
    }
  }
};

// One was found that engines can use.
inline bool has_gpu(const ViewState& state) {
  return state.gpu && state.gpu->usable;
}

}  // namespace alphascope
