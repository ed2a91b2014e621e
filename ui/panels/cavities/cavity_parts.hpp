// The parts of the page of cavities.
#pragma once

#include "ui/panels/cavities/cavity_columns.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {

// --- cavity_following.cpp

// Takes in the table on screen and what of it is chosen; to be called in each frame by a page that
// shows either. Makes CavityMemory::page.
struct FollowedCavities {
  bool current = false;         // the rows are of the picture
  Derived<CavityLines> wanted;  // where they are not
};
FollowedCavities follow_cavities(PanelContext& ctx);
// What lines these rows, to be selected: at most Selection::kMostItems.
RefSet lining_of(const CavityPage& page, const std::vector<std::size_t>& rows);
// "The chosen cavity has merged into cavity 3."; empty: none has.
std::string merged_text(const CavityPage& page);

// --- cavities_table.cpp

// A button that opens a list of the columns.
void cavity_columns_button(PanelContext& ctx, CavityPage& page);
// `current`: the rows are of the picture; else a click does nothing.
void draw_cavity_table(PanelContext& ctx, CavityPage& page, float width, bool current);

// --- chosen_cavities_pane.cpp

// How a click on a row chooses: it alone, it as well or no more, all from the last one to it.
enum class HowChosen : std::uint8_t { alone, toggled, range };
void choose_cavity(PanelContext& ctx, CavityPage& page, std::size_t row, HowChosen how);
void choose_all_cavities(PanelContext& ctx, CavityPage& page);  // that are shown
void choose_no_cavities(PanelContext& ctx);

// What is chosen, in the view; in each frame in which it is to be seen.
void draw_layers_of_cavities(PanelContext& ctx, CavityPage& page, bool current);
void draw_chosen_cavities(PanelContext& ctx, CavityPage& page);
// A button that opens a list of what can be drawn of them.
void cavity_parts_button(PanelContext& ctx, CavityPage& page);

// The colour of its surface in the view, and of its mark in the table.
Colour cavity_colour(const CavityPage& page, std::size_t row);

// A sentence where it is no ordinary cavity of one body and chain; empty: it is. `chains`: names of
// those that line it, "A and D"; empty: unknown.
std::string between_text(const CavityLine& line, const std::string& chains);

// --- cavity_networks.cpp

// Where there are networks: the choice to split them, and a button that sets the solvent radius at
// which the chosen one, else the largest, falls apart. `current`: the rows are of the picture.
void networks_line(PanelContext& ctx, const CavityPage& page, bool current);
// The same of a chosen network in sentences, when it is known.
void network_end_sentences(PanelContext& ctx, const CavityPage& page, std::size_t row);
// A sentence of a part of a network; empty: it is none.
std::string part_text(const CavityLine& line);

// --- chosen_cavities_pane.cpp again

// Sentences where it has split off or merged while alpha or the solvent radius moved; or empty.
std::string change_text(const CavityPage& page, std::size_t row);

}  // namespace alphascope
