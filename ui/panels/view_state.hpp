// Everything the panels show and everything the user can change or ask for, as plain data. The
// program fills the Info parts and reads controls and requests; panels know nothing else.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ui/theme.hpp"

namespace alphascope {

enum class EngineOption : std::uint8_t { automatic, gpu, cpu, cgal };
enum class ColourBy : std::uint8_t { element, chain, single, alpha };  // alpha: simplices only

// A change of these needs a new computation.
struct ComputeControls {
  double alpha = 0;    // Å²
  double solvent = 0;  // Å
  EngineOption engine = EngineOption::automatic;
  bool tetrahedra_only = false;
  friend bool operator==(const ComputeControls&, const ComputeControls&) = default;
};

// Which atoms become balls; a change needs new balls.
enum class HydrogenOption : std::uint8_t { automatic, keep, drop };
struct SelectionControls {
  bool waters = false, ligands = true, ions = true;
  HydrogenOption hydrogens = HydrogenOption::automatic;
  int radii_set = 0;  // index into ViewState::radii_sets
  friend bool operator==(const SelectionControls&, const SelectionControls&) = default;
};

// A change of these only needs a new picture.
struct DisplayControls {
  bool balls = true, tetrahedra = true, boundary = false, triangles = false, edges = false;
  bool singular_only = true;  // triangles and edges that are faces of nothing larger
  bool grown_balls = false;   // sqrt((radius + solvent)² + alpha) instead of the radius
  float ball_scale = 0.3f;    // times the radius
  float ball_opacity = 1, complex_opacity = 1;
  float shrink = 0;  // of tetrahedra, 0 to 0.9
  ColourBy ball_colour = ColourBy::chain, complex_colour = ColourBy::chain;
  bool ambient_occlusion = true;
  friend bool operator==(const DisplayControls&, const DisplayControls&) = default;
};

struct GrownRadius {
  std::string element;           // "C"; empty when the file does not say
  double radius = 0, grown = 0;  // Å; grown is 0 where the ball is empty
};

struct MoleculeInfo {
  bool loaded = false;
  std::string name, folder, title, format;  // "4hhb.pdb.gz", "/data", "HAEMOGLOBIN…", "PDB"
  std::string summary;                      // one line: used, dropped, guessed
  std::vector<std::string> notes;           // what the reader had to assume
  std::size_t balls = 0;
  std::vector<GrownRadius> radii;  // each pair of element and radius, most frequent first
};

struct ResultInfo {
  bool present = false;
  double alpha = 0, solvent = 0;  // of this result; the controls may be ahead
  bool tetrahedra_only = false;
  std::size_t vertices = 0, edges = 0, triangles = 0, tetrahedra = 0;
  long long euler = 0;
  std::string hash, engine, device, route;
};

struct StageBar {
  std::string label;
  double milliseconds = 0;
  bool setup = false;  // paid once a molecule
};

struct TimedRun {
  std::vector<StageBar> stages;
  double wall_milliseconds = 0;
};

// cold: the first computation, set-up included. warm: a later alpha of the same molecule.
struct EngineTimings {
  std::string engine, device;
  std::optional<TimedRun> cold, warm;
};

struct BadgeInfo {
  enum class State : std::uint8_t { not_compared, comparing, identical, different, failed };
  State state = State::not_compared;
  std::string text;  // "identical to CGAL: 16,445 of 16,445 tetrahedra"
};

struct BusyInfo {
  bool active = false;
  std::string what;   // "Opening 1aon.pdb.gz", "kernel II (filtered validity)"
  double share = -1;  // 0 to 1; negative: unknown
  double seconds = 0;
};

struct PointerEvent {
  enum class Kind : std::uint8_t { move, press, release, wheel, double_click };
  Kind kind = Kind::move;
  int x = 0, y = 0;  // pixels of the picture, from its top left
  int button = 0;    // 0 left, 1 right, 2 middle
  double wheel = 0;
  bool control = false, shift = false;
};

struct ViewportInfo {
  std::uint64_t texture = 0;  // OpenGL name of the picture; 0: none yet
  double angstrom_per_pixel = 0;
  // Written by the panels: how large the picture should be (pixels) and what the mouse did on it.
  int width = 0, height = 0;
  std::vector<PointerEvent> events;
};

struct ScreenshotRequest {
  std::filesystem::path path;
  int width = 1920, height = 1080;
  bool transparent = false;
};

// What the user asked for in this frame; the program takes and clears them.
struct Requests {
  std::optional<std::filesystem::path> open;
  std::optional<std::size_t> open_sample;  // index into ViewState::samples
  std::optional<ScreenshotRequest> screenshot;
  bool compare = false, cancel = false, reset_view = false, quit = false;
};

struct RadiiSetEntry {
  std::string name, citation;
};

struct SampleMolecule {
  std::string name, detail;  // "Crambin", "1CRN · 327 atoms"
};

inline constexpr double kTooltipDelaySeconds = 0.4;

// What the panels remember between frames.
struct PanelMemory {
  bool show_cheat_sheet = false, show_about = false, show_browser = false, show_save = false;
  std::filesystem::path browser_folder;  // empty: choose a sensible one
  std::string browser_typed;
  std::filesystem::path browser_selected;
  bool browser_all_files = false;
  std::string save_path;
  int save_width = 1920, save_height = 1080;
  bool save_transparent = false;
  bool timings_cold = true;     // which of the two runs the waterfall shows
  bool timings_pinned = false;  // the user has chosen which
  float bottom_height = 0;      // pixels; 0: default
  bool dragging_view = false;
  double mouse_still_seconds = 0;  // since the mouse moved or a button was down
};

struct ViewState {
  ComputeControls compute;
  SelectionControls selection;
  DisplayControls display;
  Theme theme = Theme::dark;
  bool auto_compare = false;

  MoleculeInfo molecule;
  ResultInfo result;
  std::optional<EngineTimings> ours, cgal;
  BadgeInfo badge;
  BusyInfo busy;
  ViewportInfo viewport;
  std::string device_text;  // "CPU · 2 threads"
  bool gpu_available = false;
  std::string gpu_text;  // its name, or the sentence that says why there is none
  std::string version;
  std::size_t memory_bytes = 0;  // of the whole program
  std::string error;             // shown as a dialog until dismissed
  std::string notice;            // one line in the status bar, "saved /tmp/a.png"
  std::vector<SampleMolecule> samples;
  std::vector<RadiiSetEntry> radii_sets;

  Requests requests;
  PanelMemory memory;
};

}  // namespace alphascope
