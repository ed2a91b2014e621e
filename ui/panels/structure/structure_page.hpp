// SPDX-License-Identifier: GPL-3.0-or-later
// Functions that the sources of the page Structure share.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "core/document/structure/structure_rows.hpp"

namespace alphascope {

class BallReferences;
struct PanelContext;
struct StructureState;

// The rows, and what the mouse does with them in this frame.
struct StructurePage {
  PanelContext& ctx;
  StructureState& memory;
  const StructureRows& rows;
  const BallReferences& atoms;
  std::optional<std::size_t> pointed;  // row under the mouse, here or in the picture
  std::optional<std::size_t> hovered;  // row under the mouse on this page
  std::size_t hovered_way = 0;         // way under the mouse on this page, from 1; 0: none
};

std::string count_text(std::size_t n);  // "1,224"

// --- structure_selection.cpp

// Whether any atom of the residue is selected.
bool is_selected(const StructurePage& page, std::size_t row);
// Takes clicks on the last item, which stands for the rows [begin, end).
void take_mouse(StructurePage& page, std::size_t begin, std::size_t end, bool clicked);
// Marks the balls of the residue under the mouse in the picture.
void mark_hovered(StructurePage& page);

// --- structure_cavities.cpp

// Asks for the table of cavities while their branch is open or some are chosen, and draws these.
void follow_tree_of_cavities(PanelContext& ctx, const StructureState& memory);
// Lines of the branch of cavities, which comes first: at least its title.
std::size_t lines_of_cavities(const StructurePage& page);
void draw_title_of_cavities(StructurePage& page);
void draw_cavity(StructurePage& page, std::size_t row);

// --- structure_channels.cpp

// Asks for the ways through the molecule while their branch is open. Draws the one under the mouse,
// or else the chosen one.
void follow_tree_of_channels(PanelContext& ctx, StructureState& memory);
// Lines of the branch of channels, which comes second: at least its title.
std::size_t lines_of_channels(const StructurePage& page);
void draw_title_of_channels(StructurePage& page);
void draw_channel(StructurePage& page, std::size_t row);

// --- structure_tree.cpp and structure_sequences.cpp

void draw_tree(StructurePage& page);
void draw_sequences(StructurePage& page);

}  // namespace alphascope
