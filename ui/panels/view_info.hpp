// Plain data that the program fills and the panels show: molecule, result, timings and view.
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

// A radius in use, and the radius to which its balls grow in the present request.
struct GrownRadius {
  std::string element;           // "C"; empty if the file does not name it
  double radius = 0, grown = 0;  // Å; grown is 0 if the ball is empty
  std::size_t balls = 0;         // with this element and radius
  std::string atoms = {};        // names of some atoms: "CA, CB, …"; may be empty
};

// Atoms that were left out for one reason: "221 waters", "HOH 221".
struct DroppedRow {
  std::string text, detail;
};

// Atoms whose radius does not come from the radii set.
struct RadiusRow {
  enum class Kind : std::uint8_t { guessed, by_hand, none };  // none: no radius, so no ball
  Kind kind = Kind::guessed;
  GuessedRadius radius;  // the radius in use
};

struct MoleculeInfo {
  bool loaded = false;
  std::string name, folder, title, format;  // "4hhb.pdb.gz", "/data", "HAEMOGLOBIN…", "PDB"
  std::string summary;                      // one line: used, dropped and guessed atoms
  std::vector<std::string> notes;           // assumptions of the reader
  std::size_t balls = 0;
  std::vector<GrownRadius> radii;  // each pair of element and radius, most frequent first
  std::size_t dropped_atoms = 0;
  std::vector<DroppedRow> dropped;
  std::vector<RadiusRow> radius_rows;
  MoleculeContents contents;                      // of the whole molecule, all models
  std::shared_ptr<const ResidueGroups> residues;  // of the model in use; may be null
  std::uint64_t deposited_atoms = 0;              // in all models
  std::vector<AssemblyInfo> assemblies;
  std::vector<int> models;  // their numbers in the file
  bool has_file_radii = false;
  std::string sha256, radii_name, radii_citation;
  // Provenance of all numbers in full, for people and papers: "Lattice unit", "0.001 Å".
  std::vector<std::pair<std::string, std::string>> provenance;
  BallOptions options;  // the options that chose its balls
};

struct BadgeInfo {
  enum class State : std::uint8_t { not_compared, comparing, identical, different, failed };
  State state = State::not_compared;
  std::string text;    // "identical to CGAL: 16,445 of 16,445 tetrahedra"
  double seconds = 0;  // since the comparison began
};

struct BusyInfo {
  bool active = false;
  std::string what;   // "Opening 1aon.pdb.gz", "kernel II (filtered validity)"
  double share = -1;  // 0 to 1; negative: unknown
  double seconds = 0;
  std::string step = {};  // of saving: "sample 3 of 16, 5 s left"; empty: unknown
};

// A result that is made while the user goes on working.
struct BackgroundInfo {
  std::string text, detail;  // one line, and its explanation; empty: nothing is made
};

struct PointerEvent {
  // A click is a release of the left or right button near the place of the press. It follows that
  // release.
  enum class Kind : std::uint8_t { move, press, release, click, wheel, double_click };
  Kind kind = Kind::move;
  int x = 0, y = 0;  // pixels from the top left of the picture
  int button = 0;    // 0 left, 1 right, 2 middle
  double wheel = 0;
  bool control = false, shift = false;
};

struct ViewportInfo {
  std::uint64_t texture = 0;  // OpenGL name of the picture; 0: none yet
  double angstrom_per_pixel = 0;
  RealPoint into_view{0, 0, -1};  // unit vector from the eye
  // The box around the balls in the picture: its middle and half its side lengths, Å.
  std::array<double, 3> box_middle{}, box_half{};
  ClipHandle clip_handle;  // of the picture in `texture`
  std::vector<ColourLegend> legends;
  std::optional<ColourRange> ball_range, simplex_range;  // of colours that show quantities
  std::vector<PictureLabel> labels;                      // of the picture in `texture`
  std::size_t hidden_balls = 0;                          // hidden by the user
  // Pages draw things that balls and simplices must not hide, so these fade to kFadedOpacity.
  bool fades_rest = false;
  std::string not_drawn;  // parts missing from the picture for lack of memory, and the remedy
  bool outdated = false;  // the picture belongs to older settings; a new one is being made
  ViewProblem problem = ViewProblem::none;
  // The panels write the picture's size in pixels, and the events of the mouse on it.
  int width = 0, height = 0;
  bool covered = false;  // something hides all of the picture, so it need not be drawn
  std::vector<PointerEvent> events;
  bool hovered = false;  // the mouse is on the picture and no button is down
  int mouse_x = 0, mouse_y = 0;
  // The thing under the mouse in words: for the tooltip, and for the status bar.
  std::string under_mouse, under_mouse_line;
};

}  // namespace alphascope
