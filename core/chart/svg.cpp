// Writes charts as SVG files.
#include "core/chart/svg.hpp"

#include <cstdio>
#include <list>

#include "core/chart/layout.hpp"
#include "core/chart/xml_text.hpp"
#include "core/files/atomic_file.hpp"

namespace alphascope {
namespace {

// Width of a sans-serif letter as a share of its height, a high estimate. The reader's font is
// unknown.
constexpr float kLetterWidth = 0.56f, kFont = 13;

float estimated_width(const std::string& text) {
  std::size_t letters = 0;
  for (const char c : text) letters += (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  return static_cast<float>(letters) * kLetterWidth * kFont;
}

template <class... Args>
std::string format(const char* pattern, Args... args) {
  char text[256];
  std::snprintf(text, sizeof text, pattern, args...);
  return text;
}

std::string hex(ChartColour c) {
  return format("#%02x%02x%02x", c.r, c.g, c.b);
}

const char* colour(ChartInk ink) {
  switch (ink) {
    case ChartInk::text:
      return "#1b1f24";
    case ChartInk::muted:
      return "#57606a";
    case ChartInk::grid:
      return "#dfe3e8";
    case ChartInk::axis:
      return "#6e7781";
  }
  return "#000000";
}

const char* anchor(ChartAnchor a) {
  return a == ChartAnchor::start ? "start" : a == ChartAnchor::middle ? "middle" : "end";
}

std::string svg_line(const ChartLine& l) {
  const std::string stroke = l.series ? hex(chart_colour(*l.series)) : colour(l.ink);
  return format("<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\" ",
                static_cast<double>(l.x0), static_cast<double>(l.y0), static_cast<double>(l.x1),
                static_cast<double>(l.y1), stroke.c_str()) +
         (l.series ? "stroke-width=\"2\"" : "stroke-width=\"1\"") +
         (l.dashed ? " stroke-dasharray=\"5 4\"/>\n" : "/>\n");
}

std::string svg_text(const ChartText& t) {
  return format("<text x=\"%.1f\" y=\"%.1f\" fill=\"%s\" text-anchor=\"%s\"",
                static_cast<double>(t.x), static_cast<double>(t.y + kFont * 0.36f), colour(t.ink),
                anchor(t.anchor)) +
         (t.title ? " font-weight=\"bold\">" : ">") + xml_text(t.text) + "</text>\n";
}

}  // namespace

std::string chart_svg(const Chart& chart, float width) {
  const ChartDrawing d = lay_out(chart, width, {kFont, estimated_width});
  std::string svg = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  svg += format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" "
      "viewBox=\"0 0 %.0f %.0f\" font-family=\"sans-serif\" font-size=\"%.0f\">\n",
      static_cast<double>(d.width), static_cast<double>(d.height), static_cast<double>(d.width),
      static_cast<double>(d.height), static_cast<double>(kFont));
  svg += "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  for (const ChartLine& l : d.lines) svg += svg_line(l);
  for (const ChartBox& b : d.boxes) {
    svg += format("<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"%s\">",
                  static_cast<double>(b.x), static_cast<double>(b.y), static_cast<double>(b.width),
                  static_cast<double>(b.height), hex(chart_colour(b.series)).c_str()) +
           "<title>" + xml_text(b.tip) + "</title></rect>\n";
  }
  for (const ChartDot& p : d.dots) {
    svg +=
        format("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3.5\" fill=\"%s\">", static_cast<double>(p.x),
               static_cast<double>(p.y), hex(chart_colour(p.series)).c_str()) +
        "<title>" + xml_text(p.tip) + "</title></circle>\n";
  }
  for (const ChartText& t : d.texts) svg += svg_text(t);
  return svg + "</svg>\n";
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
