// Caption, legend, scale bar and labels in a saved picture, in its own pixels: not a stretched copy
// of the window's. The text is in the window's letters; the rest is boxes, filled here, so that a
// legend's colours are exactly those of the scale, whatever light and transparency the scene is
// drawn with.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

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
};

// Marks and a rim around them that keeps them readable over anything.
struct MarkInk {
  Colour mark, rim;
};
// Without a background the picture may be put on any; most are paper.
MarkInk mark_ink(Theme theme, bool transparent);

// Pixels of a picture for one of the window at scale 1: marks grow with the picture.
float mark_unit(int width, int height);

// Returns a sentence when the picture is too small for what was asked for; empty: all is drawn.
std::string draw_marks(Image& image, const PictureMarks& marks, const MarkInk& ink);

// Over the image, as far as the mask covers it.
struct MarkMask;
void blend(Image& image, const MarkMask& mask, const Colour& colour);

struct MarkedPicture {
  int width = 0, height = 0;  // pixels
  bool transparent = false;
  Theme theme = Theme::dark;
  std::vector<ColourLegend> legends;
  bool scale_bar = false;
  std::vector<PlacedLabel> labels = {};
  Cut cut = {};                           // of the scene
  std::vector<std::string> caption = {};  // words; empty: none
};
// The scene with its marks, as it is now. Appends to `left_out` what draw_marks() says. Throws as
// Scene::grab().
Image marked_image(Scene& scene, const MarkedPicture& picture, std::string& left_out,
                   const RunContext& context);

// Writes the same to a file; returns and throws as draw_marks(), Scene::grab() and
// write_png() do. Says what it is doing, and can be cancelled between its steps.
std::string write_picture(Scene& scene, const MarkedPicture& picture,
                          const std::filesystem::path& path, const PictureTexts& texts,
                          const RunContext& context = {});

}  // namespace alphascope
