// SPDX-License-Identifier: GPL-3.0-or-later
// Functions that the sources of the page of cavities share with each other and with other pages.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/document/store/definition.hpp"

namespace alphascope {

class RefSet;
struct CavityLine;
struct CavityLines;
struct CavityPage;
struct Colour;
struct PanelContext;

// --- cavity_following.cpp

// Brings CavityState::page up to date with the table on screen and the chosen cavities. Makes the
// page if there is none. Every page that shows the table or chosen cavities calls it in each frame.
struct FollowedCavities {
  bool current = false;         // the rows belong to the picture
  Derived<CavityLines> wanted;  // the table that is being made, if they do not
};
FollowedCavities follow_cavities(PanelContext& ctx);
// Returns the atoms that line these rows, at most Selection::kMostItems.
RefSet lining_of(const CavityPage& page, const std::vector<std::size_t>& rows);
// Returns a sentence such as "The chosen cavity has merged into cavity 3."; empty if none has
// merged.
std::string merged_text(const CavityPage& page);

// --- cavities_table.cpp

// Draws a button that opens a list of the columns.
void cavity_columns_button(PanelContext& ctx, CavityPage& page);
// Draws the table. `current`: the rows belong to the picture; otherwise clicks do nothing.
void draw_cavity_table(PanelContext& ctx, CavityPage& page, float width, bool current);

// --- selected_cavities_pane.cpp

// A click chooses a row alone, adds or removes it, or chooses all from the last clicked row to it.
enum class HowSelected : std::uint8_t { alone, toggled, range };
void select_cavity(PanelContext& ctx, CavityPage& page, std::size_t row, HowSelected how);
void select_all_cavities(PanelContext& ctx, CavityPage& page);  // all that the filter shows
void clear_cavity_selection(PanelContext& ctx);

// Draws the chosen cavities in the view. To be called in each frame in which they are visible.
void draw_layers_of_cavities(PanelContext& ctx, CavityPage& page, bool current);
void draw_selected_cavities(PanelContext& ctx, CavityPage& page);
// Draws a button that opens a list of the parts that can be drawn.
void cavity_parts_button(PanelContext& ctx, CavityPage& page);

// Returns the colour of the cavity's surface in the view, and of its mark in the table.
Colour cavity_colour(const CavityPage& page, std::size_t row);

// Returns a sentence if the cavity lies between bodies or chains; empty if it does not. `chains`
// names the chains that line it, "A and D"; empty if they are unknown.
std::string between_text(const CavityLine& line, const std::string& chains);

// --- cavity_networks.cpp

// If there are networks, draws the choice to split them. A button sets the solvent radius at which
// the chosen network, else the largest, falls apart. `current`: the rows belong to the picture.
void networks_line(PanelContext& ctx, const CavityPage& page, bool current);
// Says in sentences at which solvent radius this network falls apart, once that is known.
void network_end_sentences(PanelContext& ctx, const CavityPage& page, std::size_t row);
// Returns a sentence about a part of a network; empty if the cavity is no such part.
std::string part_text(const CavityLine& line);

// --- selected_cavities_pane.cpp

// Returns sentences if the cavity split off or merged in the last movement of alpha or the solvent
// radius; else empty.
std::string change_text(const CavityPage& page, std::size_t row);

}  // namespace alphascope
