// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a flat drawing as SVG, and defines the colours of its shapes.
#include "core/chart/flat_svg.hpp"

#include <cstdio>

#include "core/chart/xml_text.hpp"
#include "core/geometry/lattice_alpha.hpp"

namespace alphascope {
namespace {

constexpr FlatColour kNone{};

FlatColour ink(std::uint32_t rgb, double opacity = 1) {
  return {static_cast<std::uint8_t>(rgb >> 16), static_cast<std::uint8_t>(rgb >> 8 & 255),
          static_cast<std::uint8_t>(rgb & 255), opacity};
}

template <class... Args>
std::string format(const char* pattern, Args... args) {
  char text[256];
  std::snprintf(text, sizeof text, pattern, args...);
  return text;
}

std::string paint(const char* what, const FlatColour& ink) {
  if (ink.opacity <= 0) return format(" %s=\"none\"", what);
  std::string text = format(" %s=\"#%02x%02x%02x\"", what, ink.r, ink.g, ink.b);
  if (ink.opacity < 1) text += format(" %s-opacity=\"%.2f\"", what, ink.opacity);
  return text;
}

class Writer {
 public:
  explicit Writer(const FlatPage& page)
      : page_(page), scale_(page.width_pixels / page.box.width()) {}

  double height() const { return page_.box.height() * scale_; }

  std::string shape(const FlatShape& shape) const {
    const FlatStyle style = flat_style(shape.kind);
    const std::string looks = paint("fill", style.fill) + paint("stroke", style.line) +
                              format(" stroke-width=\"%.1f\"", style.line_width) +
                              (style.dashed ? " stroke-dasharray=\"6 4\"/>\n" : "/>\n");
    if (shape.points.size() == 1) {
      const double radius = style.dot_radius > 0 ? style.dot_radius : shape.radius * scale_;
      return format("<circle cx=\"%.3f\" cy=\"%.3f\" r=\"%.3f\"", x(shape.points[0]),
                    y(shape.points[0]), radius) +
             looks;
    }
    std::string points;
    for (const FlatPoint& p : shape.points) points += format("%.3f,%.3f ", x(p), y(p));
    points.pop_back();
    return "<polygon points=\"" + points + "\"" + looks;
  }

 private:
  double x(const FlatPoint& p) const { return (p[0] - page_.box.low[0]) * scale_; }
  double y(const FlatPoint& p) const { return (page_.box.high[1] - p[1]) * scale_; }

  const FlatPage& page_;
  double scale_;  // pixels per Å
};

}  // namespace

// As in the scene, blue is for shapes that grow with alpha and green for the complex. The power
// diagram is grey.
FlatStyle flat_style(FlatKind kind, bool dark) {
  const auto either = [dark](std::uint32_t on_dark, std::uint32_t on_white) {
    return dark ? on_dark : on_white;
  };
  switch (kind) {
    case FlatKind::grown_disc:
      return {ink(either(0x5aa9e6, 0x2f81c4), 0.16), ink(either(0x5aa9e6, 0x2f81c4), 0.55), 1.2};
    case FlatKind::cell:
      return {kNone, ink(either(0x8b949e, 0x6e7781), 0.9), 1, true};
    case FlatKind::triangle:
      return {ink(either(0x57c78a, 0x2da160), 0.35), kNone, 0};
    case FlatKind::edge_inside:
      return {kNone, ink(either(0x57c78a, 0x1a7f45), 0.8), 1.4};
    case FlatKind::edge_boundary:
      return {kNone, ink(either(0x7ee2a8, 0x116235)), 2.8};
    case FlatKind::edge_alone:
      return {kNone, ink(either(0xe3b341, 0xb07700)), 2.4};
    case FlatKind::ball:
      return {kNone, ink(either(0xc9d1d9, 0x24292f), 0.85), 1.3};
    case FlatKind::empty_ball:
      return {kNone, ink(either(0x8b949e, 0x6e7781), 0.7), 1.2, true};
    case FlatKind::vertex:
      return {ink(either(0xe6edf3, 0x1b1f24)), kNone, 0, false, 4};
    case FlatKind::no_vertex:
      return {ink(either(0x0d1117, 0xffffff)), ink(either(0x8b949e, 0x6e7781)), 1.4, false, 3.5};
    case FlatKind::orthocircle:
      return {kNone, ink(either(0xff7b72, 0xc62828)), 1.8};
    case FlatKind::orthocentre:
      return {ink(either(0xff7b72, 0xc62828)), kNone, 0, false, 3};
  }
  return {};
}

std::string flat_svg(const std::vector<FlatShape>& shapes, const FlatPage& page) {
  constexpr double kFont = 15, kLine = 21;  // pixels
  const Writer writer(page);
  const double captions = page.caption.empty() ? 0 : kLine * (page.caption.size() + 0.5);
  std::string svg = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  svg += format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" "
      "viewBox=\"0 0 %.0f %.0f\" font-family=\"sans-serif\" font-size=\"%.0f\">\n",
      page.width_pixels, writer.height() + captions, page.width_pixels, writer.height() + captions,
      kFont);
  std::string origin;
  for (const auto& [name, value] : page.origin) {
    origin += xml_text(name) + ": " + xml_text(value) + "\n";
  }
  if (!origin.empty()) svg += "<desc>" + origin + "</desc>\n";
  svg += "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  // Cells end at the border of the drawing, whose line does not belong to them. So the drawing is
  // clipped.
  svg += format("<clipPath id=\"page\"><rect width=\"%.3f\" height=\"%.3f\"/></clipPath>\n",
                page.width_pixels, writer.height());
  svg += "<g clip-path=\"url(#page)\" stroke-linejoin=\"round\">\n";
  for (const FlatShape& shape : shapes) svg += writer.shape(shape);
  svg += "</g>\n";
  for (std::size_t i = 0; i < page.caption.size(); ++i) {
    svg += format("<text x=\"10\" y=\"%.1f\" fill=\"#1b1f24\">",
                  writer.height() + kLine * (static_cast<double>(i) + 0.9)) +
           xml_text(page.caption[i]) + "</text>\n";
  }
  return svg + "</svg>\n";
}

}  // namespace alphascope
