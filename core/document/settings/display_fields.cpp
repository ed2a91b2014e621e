// The table of the settings of the display, and access to their values by row.
#include "core/document/settings/display_fields.hpp"

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <type_traits>

#include "core/geometry/shortest_number.hpp"

namespace alphascope {
namespace {

using D = DisplayControls;

constexpr const char* kTransparency = "transparency transparent translucent";

constexpr DisplayField kFields[] = {
    {.id = "balls",
     .key = "balls",
     .member = &D::balls,
     .group = DisplayGroup::balls,
     .title = "Balls",
     .label = "Balls",
     .help = "Shows or hides the atoms as balls",
     .command = "view.balls",
     .option = {"--no-balls", "Without the balls", false},
     .menu = "View",
     .line_above = true,
     .shortcut = "B",
     .synonyms = "atoms spheres"},
    {.id = "tetrahedra",
     .key = "tetrahedra",
     .member = &D::tetrahedra,
     .group = DisplayGroup::complex,
     .title = "Tetrahedra",
     .label = "Tetrahedra",
     .help = "Shows or hides the tetrahedra of the complex",
     .command = "view.tetrahedra",
     .menu = "View",
     .shortcut = "T"},
    {.id = "boundary",
     .key = "boundary",
     .member = &D::boundary,
     .group = DisplayGroup::complex,
     .title = "Boundary surface",
     .label = "Boundary surface",
     .help = "Shows or hides faces that belong to exactly one tetrahedron",
     .command = "view.boundary",
     .option = {"--boundary", "Only the boundary of the tetrahedra"},
     .menu = "View",
     .synonyms = "mesh skin"},
    {.id = "triangles",
     .key = "triangles",
     .member = &D::triangles,
     .group = DisplayGroup::complex,
     .title = "Triangles",
     .label = "Triangles",
     .help = "Shows or hides triangles of the complex",
     .command = "view.triangles",
     .needs_whole_complex = true,
     .menu = "View"},
    {.id = "edges",
     .key = "edges",
     .member = &D::edges,
     .group = DisplayGroup::complex,
     .title = "Edges",
     .label = "Edges",
     .help = "Shows or hides edges of the complex",
     .command = "view.edges",
     .needs_whole_complex = true,
     .menu = "View",
     .shortcut = "E"},
    {.id = "singular_only",
     .key = "singular_only",
     .member = &D::singular_only,
     .group = DisplayGroup::complex,
     .title = "Singular ones only",
     .label = "Singular ones only",
     .help = "Shows only triangles and edges that are not faces of a larger simplex",
     .command = "view.singular_only",
     .needs_whole_complex = true},
    {.id = "grown_balls",
     .key = "grown_balls",
     .member = &D::grown_balls,
     .group = DisplayGroup::balls,
     .title = "Grown balls",
     .label = "Radius",
     .help = "Draws balls with the radii that solvent and alpha give them",
     .command = "view.grown_balls",
     .option = {"--grown", "Draw balls with the radii that solvent and alpha give them"},
     .kept_by_presets = true},
    {.id = "ball_scale",
     .key = "ball_scale",
     .member = &D::ball_scale,
     .group = DisplayGroup::balls,
     .title = "Size of balls",
     .label = "Size",
     .help = "Share of its radius with which a ball is drawn",
     .command = "view.ball_size",
     .option = {"--ball-size"},
     .rule = {"The size of balls", 0.05, 1},
     .step = 0.01,
     .percent = true},
    {.id = "ball_opacity",
     .key = "ball_opacity",
     .member = &D::ball_opacity,
     .group = DisplayGroup::balls,
     .title = "Opacity of balls",
     .label = "Opacity",
     .help = "How opaque balls are; 1: nothing shines through",
     .command = "view.ball_opacity",
     .option = {"--ball-opacity"},
     .rule = {"The opacity of balls", 0.05, 1},
     .step = 0.01,
     .percent = true,
     .synonyms = kTransparency},
    {.id = "complex_opacity",
     .key = "complex_opacity",
     .member = &D::complex_opacity,
     .group = DisplayGroup::complex,
     .title = "Opacity of simplices",
     .label = "Opacity",
     .help = "How opaque tetrahedra, triangles and boundary are; 1: nothing shines through",
     .command = "view.complex_opacity",
     .option = {"--complex-opacity"},
     .rule = {"The opacity of simplices", 0.05, 1},
     .step = 0.01,
     .percent = true,
     .synonyms = kTransparency},
    {.id = "cavity_opacity",
     .key = "cavity_opacity",
     .member = &D::cavity_opacity,
     .group = DisplayGroup::cavities,
     .title = "Opacity of cavities",
     .label = "Opacity",
     .help = "How opaque chosen cavities are; below 1 their contents shine through",
     .command = "view.cavity_opacity",
     .rule = {"The opacity of cavities", 0.05, 1},
     .step = 0.01,
     .percent = true,
     .kept_by_presets = true,
     .synonyms = kTransparency},
    {.id = "shrink",
     .key = "shrink",
     .member = &D::shrink,
     .group = DisplayGroup::complex,
     .title = "Shrink tetrahedra",
     .label = "Shrink",
     .help = "Share by which each tetrahedron is smaller, apart from its neighbours",
     .command = "view.shrink",
     .option = {"--shrink"},
     .rule = {"The shrinking", 0, 0.9},
     .step = 0.01,
     .percent = true},
    {.id = "edge_thickness",
     .key = "edge_thickness_angstrom",
     .member = &D::edge_thickness,
     .group = DisplayGroup::complex,
     .title = "Thickness of edges",
     .label = "Thickness",
     .help = "Thickness of edges in Å; far away they are at least as thick as a thin line",
     .command = "view.edge_thickness",
     .option = {"--edge-thickness"},
     .rule = {"The thickness of edges", 0.02, 1, "Å"},
     .step = 0.02,
     .slider_most = 0.6},
    {.id = "smooth_boundary",
     .key = "smooth_boundary",
     .member = &D::smooth_boundary,
     .group = DisplayGroup::complex,
     .title = "Smooth boundary",
     .label = "Smooth",
     .help = "Lights the boundary as if it were round between its corners; its shape stays",
     .command = "view.smooth_boundary",
     .option = {"--smooth", "Light the boundary as if it were round between its corners"}},
    {.id = "ball_colour",
     .key = "ball_colour",
     .member = &D::ball_paint,
     .group = DisplayGroup::balls,
     .title = "Colours of balls",
     .label = "Colour by",
     .help = "Chooses what the colours of balls mean",
     .command = "view.colour_balls",
     .painted = Painted::balls,
     .kept_by_presets = true,
     .menu = "View",
     .line_above = true,
     .synonyms = "color colour by"},
    {.id = "complex_colour",
     .key = "complex_colour",
     .member = &D::complex_paint,
     .group = DisplayGroup::complex,
     .title = "Colours of simplices",
     .label = "Colour by",
     .help = "Chooses what the colours of simplices mean",
     .command = "view.colour_simplices",
     .painted = Painted::simplices,
     .kept_by_presets = true,
     .menu = "View",
     .synonyms = "color colour by"},
    {.id = "shadows",
     .key = "ambient_occlusion",
     .member = &D::ambient_occlusion,
     .group = DisplayGroup::light,
     .title = "Soft shadows at rest",
     .label = "Soft shadows at rest",
     .help = "Darkens crevices, and casts shadows, while the view is at rest",
     .command = "view.shadows",
     .option = {"--no-shadows", "Without soft shadows", false}},
    {.id = "depth_cue",
     .key = "depth_cue",
     .member = &D::depth_cue,
     .group = DisplayGroup::light,
     .title = "Depth cue",
     .label = "Depth cue",
     .help = "Share of the background's colour in the farthest things; 0: nothing fades",
     .command = "view.depth_cue",
     .option = {"--depth-cue"},
     .rule = {"The depth cue", 0, 1},
     .step = 0.01,
     .percent = true},
    {.id = "outlines",
     .key = "outlines_pixels",
     .member = &D::outlines,
     .group = DisplayGroup::light,
     .title = "Outlines",
     .label = "Outlines",
     .help = "Width of the dark lines where one thing is far before another, in pixels; 0: none",
     .command = "view.outlines",
     .option = {"--outlines", "Width of outlines in pixels of a picture of 1280x800; they grow with "
                              "the size"},
     .rule = {"The width of outlines", 0, 4, "pixels"},
     .step = 0.25,
     .former_key = "silhouettes_pixels"},
    {.id = "face_lines",
     .key = "face_lines_pixels",
     .member = &D::face_lines,
     .group = DisplayGroup::light,
     .title = "Face lines",
     .label = "Face lines",
     .help = "Width of the darker lines between triangles that are large enough, in pixels; 0: none",
     .command = "view.face_lines",
     .option = {"--face-lines", "Width of the darker lines around faces, likewise"},
     .rule = {"The width of face lines", 0, 4, "pixels"},
     .step = 0.25,
     .former_key = "face_edges_pixels"},
    {.id = "samples",
     .key = "samples",
     .member = &D::samples,
     .group = DisplayGroup::light,
     .title = "Samples a pixel",
     .label = "Samples",
     .help = "Number of pictures that are averaged at rest and in saved pictures, for smooth edges "
             "and shadows",
     .command = "view.samples",
     .option = {"--samples"},
     .rule = {"The number of samples", 1, 16, "", true},
     .step = 1},
    {.id = "orthographic",
     .key = "orthographic",
     .member = &D::orthographic,
     .group = DisplayGroup::projection,
     .title = "Orthographic",
     .label = "Orthographic",
     .help = "Draws without perspective: far things are not smaller",
     .command = "view.orthographic",
     .option = {"--orthographic", "Draw without perspective"},
     .kept_by_presets = true,
     .menu = "View",
     .shortcut = "O"}};

template <class Value>
constexpr bool kIsPaint = std::is_same_v<std::remove_cvref_t<Value>, Paint>;

bool same(const DisplayField& field, const DisplayControls& a, const DisplayControls& b) {
  return std::visit([&](auto member) { return a.*member == b.*member; }, field.member);
}

std::string text_of(bool value) {
  return value ? "on" : "off";
}
std::string text_of(float value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}
std::string text_of(int value) {
  return std::to_string(value);
}
std::string text_of(const Paint& value) {
  return paint_text(value);
}

}  // namespace

std::span<const DisplayField> display_fields() {
  return kFields;
}

const DisplayField& display_field(DisplayField::Member member) {
  for (const DisplayField& field : kFields) {
    if (field.member == member) return field;
  }
  throw std::logic_error("a setting of the display has no row in the table");
}

bool is_switch(const DisplayField& field) {
  return std::holds_alternative<bool D::*>(field.member);
}

bool is_paint(const DisplayField& field) {
  return std::holds_alternative<Paint D::*>(field.member);
}

bool is_number(const DisplayField& field) {
  return !is_switch(field) && !is_paint(field);
}

double number_of(const DisplayField& field, const DisplayControls& display) {
  return std::visit(
      [&](auto member) -> double {
        if constexpr (kIsPaint<decltype(display.*member)>) {
          throw std::logic_error("a paint is no number");
        } else {
          return static_cast<double>(display.*member);
        }
      },
      field.member);
}

void set_number(const DisplayField& field, DisplayControls& display, double value) {
  std::visit(
      [&](auto member) {
        using Value = std::remove_cvref_t<decltype(display.*member)>;
        if constexpr (kIsPaint<Value>) {
          throw std::logic_error("a paint is no number");
        } else if constexpr (std::is_same_v<Value, int>) {
          display.*member = static_cast<int>(std::lround(value));
        } else if constexpr (std::is_same_v<Value, bool>) {
          display.*member = value != 0;
        } else {
          display.*member = static_cast<Value>(value);
        }
      },
      field.member);
}

std::string value_text(const DisplayField& field, const DisplayControls& display) {
  return std::visit([&](auto member) { return text_of(display.*member); }, field.member);
}

std::string range_text(const DisplayField& field) {
  const NumberRule& rule = field.rule;
  return shortest_number(rule.least) + " to " + shortest_number(rule.most);
}

std::string name_of(const DisplayField& field) {
  std::string name = field.title;
  name.front() = static_cast<char>(name.front() - 'A' + 'a');
  return name;
}

void copy_group(DisplayGroup group, const DisplayControls& from, DisplayControls& to) {
  for (const DisplayField& field : kFields) {
    if (field.group != group) continue;
    std::visit([&](auto member) { to.*member = from.*member; }, field.member);
  }
}

std::string difference_of(const DisplayControls& a, const DisplayControls& b) {
  if (a == b) return {};
  std::string name;
  const auto note = [&name](const std::string& differs) {
    name = name.empty() ? differs : "display";
  };
  for (const DisplayField& field : kFields) {
    if (!same(field, a, b)) note(name_of(field));
  }
  if (a.beside != b.beside) note("atoms beside the body");
  return name;
}

}  // namespace alphascope
