// SPDX-License-Identifier: GPL-3.0-or-later
// All that panels and program exchange: what is shown, settings and requests. Panels know nothing
// else of the program. Each part is plain data with a header of its own. So a panel compiles the
// parts that it uses only. whole_state.hpp has the object that holds the parts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/document/reference/ref_set.hpp"

namespace alphascope {

class BallReferences;
class SelectionError;
enum class ErrorKind : std::uint8_t;
enum class Theme : std::uint8_t;
struct Annotations;
struct Answer;
struct Appearance;
struct BackgroundInfo;
struct BadgeInfo;
struct BallSet;
struct BenchmarkInfo;
struct BenchmarkSettings;
struct BrowserState;
struct CavitySettings;
struct CavityState;
struct ChannelState;
struct Clip;
struct ColdAndWarm;
struct ContextState;
struct DialogState;
struct DisplaySettings;
struct ExpressionState;
struct FetchState;
struct FolderListing;
struct GpuDevice;
struct GuideState;
struct KeyState;
struct Layer;
struct LessonState;
struct MoleculeInfo;
struct MouseState;
struct NamedClip;
struct NamedView;
struct DrawnObject;
struct NumberTyping;
struct OpenOptions;
struct PaletteState;
struct Playback;
struct PreparedBalls;
struct ProgramName;
struct RecordState;
struct Request;
struct RunningJob;
struct SandboxState;
struct SaveState;
struct ScrollState;
struct SessionProblem;
struct Settings;
struct StartState;
struct StepsState;
struct TableState;
struct TaskState;
struct ViewParts;
struct ViewportInfo;
struct WindowSettings;

inline constexpr double kTooltipDelaySeconds = 0.4;
// Most balls for which the window compares with CGAL after each change. With more, CGAL would
// occupy the cores for long.
inline constexpr std::size_t kMostBallsToCompareUnasked = 200000;

struct SampleMolecule {
  std::string name, detail;  // "Crambin", "1CRN · 327 atoms"
  std::filesystem::path path;
};

// Settings for the open file, as a whole and in parts. The panels change them, and the history
// notes changes once a frame.
struct SettingsParts {
  Settings& all;
  OpenOptions& open;
  Request& request;
  DisplaySettings& display;
  std::vector<DrawnObject>& objects;
  Selection& selection;
  Clip& clip;
  std::vector<NamedClip>& clips;
  std::vector<NamedView>& views;
  Appearance& appearance;
  Annotations& annotations;
  CavitySettings& cavity_settings;

  explicit SettingsParts(Settings& settings);
};

// The line in the status bar, which counts how often it was set. So the same text twice is news.
class Notice {
 public:
  Notice& operator=(std::string text) {
    text_ = std::move(text);
    ++times_;
    return *this;
  }
  void clear() { text_.clear(); }
  bool empty() const { return text_.empty(); }
  const std::string& text() const { return text_; }
  std::size_t times() const { return times_; }

 private:
  std::string text_;
  std::size_t times_ = 0;  // how often a text was set
};

// The parts that need no header of ours.
struct ViewValues {
  std::optional<Ref> hovered;  // thing under the mouse in the picture
  // The selection followed the atoms that line the chosen cavities. The history makes no entry of
  // such a change, and resets this flag.
  bool selection_followed = false;
  std::shared_ptr<const Answer> result;  // on screen; null: none. Settings may be newer
  std::string pending;  // the complex that is computed and still being drawn; empty: none
  std::shared_ptr<const BallReferences> references;  // to the balls on screen; null: none
  std::string selected_count_text;                   // number of selected items; empty: none
  std::size_t selected_missing = 0;  // number of selected items that are not in the picture
  // The folder in the file dialog. While a folder is being read, this is the one before. Null: none
  // yet.
  std::shared_ptr<const FolderListing> listing;
  // Layers that the panels want drawn; made anew in each frame.
  std::vector<std::shared_ptr<const Layer>> layers;
  bool measures_wanted = false;  // areas and volumes are shown; set anew in each frame
  // From the last change of alpha, solvent radius or engine to its picture. Empty if no change
  // asked for the picture on screen, as after opening a file.
  std::optional<double> move_milliseconds;
  std::string device_text;  // "dual-edge engine on CPU, 2 threads"
  std::string engine_note;  // why another engine than expected was used; empty: none was
  std::string version;
  std::size_t memory_bytes = 0;    // memory of the whole program
  std::uint64_t free_bytes = 0;    // memory that the machine could still give; 0: unknown
  std::string error_title, error;  // shown in a dialog until dismissed
  ErrorKind error_kind{};
  struct LaterError {
    std::string title, text;
    ErrorKind kind;
    friend bool operator==(const LaterError&, const LaterError&) = default;
  };
  std::deque<LaterError> more_errors;
  std::string compute_error;  // why the present alpha has no complex; one line over the view
  // Scripts end with these. The first error or question that the program withdrew before anybody
  // dismissed it, or what it refused late; and the first complex that could not be computed.
  std::string withdrawn_error, first_compute_error;
  ErrorKind withdrawn_kind{};
  // Why the picture is of other values than the controls have. Empty: computing was not cancelled.
  std::string computing_cancelled;
  // Lines that name the opened one of several dropped files. They stay until they are dismissed or
  // another file is opened.
  std::string drop_note;
  Notice notice;                     // one line in the status bar: "saved /tmp/a.png"
  std::string undo_text, redo_text;  // the change in words: "alpha"; empty: none
  std::vector<SampleMolecule> samples;
  std::vector<std::filesystem::path> recent;  // files, the latest first
  // The session opened or saved last for this molecule; may be empty.
  std::filesystem::path session_file;
};

struct ViewState : ViewValues {
  SettingsParts settings;
  WindowSettings& window;
  Playback& playback;
  LessonState& lessons;
  GuideState& guide;
  StepsState& steps;
  CavityState& cavities;
  ChannelState& channels;
  SandboxState& sandbox;
  MoleculeInfo& molecule;
  ColdAndWarm &ours, &cgal, &cgal_parallel;  // cgal_parallel: with all threads
  BadgeInfo& badge;
  BenchmarkSettings& benchmark_settings;
  BenchmarkInfo& benchmark;
  std::vector<RunningJob>& jobs;  // all that runs and takes long
  BackgroundInfo& background;
  ViewportInfo& viewport;
  std::optional<GpuDevice>& gpu;  // empty: the search has not ended
  ProgramName& program;           // as files that are written name it
  ExpressionState& expression;
  std::optional<SelectionError>& expression_error;  // why the typed expression was refused
  std::optional<SessionProblem>& session_problem;

  // The window between frames.
  PaletteState& palette;
  ContextState& context;
  DialogState& dialogs;
  BrowserState& browser;
  FetchState& fetch;
  StartState& start;
  TaskState& tasks;
  SaveState& saving;
  RecordState& record;
  TableState& save_table;
  NumberTyping& number;
  KeyState& keys;
  MouseState& mouse;
  ScrollState& scroll;

  // Answers to questions that many panels ask. A panel that asks no more of a part does not include
  // it.
  bool has_molecule() const;
  const std::string& file_name() const;  // "4hhb.pdb.gz"; empty: none
  const std::string& file_hash() const;  // SHA-256 of the molecule's file
  Theme theme() const;
  // Of the request.
  double alpha_angstrom2() const;
  double solvent_radius_angstrom() const;
  // Of the complex on screen; null: there is none.
  const Request* shown_request() const;
  const std::shared_ptr<const BallSet>& shown_balls() const;  // with the solvent radius
  const PreparedBalls* shown_selection() const;               // the atoms that became its balls
  bool shows_tetrahedra_only() const;  // the complex on screen has no other simplices

  // The state of these parts, which must outlive it.
  ViewState(const ViewValues& values, ViewParts& parts);
  // Copies would refer to the same parts.
  ViewState(const ViewState&) = delete;
  ViewState& operator=(const ViewState&) = delete;

  // Sets alpha, Å², and stops its playback.
  void go_to_alpha(double angstrom2);
  // Shows this page below the view.
  void show_page(const std::string& id);
  // The page below the view. If none was shown or chosen, it is Cavities for a molecule with a
  // polymer, else the first.
  std::string page() const;
  // Shows an error in a dialog, after earlier ones that are not dismissed yet. To be used for
  // single requests of the user, since a slider must not open a dialog at each step.
  void show_error(const std::string& title, const std::string& text, ErrorKind kind);
  void show_compute_error(const std::string& text);  // empty: there is none
  void close_error();                                // the one in the dialog; the next one follows
  // Closes errors with this title, for when they are true no more.
  void close_errors(std::string_view title);
  void note_withdrawn(const std::string& text, ErrorKind kind);
  // Refuses, in the status bar, what a command asked for in an earlier frame. A script fails.
  void refuse_late(const std::string& text);
};

// Whether a GPU was found that engines can use.
bool has_gpu(const ViewState& state);

}  // namespace alphascope
