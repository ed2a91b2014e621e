// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the lives of cavities, for their own sources only.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

namespace alphascope {

struct CavityGround;
struct CavityLives;
struct CavityPage;
struct PanelContext;
struct ShownLives;
template <class T>
struct Derived;

// The results behind the bars, and whether they belong to the picture.
struct KnownLives {
  CavityPage* page = nullptr;
  std::shared_ptr<const CavityGround> ground;
  bool current = false;
};
// Makes the bars anew if their results changed. Returns whether there are any results yet.
bool follow_lives(PanelContext& ctx, ShownLives& memory, KnownLives& known,
                  const Derived<CavityLives>& lives);
// Returns the row of a bar; kNoRow if the table on screen is of other balls than the bars.
std::size_t row_of_bar(const ShownLives& memory, const CavityPage& page, std::size_t bar);

// Draws buttons that copy and save the bars.
void lives_save_buttons(PanelContext& ctx, const ShownLives& memory, const KnownLives& known);

// Returns the text on a bar under the mouse.
std::string life_text(const PanelContext& ctx, const ShownLives& memory, const KnownLives& known,
                      std::size_t bar);
// Chooses the cavity of a bar. One that is not in the table is chosen by its sink; the table finds
// it after alpha has changed.
void choose_life(PanelContext& ctx, const ShownLives& memory, const KnownLives& known,
                 std::size_t bar);

}  // namespace alphascope
