// SPDX-License-Identifier: GPL-3.0-or-later
// The state of the page of cavities between frames. Plain data.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/cavity_identity/cavity_match.hpp"
#include "core/document/cavities/drawn_parts.hpp"
#include "core/document/cavities/known_cavities.hpp"
#include "core/document/reference/atom_set.hpp"
#include "core/document/reference/ref_set.hpp"
#include "core/document/settings/beside_body.hpp"
#include "core/geometry/ball_index.hpp"

namespace alphascope {

struct BallSet;
struct CavityLine;
struct CavityLines;
struct Layer;
struct SelectedCavities;
enum class Theme : std::uint8_t;

// The filter of rows, and their order.
struct CavityFilter {
  int kind = 0;  // 0 all, 1 voids, 2 pockets
  // SA volume; 0 shows all cavities, also those of negative volume.
  double least_volume_angstrom3 = 0;
  int sort_column = 0;  // index in cavity_page_columns()
  bool descending = false;
  friend bool operator==(const CavityFilter&, const CavityFilter&) = default;

  bool shows(const CavityLine& line) const;
};

struct CavityPage {
  std::string molecule;  // SHA-256 of the molecule's file

  CavityFilter filter;
  std::vector<bool> columns;    // for each column: it is shown; empty: not set up yet
  bool columns_changed = true;  // by anything but the table's own menu
  DrawnCavityParts parts;       // the parts of chosen cavities that are drawn
  bool fades_rest = true;       // balls and simplices are pale

  KnownCavities rows;               // rows.lines is null until there is a table
  bool rows_are_old = true;         // `order` belongs to earlier rows
  CavityFilter ordered_by;          // the filter by which `order` was made
  std::vector<std::size_t> order;   // rows that are shown, in order
  double stale_since_seconds = -1;  // by ImGui's clock; negative: the rows belong to the picture

  std::uint64_t body_key = 0;  // Inputs::body_key of the rows
  // Splits and merges of cavities, by cavity number, during the last movement of alpha or the
  // solvent radius.
  struct Change {
    std::uint32_t parted_from = CavityMatch::kNone, merged = 0;
  };
  std::map<std::uint32_t, Change> changes;
  double changed_at_seconds = 0;  // by ImGui's clock

  // A copy of Selection::cavities, then the rows among which `selected_rows` are indices.
  RefSet chosen;
  std::shared_ptr<const CavityLines> selected_in;
  std::vector<std::size_t> selected_rows;  // ascending
  // Those of selected_rows into which a chosen cavity has merged.
  std::vector<std::size_t> merged_into;
  // Lining atoms of the chosen rows; the selection follows it until the user selects other items.
  RefSet lining;
  std::optional<std::size_t> anchor;  // row clicked last, from which Shift+click reaches
  struct Choice {
    std::vector<std::array<BallIndex, 4>> sinks;  // sinks of the chosen rows, ascending
    DrawnCavityParts parts;
    std::uint64_t key = 0;  // changes with the sinks or the parts
  } choice;
  std::shared_ptr<const SelectedCavities> drawn;  // the cavities from which `layers` are made
  std::vector<std::shared_ptr<const Layer>> layers;
  std::shared_ptr<const BallSet> layers_of;  // Layer::balls
  std::uint64_t layers_key = 0;
  bool layers_are_old = true;
  std::optional<std::size_t> hovered;       // row under the mouse, here or in the tree
  std::optional<std::size_t> scrolled;      // row in the picture to which the table was scrolled
  std::shared_ptr<const Layer> hover_mark;  // shows where that cavity is; null: none
  // For which hover_mark was made.
  std::optional<std::size_t> marked_row;
  std::shared_ptr<const CavityLines> marked_in;
  struct Sticks {  // for which the layers were made
    bool lining = false;
    bool in_front = true;  // contents, as balls and simplices are pale or not drawn
    float lining_opacity = 1, content_opacity = 1;
    friend bool operator==(const Sticks&, const Sticks&) = default;
  } sticks;
  AtomsBesideBody beside;  // kinds of dropped atoms that `layers` may show; then hidden atoms
  AtomSet hidden;
  Theme theme{};  // for which their colours were chosen
};

}  // namespace alphascope
