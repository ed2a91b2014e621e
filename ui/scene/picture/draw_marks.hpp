// SPDX-License-Identifier: GPL-3.0-or-later
// Draws caption, legend, scale bar and labels into a saved picture, at its own resolution. Texts
// have the window's font. All else is filled boxes, so the scene's light and transparency do not
// change a legend's colours.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/document/picture/picture_options.hpp"
#include "ui/colour_legend.hpp"
#include "ui/picture_marks.hpp"
#include "ui/scene/picture/frame_grab.hpp"
#include "ui/scene/picture/placed_label.hpp"
#include "ui/scene/scene.hpp"

namespace alphascope {

struct PictureMarks {
  std::vector<ColourLegend> legends;
  std::optional<double> angstrom_per_pixel;  // none: no scale bar
  std::vector<PictureLabel> labels = {};
  std::vector<std::string> caption = {};  // ui/caption.hpp; empty: none
  float letters = 1;                      // factor on the size of all marks
};

// Colours of marks and of the rims that keep them readable on any background.
struct MarkColours {
  Colour mark, rim;
};
// Colours for a picture of this theme or background. A transparent picture gets the light theme's,
// since it is mostly put on paper.
MarkColours mark_colours(Theme theme, const PictureBackground& background = {});

// Pixels of the picture for each pixel of the window at scale 1. Marks grow with the picture.
float mark_unit(int width, int height);

// Returns a sentence for each mark that has no room in the picture; empty: all are drawn.
std::string draw_marks(Image& image, const PictureMarks& marks, const MarkColours& ink);

// Blends the colour over the image, in proportion to the mask's coverage.
struct MarkMask;
void blend(Image& image, const MarkMask& mask, const Colour& colour);

struct MarkedPicture {
  int width = 0, height = 0;          // pixels
  int dpi = 0;                        // dots per inch, for the file; 0: it states none
  PictureBackground background = {};  // as that of the scene's style
  float letters = 1;                  // as in PictureMarks
  Theme theme = Theme::dark;
  std::vector<ColourLegend> legends;
  bool scale_bar = false;
  std::vector<PlacedLabel> labels = {};
  Cut cut = {};                           // the scene's
  std::vector<std::string> caption = {};  // empty: none
};
// Draws the scene, as it is now, with its marks. Appends to `left_out` the sentences of
// draw_marks(). Throws as Scene::grab() does.
Image marked_image(Scene& scene, const MarkedPicture& picture, std::string& left_out,
                   const RunContext& context);

// Draws the same as the bytes of a PNG file.
std::string picture_bytes(Scene& scene, const MarkedPicture& picture, const PictureTexts& texts,
                          std::string& left_out, const RunContext& context);

// Draws the same and writes it to a file. Returns the sentences of draw_marks(). Throws as
// Scene::grab() and write_png() do. Reports its steps, and can be cancelled between them.
std::string write_picture(Scene& scene, const MarkedPicture& picture,
                          const std::filesystem::path& path, const PictureTexts& texts,
                          const RunContext& context = {});

}  // namespace alphascope
