// SPDX-License-Identifier: GPL-3.0-or-later
// Functions that the sources of the page of cavities share with each other and with other pages.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/document/store/definition.hpp"

namespace alphascope {

class BallReferences;
class RefSet;
struct BallSet;
struct CavityLine;
struct CavityLines;
struct CavityPage;
struct Colour;
struct PanelContext;
struct SelectedCavity;

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

// Finds the rows that the filter shows, in their order, if rows or filter have changed.
void follow_cavity_order(CavityPage& page);
// Draws a button that opens a list of the columns.
void cavity_columns_button(PanelContext& ctx, CavityPage& page);
// Draws the table. `current`: the rows belong to the picture; otherwise clicks do nothing.
// Sizes are in pixels.
void draw_cavity_table(PanelContext& ctx, CavityPage& page, float width, float height,
                       bool current);

// --- cavity_column_results.cpp

// Takes results that are computed after the rows themselves, as far as shown columns need them.
// `current`: the rows belong to the picture.
void follow_column_results(PanelContext& ctx, CavityPage& page, bool current);

// --- cavity_castp.cpp

// Says whether the table is comparable with CASTp's, and why not. A button makes it comparable.
void castp_line(PanelContext& ctx, const BallReferences& atoms);

// --- cavity_saving.cpp

// Draws a button that saves the rows that the filter shows, with all columns. `current`: the rows
// belong to the picture.
void cavity_save_button(PanelContext& ctx, const CavityPage& page, bool current);

// --- cavity_choosing.cpp

// A click chooses a row alone, adds or removes it, or chooses all from the last clicked row to it.
enum class HowSelected : std::uint8_t { alone, toggled, range };
void select_cavity(PanelContext& ctx, CavityPage& page, std::size_t row, HowSelected how);
void select_all_cavities(PanelContext& ctx, CavityPage& page);  // all that the filter shows
void clear_cavity_selection(PanelContext& ctx);

// --- cavity_drawing.cpp

// Draws the chosen cavities in the view. To be called in each frame in which they are visible.
void draw_layers_of_cavities(PanelContext& ctx, CavityPage& page, bool current);

// --- cavity_colour.cpp

// Returns the colour of the cavity's surface in the view, and of its mark in the table.
Colour cavity_colour(const CavityPage& page, std::size_t row);

// --- cavity_title.cpp

const char* kind_word(const CavityLine& line);  // "void", "pocket", "network" or "part"
// Returns the number, kind and SA volume, "Cavity 3  ·  pocket  ·  512 Å³".
std::string cavity_title(const CavityPage& page, std::size_t row);

// --- cavity_layers.cpp

// Returns the balls to which layers belong. A picture of another solvent radius has other balls,
// but the same atoms at the same places.
std::shared_ptr<const BallSet> balls_of_layers(const PanelContext& ctx, const CavityPage& page);
// Adds the cavity to CavityPage::layers.
void add_layers_of_cavity(PanelContext& ctx, CavityPage& page, const SelectedCavity& cavity);
// Marks where the cavity of CavityPage::hovered is, if it is not drawn: its deepest sink and its
// number.
void follow_hover_mark(PanelContext& ctx, CavityPage& page);

// --- cavity_contents_layer.cpp

// Adds the contents of the cavities once more, if they are drawn beside the body. Otherwise cavity
// and molecule would hide them. If an opaque body is drawn, they stay where they are.
void add_layer_of_contents(CavityPage& page);
// Adds the residues that line the cavities, as sticks.
void add_layer_of_lining(CavityPage& page);

// --- cavity_drawn_parts.cpp

// Draws a button that opens a list of the parts that can be drawn.
void cavity_parts_button(PanelContext& ctx, CavityPage& page);

// --- selected_cavities_pane.cpp

void draw_selected_cavities(PanelContext& ctx, CavityPage& page, float height);
// Returns a sentence if the cavity lies between bodies or chains; empty if it does not. `chains`
// names the chains that line it, "A and D"; empty if they are unknown.
std::string between_text(const CavityLine& line, const std::string& chains);
// Returns sentences if the cavity split off or merged in the last movement of alpha or the solvent
// radius; else empty.
std::string change_text(const CavityPage& page, std::size_t row);

// --- cavity_networks.cpp

// With hardly any probe radius, nearly all empty space of a protein is connected. Says so, and
// offers the radius of water.
void giant_network_line(PanelContext& ctx, const CavityPage& page);
// If there are networks, draws the choice to split them. A button sets the solvent radius at which
// the chosen network, else the largest, falls apart. `current`: the rows belong to the picture.
void networks_line(PanelContext& ctx, const CavityPage& page, bool current);
// Says in sentences at which solvent radius this network falls apart, once that is known.
void network_end_sentences(PanelContext& ctx, const CavityPage& page, std::size_t row);
// Returns a sentence about a part of a network; empty if the cavity is no such part.
std::string part_text(const CavityLine& line);

}  // namespace alphascope
