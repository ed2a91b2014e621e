// What the panels show of molecule, result, timings and view: plain data that the program fills.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/real_point.hpp"
#include "core/molecule/assembly.hpp"
#include "core/selection/contents.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/selection/residue_groups.hpp"
#include "ui/clip_handle.hpp"
#include "ui/picture_marks.hpp"
#include "ui/view_problem.hpp"

namespace alphascope {

// Of a BallSize, in Å and with what request and lattice make of it.
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

// Atoms whose radius did not come from the radii set.
struct RadiusRow {
  enum class Kind : std::uint8_t { guessed, by_hand, none };  // none: no ball, for lack of a radius
  Kind kind = Kind::guessed;
  GuessedRadius radius;  // in use
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
  MoleculeContents contents;                      // of the whole molecule, all models
  std::shared_ptr<const ResidueGroups> residues;  // of the model that is used; may be null
  std::uint64_t deposited_atoms = 0;              // of all models
  std::vector<AssemblyInfo> assemblies;
  std::vector<int> models;  // their numbers, as the file says
  bool has_file_radii = false;
  std::string sha256, radii_name, radii_citation;
  // "Lattice unit", "0.001 Å": where the numbers come from; complete, for people and papers.
  std::vector<std::pair<std::string, std::string>> provenance;
  BallOptions options;  // that chose its balls
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
  std::string step = {};  // of saving: "sample 3 of 16, 5 s left"; empty: not known
};

// What is made while the user goes on working.
struct BackgroundInfo {
  std::string text, detail;  // one line; what it means. Empty: nothing goes on
};

struct PointerEvent {
  // click: a release of the left or right button near where it was pressed, after that release.
  enum class Kind : std::uint8_t { move, press, release, click, wheel, double_click };
  Kind kind = Kind::move;
  int x = 0, y = 0;  // pixels of the picture, from its top left
  int button = 0;    // 0 left, 1 right, 2 middle
  double wheel = 0;
  bool control = false, shift = false;
};

struct ViewportInfo {
  std::uint64_t texture = 0;  // OpenGL name of the picture; 0: none yet
  double angstrom_per_pixel = 0;
  RealPoint into_view{0, 0, -1};  // unit vector, from the eye
  // Of the box around the balls in the picture: its middle and half its lengths, Å.
  std::array<double, 3> box_middle{}, box_half{};
  ClipHandle clip_handle;  // of the picture in `texture`
  std::vector<ColourLegend> legends;
  std::optional<ColourRange> ball_range, simplex_range;  // of colours of quantities
  std::vector<PictureLabel> labels;                      // of the picture in `texture`
  std::size_t hidden_balls = 0;                          // by the user
  bool fades_rest = false;  // pages draw what balls and simplices must not hide: kFadedOpacity
  std::string not_drawn;    // what the picture lacks for want of memory, and what to do
  bool outdated = false;    // it is of other settings than those chosen; the new one is being made
  ViewProblem problem = ViewProblem::none;
  // Written by the panels: how large the picture should be (pixels) and what the mouse did on it.
  int width = 0, height = 0;
  bool covered = false;  // by something that hides all of it: it need not be drawn
  std::vector<PointerEvent> events;
  bool hovered = false;  // the mouse is on the picture and no button is down
  int mouse_x = 0, mouse_y = 0;
  // What is there, as the program says: shown when the mouse rests, and in the status bar.
  std::string under_mouse, under_mouse_line;
};

}  // namespace alphascope
