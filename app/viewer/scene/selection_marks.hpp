// SPDX-License-Identifier: GPL-3.0-or-later
// Marks of the selection over the picture.
#pragma once

#include <cstddef>
#include <vector>

#include "app/viewer/beside/beside_atoms.hpp"
#include "app/viewer/scene/canvas.hpp"
#include "app/viewer/scene/drawn_picture.hpp"

namespace alphascope {

// Items of the picture on screen: balls, and places in BesideBody::atoms, both ascending.
struct SelectedItems {
  std::vector<BallIndex> balls;
  std::vector<std::size_t> beside;
  bool outlines = false;  // only rims, which hide less
  friend bool operator==(const SelectedItems&, const SelectedItems&) = default;
};

class SelectionMarks {
 public:
  SelectionMarks(Canvas& canvas, const DrawnPicture& picture, const BesideAtoms& beside)
      : canvas_(canvas), picture_(picture), beside_(beside) {}

  // Draws items in the colour of the selection, even when balls are switched off.
  void set(const SelectedItems& selected);
  // Call after a change of radii or colours.
  void draw();
  // Call when the scene has dropped its marks.
  void forget() { selected_ = {}; }

  // The items as balls, with the radii of the geometry and not as drawn.
  BallGeometry places(const SelectedItems& items) const;

 private:
  Canvas& canvas_;
  const DrawnPicture& picture_;
  const BesideAtoms& beside_;
  SelectedItems selected_;
};

}  // namespace alphascope
