// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the complex that was computed last as a flat drawing. Balls moved since then have an
// outline at their new place. The mouse moves, resizes and adds balls.
#include "ui/panels/sandbox/flat_view.hpp"

#include <algorithm>
#include <cmath>

#include "core/chart/colour_scale.hpp"
#include "core/chart/flat_svg.hpp"
#include "core/document/reference/ref_set.hpp"
#include "core/document/settings/open_options.hpp"
#include "core/document/settings/request.hpp"
#include "core/document/store/answer.hpp"
#include "core/molecule/sandbox.hpp"
#include "core/selection/prepare_balls.hpp"
#include "ui/number_text.hpp"
#include "ui/panels/sandbox/sandbox_edit.hpp"
#include "ui/panels/sandbox/sandbox_state.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/panels/viewport_info.hpp"
#include "ui/theme.hpp"

namespace alphascope {
namespace {

// Pixels at scale 1; the mouse takes centres and rims within this distance.
constexpr float kReach = 7;
constexpr double kZoomStep = 1.15;                          // factor for a notch of the wheel
constexpr double kLeastPixels = 0.05, kMostPixels = 20000;  // pixels for 1 Å

ImU32 colour(const FlatColour& ink) {
  return IM_COL32(ink.r, ink.g, ink.b, static_cast<int>(std::lround(255 * ink.opacity)));
}

// Converts between the paper (Å, y upwards) and the window (pixels).
class Paper {
 public:
  Paper(PanelContext& ctx, ImVec2 corner, ImVec2 size)
      : memory_(ctx.state.sandbox), corner_(corner), size_(size) {}

  void fit(const FlatBox& box) {
    memory_.middle = {(box.low[0] + box.high[0]) / 2, (box.low[1] + box.high[1]) / 2};
    memory_.pixels_per_angstrom = std::clamp(
        std::min(size_.x / box.width(), size_.y / box.height()), kLeastPixels, kMostPixels);
  }
  ImVec2 pixel(const FlatPoint& p) const {
    const double scale = memory_.pixels_per_angstrom;
    return {corner_.x + static_cast<float>(size_.x / 2 + (p[0] - memory_.middle[0]) * scale),
            corner_.y + static_cast<float>(size_.y / 2 - (p[1] - memory_.middle[1]) * scale)};
  }
  FlatPoint place(ImVec2 pixel) const {
    const double scale = memory_.pixels_per_angstrom;
    return {memory_.middle[0] + (pixel.x - corner_.x - size_.x / 2) / scale,
            memory_.middle[1] - (pixel.y - corner_.y - size_.y / 2) / scale};
  }
  float pixels(double angstrom) const {
    return static_cast<float>(angstrom * memory_.pixels_per_angstrom);
  }
  // Zooms, and keeps the place under the mouse.
  void zoom(ImVec2 mouse, double factor) {
    const FlatPoint before = place(mouse);
    memory_.pixels_per_angstrom =
        std::clamp(memory_.pixels_per_angstrom * factor, kLeastPixels, kMostPixels);
    const FlatPoint after = place(mouse);
    for (int d = 0; d < 2; ++d) memory_.middle[d] += before[d] - after[d];
  }
  // Returns a box a little larger than the visible one, so that no cell ends in sight.
  FlatBox box() const {
    constexpr float kBeyond = 8;
    const FlatPoint low = place({corner_.x - kBeyond, corner_.y + size_.y + kBeyond});
    return {low, place({corner_.x + size_.x + kBeyond, corner_.y - kBeyond})};
  }

 private:
  SandboxState& memory_;
  ImVec2 corner_, size_;
};

bool same(const FlatBox& a, const FlatBox& b) {
  return a.low == b.low && a.high == b.high;
}

bool same(const FlatContent& a, const FlatContent& b) {
  return a.discs == b.discs && a.cells == b.cells && a.complex == b.complex && a.chosen == b.chosen;
}

// Makes the shapes if the complex on screen is flat. It may lag behind the sandbox, and not be flat
// yet.
void make_shapes(ViewState& state, const FlatBox& box) {
  SandboxState& m = state.sandbox;
  if (!state.result || !is_flat(*state.result->balls)) {
    m.shapes.clear();
    m.shapes_of = nullptr;
    return;
  }
  FlatContent content = m.content;
  content.chosen = selected_balls(state);
  const std::size_t balls = state.result->balls->size();
  std::erase_if(content.chosen, [balls](BallIndex ball) { return ball >= balls; });
  const bool known =
      m.shapes_of == state.result && same(m.shapes_box, box) && same(m.shapes_content, content);
  if (known) return;
  m.shapes = flat_shapes(*state.result->balls, state.result->complex, box, content);
  m.shapes_of = state.result;
  m.shapes_box = box;
  m.shapes_content = content;
}

void dashed_line(ImDrawList* draw, ImVec2 a, ImVec2 b, ImU32 ink, float width, float dash) {
  const float length = std::hypot(b.x - a.x, b.y - a.y);
  const int dashes = std::min(2000, static_cast<int>(length / (2 * dash)) + 1);
  const ImVec2 step{(b.x - a.x) / length, (b.y - a.y) / length};
  for (int k = 0; k < dashes && length > 0; ++k) {
    const float from = 2 * dash * static_cast<float>(k), to = std::min(from + dash, length);
    if (from >= length) break;
    draw->AddLine({a.x + from * step.x, a.y + from * step.y},
                  {a.x + to * step.x, a.y + to * step.y}, ink, width);
  }
}

// Returns the number of sides of a polygon that replaces a circle and is nowhere farther than kOff
// from it.
int sides_of(float radius) {
  constexpr float kOff = 0.12f;  // pixels
  const double angle = std::acos(1 - kOff / std::max(radius, 1.0f));
  return std::clamp(static_cast<int>(std::ceil(M_PI / angle)), 12, 256);
}

// Fills a disc with horizontal slabs. ImGui's fans of thin triangles take several times as long in
// software OpenGL. The rim is not smooth, so the caller must draw a line over it.
void fill_disc(ImDrawList* draw, ImVec2 centre, float radius, ImU32 ink) {
  const int slabs = sides_of(radius) / 2;
  const ImVec2 uv = ImGui::GetFontTexUvWhitePixel();
  draw->PrimReserve(6 * slabs, 2 * (slabs + 1));
  const auto first = static_cast<ImDrawIdx>(draw->_VtxCurrentIdx);
  for (int k = 0; k <= slabs; ++k) {
    const double angle = M_PI * k / slabs;
    const float x = radius * static_cast<float>(std::sin(angle));
    const float y = centre.y - radius * static_cast<float>(std::cos(angle));
    draw->PrimWriteVtx({centre.x - x, y}, uv, ink);
    draw->PrimWriteVtx({centre.x + x, y}, uv, ink);
  }
  for (int k = 0; k < slabs; ++k) {
    for (const int corner : {0, 1, 2, 1, 3, 2}) {
      draw->PrimWriteIdx(static_cast<ImDrawIdx>(first + 2 * k + corner));
    }
  }
}

void draw_circle(ImDrawList* draw, const FlatStyle& style, ImVec2 centre, float radius,
                 float width) {
  constexpr float kHuge = 20000;  // pixels; a larger circle takes too many lines
  if (radius > kHuge) return;
  const bool rim = style.line.opacity > 0;
  const ImU32 fill = colour(style.fill);
  if (style.fill.opacity > 0 && rim) {
    fill_disc(draw, centre, radius, fill);
  } else if (style.fill.opacity > 0) {
    draw->AddCircleFilled(centre, radius, fill, sides_of(radius));
  }
  if (rim) draw->AddCircle(centre, radius, colour(style.line), sides_of(radius), width);
}

void draw_shape(PanelContext& ctx, const Paper& paper, const FlatShape& shape) {
  const bool dark = ctx.state.theme() == Theme::dark;
  const FlatStyle style = flat_style(shape.kind, dark);
  const ImU32 fill = colour(style.fill), line = colour(style.line);
  // Lines of whole pixels take ImGui a third of the triangles.
  const float width = std::max(1.0f, std::round(ctx.px(static_cast<float>(style.line_width))));
  ImDrawList* draw = ImGui::GetWindowDrawList();
  std::vector<ImVec2> points;
  for (const FlatPoint& p : shape.points) points.push_back(paper.pixel(p));
  const int count = static_cast<int>(points.size());
  if (count == 1) {
    const float radius = style.dot_radius > 0 ? ctx.px(static_cast<float>(style.dot_radius))
                                              : paper.pixels(shape.radius);
    return draw_circle(draw, style, points[0], radius, width);
  }
  if (style.fill.opacity > 0 && count > 2) draw->AddConvexPolyFilled(points.data(), count, fill);
  if (style.line.opacity <= 0) return;
  for (int k = 0; k < (count == 2 ? 1 : count); ++k) {
    const ImVec2 a = points[static_cast<std::size_t>(k)],
                 b = points[static_cast<std::size_t>((k + 1) % count)];
    // Two cells share each side, in opposite directions, and only one of them draws it. A side of
    // one cell only is out of sight.
    if (shape.kind == FlatKind::cell && (a.x < b.x || (a.x == b.x && a.y < b.y))) continue;
    if (style.dashed) {
      dashed_line(draw, a, b, line, width, ctx.px(4));
    } else {
      draw->AddLine(a, b, line, width);
    }
  }
}

double solvent(const ViewState& state) {
  return state.settings.request.solvent_radius_angstrom;
}

// Finds the centre or rim under the mouse. A centre precedes a rim, and the nearest wins.
void look_under(PanelContext& ctx, const Paper& paper, ImVec2 mouse) {
  SandboxState& m = ctx.state.sandbox;
  const Sandbox& sandbox = *ctx.state.settings.open.sandbox;
  m.hovered = FlatPart::paper;
  float nearest = ctx.px(kReach);
  for (const FlatPart part : {FlatPart::centre, FlatPart::rim}) {
    for (std::size_t i = 0; i < sandbox.balls.size(); ++i) {
      const SandboxPlace at = centre_of(sandbox, i);
      const ImVec2 centre = paper.pixel({at[0], at[1]});
      const float distance = std::hypot(mouse.x - centre.x, mouse.y - centre.y);
      const float rim = paper.pixels(radius_of(sandbox, i) + solvent(ctx.state));
      const float off = part == FlatPart::centre ? distance : std::fabs(distance - rim);
      if (off >= nearest) continue;
      nearest = off;
      m.hovered = part;
      m.ball = i;
    }
    if (m.hovered == FlatPart::centre) return;
  }
}

// If no centre or rim is near, finds the smallest ball around the mouse. A drag then moves it as by
// its centre.
void look_inside(PanelContext& ctx, const Paper& paper, ImVec2 mouse) {
  SandboxState& m = ctx.state.sandbox;
  if (m.hovered != FlatPart::paper) return;
  const Sandbox& sandbox = *ctx.state.settings.open.sandbox;
  const FlatPoint p = paper.place(mouse);
  double least = 1e300;
  for (std::size_t i = 0; i < sandbox.balls.size(); ++i) {
    const SandboxPlace at = centre_of(sandbox, i);
    const double radius = radius_of(sandbox, i) + solvent(ctx.state);
    if (std::hypot(p[0] - at[0], p[1] - at[1]) >= radius || radius >= least) continue;
    least = radius;
    m.hovered = FlatPart::centre;
    m.ball = i;
  }
}

void take_hold(PanelContext& ctx, const FlatPoint& mouse) {
  SandboxState& m = ctx.state.sandbox;
  m.held = m.hovered;
  if (m.held == FlatPart::paper) {
    m.grip = mouse;
    return;
  }
  if (m.held == FlatPart::none) return;
  select_ball(ctx.state, m.ball, ImGui::GetIO().KeyShift || ImGui::GetIO().KeyCtrl);
  const SandboxPlace at = centre_of(*ctx.state.settings.open.sandbox, m.ball);
  m.grip = {at[0] - mouse[0], at[1] - mouse[1]};
}

void drag(PanelContext& ctx, const FlatPoint& mouse) {
  SandboxState& m = ctx.state.sandbox;
  Sandbox& sandbox = *ctx.state.settings.open.sandbox;
  if (m.held == FlatPart::paper) {
    for (int d = 0; d < 2; ++d) m.middle[d] -= mouse[d] - m.grip[d];
    return;
  }
  if (m.ball >= sandbox.balls.size()) {  // the ball is gone after an undo
    m.held = FlatPart::none;
    return;
  }
  const double step = ImGui::GetIO().KeyAlt ? 0 : m.snap_angstrom;
  if (m.held == FlatPart::centre) {
    move_ball(sandbox, m.ball,
              {snapped(mouse[0] + m.grip[0], step), snapped(mouse[1] + m.grip[1], step), 0});
  } else {
    const SandboxPlace at = centre_of(sandbox, m.ball);
    const double radius = std::hypot(mouse[0] - at[0], mouse[1] - at[1]) - solvent(ctx.state);
    resize_ball(sandbox, m.ball, std::max(snapped(radius, step), step));
  }
}

void add_at(PanelContext& ctx, const FlatPoint& mouse) {
  ViewState& s = ctx.state;
  Sandbox& sandbox = *s.settings.open.sandbox;
  const SandboxState& m = s.sandbox;
  if (sandbox.balls.size() >= kMostSandboxBalls) {
    s.show_error("There is no room for another ball", why_no_sandbox(sandbox.balls.size() + 1));
    return;
  }
  const double step = ImGui::GetIO().KeyAlt ? 0 : m.snap_angstrom;
  select_ball(s, add_ball(sandbox, {snapped(mouse[0], step), snapped(mouse[1], step), 0},
                          m.next_radius_angstrom));
}

void mouse_on_paper(PanelContext& ctx, Paper& paper, ImVec2 corner, ImVec2 size) {
  ViewState& s = ctx.state;
  SandboxState& m = s.sandbox;
  ImGui::SetCursorScreenPos(corner);
  ImGui::InvisibleButton("##flat", size,
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  record(ctx, "view");
  const ImGuiIO& io = ImGui::GetIO();
  const bool on_paper = ImGui::IsItemHovered();
  if (!ImGui::IsMouseDown(0)) m.held = FlatPart::none;
  if (on_paper && io.MouseWheel != 0) paper.zoom(io.MousePos, std::pow(kZoomStep, io.MouseWheel));
  const FlatPoint mouse = paper.place(io.MousePos);
  if (m.held != FlatPart::none) return drag(ctx, mouse);
  m.hovered = FlatPart::none;
  if (!on_paper) return;
  look_under(ctx, paper, io.MousePos);
  look_inside(ctx, paper, io.MousePos);
  if (m.hovered == FlatPart::paper && ImGui::IsMouseDoubleClicked(0)) return add_at(ctx, mouse);
  if (ImGui::IsMouseClicked(0)) {
    if (m.hovered == FlatPart::paper) s.settings.selection.clear();
    return take_hold(ctx, mouse);
  }
}

// Outlines balls whose place or radius differs from the drawing.
void draw_moved(PanelContext& ctx, const Paper& paper) {
  const ViewState& s = ctx.state;
  if (!s.result) return;
  const Sandbox& sandbox = *s.settings.open.sandbox;
  const BallSet& drawn = *s.result->prepared->balls;
  for (std::size_t i = 0; i < sandbox.balls.size(); ++i) {
    const SandboxBall& ball = sandbox.balls[i];
    const bool there = i < drawn.size() && drawn.lattice == sandbox.lattice &&
                       drawn.centres[i] == ball.centre && drawn.radii[i] == ball.radius;
    if (there) continue;
    const SandboxPlace at = centre_of(sandbox, i);
    ImGui::GetWindowDrawList()->AddCircle(paper.pixel({at[0], at[1]}),
                                          paper.pixels(radius_of(sandbox, i) + solvent(s)),
                                          to_u32(ctx.palette.accent, 0.8f), 64, ctx.px(1));
  }
}

void draw_marks(PanelContext& ctx, const Paper& paper) {
  const SandboxState& m = ctx.state.sandbox;
  const Sandbox& sandbox = *ctx.state.settings.open.sandbox;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const auto ring = [&](std::size_t ball, ImU32 ink, float width) {
    const SandboxPlace at = centre_of(sandbox, ball);
    draw->AddCircle(paper.pixel({at[0], at[1]}),
                    paper.pixels(radius_of(sandbox, ball) + solvent(ctx.state)), ink, 96,
                    ctx.px(width));
  };
  for (const BallIndex ball : selected_balls(ctx.state)) {
    ring(ball, to_u32(ctx.palette.selected), 2.5f);
  }
  const FlatPart part = m.held != FlatPart::none ? m.held : m.hovered;
  const bool on_ball = part == FlatPart::centre || part == FlatPart::rim;
  if (!on_ball || m.ball >= sandbox.balls.size()) return;
  ring(m.ball, to_u32(ctx.palette.accent_hovered), part == FlatPart::rim ? 3 : 1.5f);
  ImGui::SetMouseCursor(part == FlatPart::rim ? ImGuiMouseCursor_ResizeEW
                                              : ImGuiMouseCursor_ResizeAll);
  const SandboxPlace at = centre_of(sandbox, m.ball);
  const std::string text = "Ball " + std::to_string(m.ball + 1) + ":  x " + number_text(at[0], 3) +
                           "  y " + number_text(at[1], 3) + "  r " +
                           number_text(radius_of(sandbox, m.ball), 3) + " Å";
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const ImVec2 extent = ImGui::CalcTextSize(text.c_str());
  const float most_right = ImGui::GetWindowPos().x + ImGui::GetWindowSize().x - ctx.px(8);
  const ImVec2 place{std::min(mouse.x + ctx.px(16), most_right - extent.x), mouse.y + ctx.px(14)};
  draw->AddRectFilled({place.x - ctx.px(5), place.y - ctx.px(3)},
                      {place.x + extent.x + ctx.px(5), place.y + extent.y + ctx.px(3)},
                      to_u32(ctx.palette.panel_raised, 0.92f), ctx.px(4));
  draw->AddText(place, to_u32(ctx.palette.text), text.c_str());
}

void draw_hint(PanelContext& ctx, ImVec2 corner, ImVec2 size) {
  const char* text =
      "Double-click: a new ball.  Drag a ball to move it, its rim to resize it.  "
      "Wheel: zoom.  Delete: remove.";
  const ImVec2 extent = ImGui::CalcTextSize(text);
  if (extent.x > size.x - ctx.px(240)) return;
  ImGui::GetWindowDrawList()->AddText(
      {corner.x + ctx.px(16), corner.y + size.y - extent.y - ctx.px(14)},
      to_u32(ctx.palette.text_muted), text);
}

}  // namespace

double flat_angstrom_per_pixel(const ViewState& state) {
  const double pixels = state.sandbox.pixels_per_angstrom;
  return pixels > 0 ? 1 / pixels : 0;
}

void draw_flat_view(PanelContext& ctx, ImVec2 corner, ImVec2 size) {
  ViewState& s = ctx.state;
  SandboxState& m = s.sandbox;
  s.viewport.hovered = false;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 end{corner.x + size.x, corner.y + size.y};
  draw->AddRectFilled(corner, end, to_u32(ctx.palette.scene));
  Paper paper(ctx, corner, size);
  if (!(m.pixels_per_angstrom > 0)) {
    if (!s.result || !is_flat(*s.result->balls)) return;
    paper.fit(box_of(*s.result->balls, s.result->request.alpha_angstrom2));
  }
  mouse_on_paper(ctx, paper, corner, size);
  make_shapes(s, paper.box());
  draw->PushClipRect(corner, end, true);
  for (const FlatShape& shape : m.shapes) draw_shape(ctx, paper, shape);
  draw_moved(ctx, paper);
  draw_marks(ctx, paper);
  draw_hint(ctx, corner, size);
  draw->PopClipRect();
}

}  // namespace alphascope
