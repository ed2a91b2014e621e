// What the panels show of molecule, result, timings and view: plain data that the program fills.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ui/panels/radius_edits.hpp"
#include "ui/picture_marks.hpp"

namespace alphascope {

struct GrownRadius {
  std::string element;           // "C"; empty when the file does not say
  double radius = 0, grown = 0;  // Å; grown is 0 where the ball is empty
  std::size_t balls = 0;         // of this element and radius
  std::string atoms = {};        // names of some: "CA, CB, …"; may be empty
};

// What was left out for one reason: "221 waters", "HOH 221".
struct DroppedRow {
  std::string text, detail;
};

// Atoms of one name whose radius did not come from the radii set.
struct RadiusRow {
  enum class Kind : std::uint8_t { guessed, by_hand, none };  // none: no ball, for lack of a radius
  Kind kind = Kind::guessed;
  AtomGroup atoms;
  std::size_t count = 0;
  double radius = 0;        // Å, in use
  std::string source = {};  // of a guess: "ionic radius, Shannon 1976"
};

struct ChainRow {
  std::string name, detail;  // "A", "polymer 1,069 · water 60"
  std::size_t atoms = 0;
};

struct AssemblyRow {
  std::string id, details;  // "1", "author determined dimeric"
  std::uint64_t copies = 0, atoms = 0;
  std::uint64_t bytes = 0;  // for its atoms and balls, about
};

// Atoms of the whole molecule, all models, by what the toggles ask for.
struct KindTotals {
  std::size_t polymers = 0, waters = 0, ligands = 0, ions = 0, dummies = 0;
  std::size_t hydrogens = 0, altlocs = 0;
};

struct MoleculeInfo {
  bool loaded = false;
  std::string name, folder, title, format;  // "4hhb.pdb.gz", "/data", "HAEMOGLOBIN…", "PDB"
  std::string summary;                      // one line: used, dropped, guessed
  std::vector<std::string> notes;           // what the reader had to assume
  std::size_t balls = 0;
  std::vector<GrownRadius> radii;  // each pair of element and radius, most frequent first
  std::size_t dropped_atoms = 0;
  std::vector<DroppedRow> dropped;
  std::vector<RadiusRow> radius_rows;
  std::vector<ChainRow> chains;
  std::uint64_t deposited_atoms = 0;  // of all models
  std::vector<AssemblyRow> assemblies;
  std::vector<int> models;  // their numbers, as the file says
  KindTotals kinds;
  bool has_file_radii = false;
  std::string sha256, radii_name, radii_citation;
  // "Lattice unit", "0.001 Å": where the numbers come from; complete, for people and papers.
  std::vector<std::pair<std::string, std::string>> provenance;
};

// The complex on screen.
struct ResultInfo {
  bool present = false;
  std::string molecule;  // "4hhb.pdb.gz"
  std::size_t balls = 0;
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
  // What was computed; times of different tasks are not to be compared.
  double alpha = 0;  // Å²
  bool tetrahedra_only = false;
  bool rebuilt = false;  // made anew what later alphas are answered from
  bool rests_on_cgal = false;
  bool comparable(const TimedRun& o) const {
    return alpha == o.alpha && tetrahedra_only == o.tetrahedra_only && rebuilt == o.rebuilt &&
           !same_threshold(o);
  }
  // Both only looked up in what was made of CGAL's triangulation: the same steps twice.
  bool same_threshold(const TimedRun& o) const {
    return rests_on_cgal && o.rests_on_cgal && !rebuilt && !o.rebuilt;
  }
};

// cold: the first computation, set-up included. warm: a later alpha of the same molecule.
struct EngineTimings {
  std::string engine, device;
  std::optional<TimedRun> cold, warm;
};

// The graphics processor as the program found it.
struct GpuInfo {
  bool known = false;  // false: still being looked for
  bool usable = false;
  std::string name, driver, capability;  // "NVIDIA H200", "CUDA driver 13.0", "9.0"
  std::size_t memory_bytes = 0;
  std::string why_not;  // the sentence that says why it is not used
};

struct BadgeInfo {
  enum class State : std::uint8_t { not_compared, comparing, identical, different, failed };
  State state = State::not_compared;
  std::string text;    // "identical to CGAL: 16,445 of 16,445 tetrahedra"
  double seconds = 0;  // that the comparison has been running
};

struct BusyInfo {
  bool active = false;
  std::string what;   // "Opening 1aon.pdb.gz", "kernel II (filtered validity)"
  double share = -1;  // 0 to 1; negative: unknown
  double seconds = 0;
};

// What is made while the user goes on working.
struct BackgroundInfo {
  std::string text, detail;  // one line; what it means. Empty: nothing goes on
};

struct PointerEvent {
  enum class Kind : std::uint8_t { move, press, release, wheel, double_click };
  Kind kind = Kind::move;
  int x = 0, y = 0;  // pixels of the picture, from its top left
  int button = 0;    // 0 left, 1 right, 2 middle
  double wheel = 0;
  bool control = false, shift = false;
};

// What makes a view useless although there is something to see.
enum class ViewTrouble : std::uint8_t { none, nothing_in_view, inside_a_ball };

struct ViewportInfo {
  std::uint64_t texture = 0;  // OpenGL name of the picture; 0: none yet
  double angstrom_per_pixel = 0;
  std::optional<ColourLegend> legend;
  std::string not_drawn;  // what the picture lacks for want of memory, and what to do
  bool outdated = false;  // it is of other settings than those chosen; the new one is being made
  ViewTrouble trouble = ViewTrouble::none;
  // Written by the panels: how large the picture should be (pixels) and what the mouse did on it.
  int width = 0, height = 0;
  std::vector<PointerEvent> events;
  bool hovered = false;  // the mouse is on the picture and no button is down
  int mouse_x = 0, mouse_y = 0;
  std::string under_mouse;  // what is there, as the program says; shown when the mouse rests
};

}  // namespace alphascope
