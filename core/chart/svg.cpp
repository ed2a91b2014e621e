// SPDX-License-Identifier: GPL-3.0-or-later
// Writes charts and plots as SVG.
#include "core/chart/svg.hpp"

#include <cstdio>
#include <list>

#include "core/chart/layout.hpp"
#include "core/chart/plot.hpp"
#include "core/chart/xml_text.hpp"
#include "core/files/atomic_file.hpp"
#include "core/molecule/rgb8.hpp"
#include "core/text/utf8.hpp"

namespace alphascope {
namespace {

// Width of a sans-serif letter as a share of its height, a high estimate. The reader's font is
// unknown.
constexpr float kLetterWidth = 0.56f, kFont = 13;

float estimated_width(const std::string& text) {
  return static_cast<float>(character_count(text)) * kLetterWidth * kFont;
}

template <class... Args>
std::string format(const char* pattern, Args... args) {
  char text[256];
  std::snprintf(text, sizeof text, pattern, args...);
  return text;
}

std::string hex(const Rgb8& c) {
  return format("#%02x%02x%02x", c.r, c.g, c.b);
}

const char* colour(ChartColourRole ink) {
  switch (ink) {
    case ChartColourRole::text:
      return "#1b1f24";
    case ChartColourRole::muted:
      return "#57606a";
    case ChartColourRole::grid:
      return "#dfe3e8";
    case ChartColourRole::axis:
      return "#6e7781";
    case ChartColourRole::accent:
      return "#0969da";
    case ChartColourRole::ground:
      return "#ffffff";
  }
  return "#000000";
}

const char* anchor(ChartAnchor a) {
  return a == ChartAnchor::start ? "start" : a == ChartAnchor::middle ? "middle" : "end";
}

std::string colour(const ChartPaint& paint) {
  return paint.colour ? hex(*paint.colour) : colour(paint.ink);
}

// An attribute such as " fill-opacity"; nothing where the colour is opaque.
std::string opacity(const char* attribute, const ChartPaint& paint) {
  return paint.opacity < 1 ? format(" %s=\"%.2f\"", attribute, static_cast<double>(paint.opacity))
                           : "";
}

std::string svg_line(const ChartLine& l) {
  return format("<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\"%s ",
                static_cast<double>(l.x0), static_cast<double>(l.y0), static_cast<double>(l.x1),
                static_cast<double>(l.y1), colour(l.paint).c_str(),
                opacity("stroke-opacity", l.paint).c_str()) +
         format("stroke-width=\"%g\"", static_cast<double>(l.width)) +
         (l.dashed ? " stroke-dasharray=\"5 4\"/>\n" : "/>\n");
}

std::string svg_box(const ChartBox& b) {
  const std::string paint =
      b.filled ? "fill=\"" + colour(b.paint) + "\"" + opacity("fill-opacity", b.paint)
               : "fill=\"none\" stroke=\"" + colour(b.paint) + "\"";
  return format("<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" %s>",
                static_cast<double>(b.x), static_cast<double>(b.y), static_cast<double>(b.width),
                static_cast<double>(b.height), paint.c_str()) +
         "<title>" + xml_text(b.tip) + "</title></rect>\n";
}

std::string svg_path(const ChartPath& p) {
  std::string points;
  for (const ChartPoint& point : p.points) {
    points += format("%.1f,%.1f ", static_cast<double>(point.x), static_cast<double>(point.y));
  }
  if (!points.empty()) points.pop_back();
  return "<polyline points=\"" + points +
         format("\" fill=\"none\" stroke=\"%s\"%s stroke-width=\"%g\"/>\n", colour(p.paint).c_str(),
                opacity("stroke-opacity", p.paint).c_str(), static_cast<double>(p.width));
}

std::string svg_dot(const ChartDot& d) {
  const std::string paint = d.ring ? "#ffffff\" stroke=\"" + colour(d.paint) : colour(d.paint);
  return format("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" fill=\"%s\">", static_cast<double>(d.x),
                static_cast<double>(d.y), static_cast<double>(d.radius), paint.c_str()) +
         "<title>" + xml_text(d.tip) + "</title></circle>\n";
}

std::string svg_text(const ChartText& t) {
  return format("<text x=\"%.1f\" y=\"%.1f\" fill=\"%s\" text-anchor=\"%s\"",
                static_cast<double>(t.x), static_cast<double>(t.y + kFont * 0.36f), colour(t.ink),
                anchor(t.anchor)) +
         (t.title ? " font-weight=\"bold\">" : ">") + xml_text(t.text) + "</text>\n";
}

}  // namespace

std::string drawing_svg(const ChartDrawing& d) {
  std::string svg = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  svg += format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" "
      "viewBox=\"0 0 %.0f %.0f\" font-family=\"sans-serif\" font-size=\"%.0f\">\n",
      static_cast<double>(d.width), static_cast<double>(d.height), static_cast<double>(d.width),
      static_cast<double>(d.height), static_cast<double>(kFont));
  svg += "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  for (const ChartLine& line : d.lines) svg += svg_line(line);
  for (const ChartBox& box : d.boxes) svg += svg_box(box);
  for (const ChartPath& path : d.paths) svg += svg_path(path);
  for (const ChartDot& dot : d.dots) svg += svg_dot(dot);
  for (const ChartText& text : d.texts) svg += svg_text(text);
  return svg + "</svg>\n";
}

std::string chart_svg(const Chart& chart, float width) {
  return drawing_svg(lay_out(chart, width, {kFont, estimated_width}));
}

std::string plot_svg(const Plot& plot, const std::string& title, float width) {
  const ChartFont type{kFont, estimated_width};
  constexpr float kLeft = 70, kRight = 20, kRow = 1.5f * kFont, kBelow = 3.2f * kFont;
  ChartDrawing legend;
  float y = kRow;
  legend.texts.push_back({kFont, y, title, ChartColourRole::text, ChartAnchor::start, true});
  y += kRow;
  float x = kFont;
  for (const PlotCurve& curve : plot.curves) {
    if (curve.name.empty()) continue;
    const float needed = 1.5f * kFont + estimated_width(curve.name);
    if (x > kFont && x + needed > width - kFont) {
      x = kFont;
      y += kRow;
    }
    legend.boxes.push_back({x, y - 5, 10, 10, curve.paint, curve.name});
    legend.texts.push_back({x + 1.2f * kFont, y, curve.name});
    x += needed + kFont;
  }
  const float top = y + 1.5f * kRow, bottom = top + 0.45f * width;
  const PlotArea area{kLeft, top, width - kRight, bottom, plot.x.range, plot.y.range};
  ChartDrawing drawing = lay_out(plot, area, type);
  drawing.width = width;
  drawing.height = bottom + kBelow;
  drawing.boxes.insert(drawing.boxes.end(), legend.boxes.begin(), legend.boxes.end());
  drawing.texts.insert(drawing.texts.end(), legend.texts.begin(), legend.texts.end());
  return drawing_svg(drawing);
}

std::vector<std::filesystem::path> write_charts(const std::vector<Chart>& charts,
                                                const std::filesystem::path& folder) {
  make_output_folder(folder);
  std::vector<std::filesystem::path> paths;
  std::list<AtomicFile> files;
  std::vector<AtomicFile*> all;
  for (const Chart& chart : charts) {
    paths.push_back(folder / (chart.id + ".svg"));
    all.push_back(&files.emplace_back(paths.back()));
    all.back()->write(chart_svg(chart));
  }
  commit_together(all);
  return paths;
}

}  // namespace alphascope
