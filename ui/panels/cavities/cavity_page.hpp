// What the page of cavities remembers between frames. Plain data.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/document/cavities/cavity_contents.hpp"
#include "core/document/cavities/chosen_cavities.hpp"
#include "core/document/channels/channel_results.hpp"
#include "core/document/reference/atom_set.hpp"
#include "core/document/settings/display.hpp"
#include "ui/layer.hpp"

namespace alphascope {

// All that is known of the rows of one table, as the columns show it.
struct CavityRows {
  std::shared_ptr<const CavityLines> lines;  // null: no table yet
  // These follow, each null until it is there.
  std::shared_ptr<const ExactVolumes> exact;
  std::shared_ptr<const CavityDepths> depths;
  std::shared_ptr<const CavityLives> lives;
  std::shared_ptr<const CavityBottlenecks> bottlenecks;
  std::shared_ptr<const CavityContents> contents;

  const CavityTable& table() const { return *lines->table; }
  std::size_t size() const { return lines ? lines->of.size() : 0; }
};

// Which rows are shown, and in which order.
struct CavityFilter {
  int kind = 0;                       // 0 all, 1 voids, 2 pockets
  double least_volume_angstrom3 = 0;  // SA; 0: all, negative ones as well
  int sort_column = 0;                // CavityColumn
  bool descending = false;
  friend bool operator==(const CavityFilter&, const CavityFilter&) = default;

  bool shows(const CavityLine& line) const {
    const bool of_kind = kind == 0 || (kind == 1) == line.is_void;
    return of_kind &&
           (least_volume_angstrom3 == 0 || line.volume_sa_angstrom3 >= least_volume_angstrom3);
  }
};

struct CavityPage {
  std::string molecule;  // SHA-256 of its file

  CavityFilter filter;
  std::vector<bool> columns;    // that are shown; empty: the first ones
  bool columns_changed = true;  // by other means than the table's own menu
  CavityParts parts;            // of what is chosen, what is drawn
  bool fades_rest = true;       // all else is pale

  CavityRows rows;
  bool rows_are_old = true;         // `order` is of others
  CavityFilter ordered_by;          // ... or by another filter
  std::vector<std::size_t> order;   // rows that are shown
  double stale_since_seconds = -1;  // ImGui's time; negative: the rows are of the picture

  std::uint64_t body_key = 0;  // Inputs::body_key of the rows
  // What has happened to cavities, by their numbers, while alpha or the solvent radius moved last.
  struct Change {
    std::uint32_t parted_from = CavityMatch::kNone, merged = 0;
  };
  std::map<std::uint32_t, Change> changes;
  double changed_at_seconds = 0;  // ImGui's time

  // Selection::cavities, and the lines in which `chosen_rows` are those.
  RefSet chosen;
  std::shared_ptr<const CavityLines> chosen_in;
  std::vector<std::size_t> chosen_rows;  // ascending
  std::vector<std::size_t> merged_into;  // of them, those that a chosen cavity has merged into
  RefSet lining;  // of the chosen rows; while it is what is selected, the selection follows it
  std::optional<std::size_t> anchor;  // row that was clicked last; Shift+click reaches from it
  struct Choice {
    CavitySinks sinks;  // of the rows; ascending
    CavityParts parts;
    std::uint64_t key = 0;  // another one for other sinks or parts
  } choice;
  std::shared_ptr<const ChosenCavities> drawn;  // what `layers` are made of
  Layers layers;
  std::shared_ptr<const BallSet> layers_of;  // Layer::balls
  std::uint64_t layers_key = 0;
  bool layers_are_old = true;
  AtomsBesideBody beside;  // by which atoms are among them, as the next
  AtomSet hidden;
  Theme theme = Theme::dark;  // that their colours are for
};

}  // namespace alphascope
