// SPDX-License-Identifier: GPL-3.0-or-later
// The fixed layout of the window. The menu is on top, sections are at the left, and lessons at the
// right of the view. Pages are below the view, and the status bar is at the bottom. The user can
// drag the height of the pages only. The user guide has a window over all of these.
#include "ui/panels/frame/window_layout.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/geometry/lattice_alpha.hpp"
#include "ui/panels/cavities/cavity_parts.hpp"
#include "ui/panels/dialogs/dialog_stack.hpp"
#include "ui/panels/frame/mouse_state.hpp"
#include "ui/panels/frame/scroll_state.hpp"
#include "ui/panels/lessons/lesson_state.hpp"
#include "ui/panels/panel_list.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/panels/window_settings.hpp"
#include "ui/widgets/key_focus.hpp"
#include "ui/widgets/style.hpp"

namespace alphascope {
namespace {

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings |
                                    ImGuiWindowFlags_NoBringToFrontOnFocus;

constexpr float kRightWidth = 340;
constexpr float kLeftWidth = 320, kBottomHeight = 262, kStatusHeight = 27;
constexpr float kLeastBottom = 76, kLeastView = 180;
// Limits while a lesson is open. If less width than this is left for the view, the sections at the
// left are not drawn. The page below takes at most this share of the height.
constexpr float kLeastViewBesideLesson = 360, kBottomBesideLesson = 0.34f;

struct Area {
  ImVec2 corner, size;
};

// Windows in the usual colour have no background: ImGuiFrame::draw() clears the whole frame in that
// colour. Software OpenGL would spend half of a frame on backgrounds.
void begin(const char* id, const Area& place,
           ImGuiWindowFlags extra = ImGuiWindowFlags_NoBackground) {
  ImGui::SetNextWindowPos(place.corner);
  ImGui::SetNextWindowSize(place.size);
  ImGui::Begin(id, nullptr, kFixed | extra);
}

void hairline(PanelContext& ctx, ImVec2 from, ImVec2 to) {
  // Windows clip drawings at their padding, and these lines run from edge to edge.
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->PushClipRectFullScreen();
  draw->AddLine(from, to, to_u32(ctx.palette.border), 1);
  draw->PopClipRect();
}

std::vector<PanelSpec> panels_at(PanelPlace place) {
  std::vector<PanelSpec> found;
  for (const PanelSpec& p : panels()) {
    if (p.place == place) found.push_back(p);
  }
  return found;
}

std::vector<PanelSpec> scrolled_sections() {
  std::vector<PanelSpec> sections = panels_at(PanelPlace::left);
  std::erase_if(sections,
                [](const PanelSpec& s) { return s.id == std::string_view(kPinnedSection); });
  return sections;
}

// Buttons for the sections that scroll, drawn if they do not fit. Arrows mark sections scrolled out
// of sight.
void section_buttons(PanelContext& ctx, const WidgetRects& last) {
  const std::vector<PanelSpec> sections = scrolled_sections();
  const float gap = ctx.px(4), count = static_cast<float>(sections.size());
  ImGui::PushFont(ctx.fonts.small);
  // Each button has room for its title with an arrow, drawn or not. All share the remaining width.
  const auto text_width = [](const PanelSpec& s) {
    return ImGui::CalcTextSize((s.title + std::string(" ↓")).c_str()).x;
  };
  float rest = ctx.px(kLeftWidth) - ctx.px(35) - (count - 1) * gap;
  for (const PanelSpec& s : sections) rest -= text_width(s);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, ctx.px(2)});
  for (const PanelSpec& s : sections) {
    const auto header = last.find(s.id);
    const bool hidden = header != last.end() && !header->second.visible;
    const bool above = hidden && header->second.y0 < ImGui::GetCursorScreenPos().y;
    const std::string label = s.title + std::string(!hidden ? "" : above ? " ↑" : " ↓");
    const std::string name = std::string("sections.") + s.id;
    if (&s != &sections.front()) ImGui::SameLine(0, gap);
    if (button(ctx, name.c_str(), label.c_str(), {text_width(s) + rest / count, 0})) {
      ctx.state.scroll.section = s.id;
    }
  }
  ImGui::PopStyleVar();
  ImGui::PopFont();
}

// Draws the section on alpha above those that scroll. It scrolls by itself only if it would leave
// no room for the others.
void pinned_section(PanelContext& ctx) {
  constexpr float kLeastBelow = 130;  // pixels at scale 1
  float& height = ctx.state.scroll.pinned_height;
  const float most = std::max(ctx.px(80), ImGui::GetContentRegionAvail().y - ctx.px(kLeastBelow));
  const bool scrolls = height > most;
  if (scrolls) ImGui::BeginChild("pinned", {0, most}, false);
  const float top = ImGui::GetCursorPosY();
  ImGui::PushItemWidth(-1);
  ctx.panels.of(kPinnedSection).draw(ctx);
  ImGui::PopItemWidth();
  height = ImGui::GetCursorPosY() - top;
  if (scrolls) ImGui::EndChild();
}

void left_panel(PanelContext& ctx, const WidgetRects& last, float top, float height) {
  begin("##left", {{0, top}, {ctx.px(kLeftWidth), height}});
  pinned_section(ctx);
  bool& overflow = ctx.state.scroll.sections_overflow;
  const float room = ImGui::GetContentRegionAvail().y;
  if (overflow) section_buttons(ctx, last);
  // The child keeps its width when its scroll bar appears, so nothing beside it jumps.
  ImGui::BeginChild("sections", {0, 0}, false);
  ImGui::PushItemWidth(-1);
  for (const PanelSpec& s : scrolled_sections()) ctx.panels.of(s).draw(ctx);
  ImGui::PopItemWidth();
  // `room` was taken above the buttons, so they do not change the answer and cannot flicker.
  overflow = ImGui::GetCursorPosY() > room;
  ImGui::EndChild();
  hairline(ctx, {ctx.px(kLeftWidth) - 1, top}, {ctx.px(kLeftWidth) - 1, top + height});
  ImGui::End();
}

// Draws lessons beside the view. Returns their width in pixels; 0 if they are closed.
float right_panel(PanelContext& ctx, float top, float height) {
  if (!ctx.state.lessons.shown) return 0;
  const float width = ctx.px(kRightWidth), left = ImGui::GetIO().DisplaySize.x - width;
  begin("##right", {{left, top}, {width, height}});
  hairline(ctx, {left, top}, {left, top + height});
  for (const PanelSpec& p : panels_at(PanelPlace::right)) ctx.panels.of(p).draw(ctx);
  ImGui::End();
  return width;
}

float bottom_height(PanelContext& ctx, float available) {
  float& height = ctx.state.window.page_height;  // the height wanted; a small window has less
  if (height <= 0) height = kBottomHeight;
  height = std::max(height, kLeastBottom);
  return ctx.px(std::min(height, std::max(kLeastBottom, available / ctx.scale - kLeastView)));
}

void splitter(PanelContext& ctx, const Area& below) {
  const auto [x, y] = below.corner;
  const float width = below.size.x;
  ImGui::SetCursorScreenPos({x, y});
  ImGui::InvisibleButton("##splitter", {width, ctx.px(6)});
  record(ctx, "layout.splitter");
  const bool active = ImGui::IsItemActive();
  if (active) {
    ctx.state.window.page_height = (below.size.y - ImGui::GetIO().MouseDelta.y) / ctx.scale;
  }
  if (active || ImGui::IsItemHovered()) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
    ImGui::GetWindowDrawList()->AddLine({x, y}, {x + width, y}, to_u32(ctx.palette.accent),
                                        ctx.px(2));
  }
}

// Padding (pixels) and font with which the names of pages fit into one line.
struct NameFit {
  float padding = 0;
  bool small = false;
};

constexpr float kBetweenNames = 2;  // pixels at scale 1

NameFit fit_names(const PanelContext& ctx, const std::vector<PanelSpec>& pages, float usual) {
  const float count = static_cast<float>(pages.size());
  const float room = ImGui::GetContentRegionAvail().x - (count - 1) * ctx.px(kBetweenNames) -
                     ctx.px(6);  // the open page's name is bold
  const auto padding_in = [&](ImFont* font) {
    float names = 0;
    ImGui::PushFont(font);
    for (const PanelSpec& p : pages) names += ImGui::CalcTextSize(p.title).x;
    ImGui::PopFont();
    return (room - names) / (2 * count);
  };
  const float padding = padding_in(ctx.fonts.regular), least = ctx.px(2);
  if (padding >= least) return {std::min(usual, padding), false};
  return {std::clamp(padding_in(ctx.fonts.small), ctx.px(1), usual), true};
}

// Draws the names of pages as buttons, if there are several. The page goes on in the same line if
// there is room.
const PanelSpec* bottom_tabs(PanelContext& ctx, const std::vector<PanelSpec>& pages) {
  const std::string shown = ctx.state.page();
  const auto found =
      std::find_if(pages.begin(), pages.end(), [&](const PanelSpec& p) { return p.id == shown; });
  const PanelSpec* page = found == pages.end() ? &pages.front() : &*found;
  if (pages.size() == 1) {
    ImGui::AlignTextToFramePadding();
    strong_text(ctx, page->title);
  }
  // Controls of the page beside the names need room, too.
  const bool narrow = ImGui::GetContentRegionAvail().x < ctx.px(820);
  const ImVec2 padding = ImGui::GetStyle().FramePadding;
  const NameFit fit = fit_names(ctx, pages, narrow ? ctx.px(4) : padding.x);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {fit.padding, padding.y});
  const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  for (const PanelSpec& p : pages) {
    if (pages.size() == 1) break;
    const bool on = &p == page;
    ImGui::PushFont(fit.small ? ctx.fonts.small : on ? ctx.fonts.strong : ctx.fonts.regular);
    const float width = ImGui::CalcTextSize(p.title).x + 2 * fit.padding;
    const float gap = ctx.px(kBetweenNames);
    if (&p != &pages.front() && ImGui::GetItemRectMax().x + gap + width <= right) {
      ImGui::SameLine(0, gap);
    }
    const std::string name = std::string("bottom.") + p.id;
    if (button(ctx, name.c_str(), p.title, {0, 0}, on ? ButtonKind::normal : ButtonKind::quiet)) {
      ctx.state.window.page = ctx.state.window.chosen_page = p.id;
    }
    ImGui::PopFont();
  }
  constexpr float kLeastBeside = 400;
  ImGui::PopStyleVar();
  ImGui::SameLine(0, ctx.px(14));
  if (ImGui::GetContentRegionAvail().x < ctx.px(kLeastBeside)) ImGui::NewLine();
  return page;
}

void bottom_panel(PanelContext& ctx, const Area& area) {
  begin("##timings", area);
  const auto [x, y] = area.corner;
  const float width = area.size.x;
  splitter(ctx, area);
  hairline(ctx, {x, y}, {x + width, y});
  ImGui::SetCursorScreenPos({x + ImGui::GetStyle().WindowPadding.x, y + ctx.px(8)});
  // Pages are made for kBottomHeight. In less room they may scroll.
  const bool low = area.size.y < ctx.px(kBottomHeight);
  ImGui::BeginChild("content", {0, 0}, false,
                    low ? ImGuiWindowFlags_None : ImGuiWindowFlags_NoScrollbar);
  const std::vector<PanelSpec> pages = panels_at(PanelPlace::bottom);
  ctx.panels.of(*bottom_tabs(ctx, pages)).draw(ctx);
  // Atoms that line chosen cavities are marked in the picture, whatever page is open.
  if (!ctx.state.settings.selection.cavities.empty()) follow_cavities(ctx);
  ImGui::SetScrollX(0);  // no scroll bar would show a shift
  ImGui::EndChild();
  ImGui::End();
}

void status(PanelContext& ctx, float y, float width, float height) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ctx.px(12), ctx.px(5)});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, to_imgui(ctx.palette.panel_raised));
  begin("##status", {{0, y}, {width, height}}, ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  hairline(ctx, {0, y}, {width, y});
  draw_status_bar(ctx);
  ImGui::End();
  ImGui::PopStyleColor();
}

void note_mouse(MouseState& mouse) {
  const ImGuiIO& io = ImGui::GetIO();
  // MouseDelta would be zero when the mouse enters the window.
  const bool moved = io.MousePos.x != mouse.x || io.MousePos.y != mouse.y;
  const bool busy = moved || ImGui::IsAnyMouseDown();
  mouse.x = io.MousePos.x;
  mouse.y = io.MousePos.y;
  mouse.still_seconds = busy ? 0 : mouse.still_seconds + io.DeltaTime;
}

constexpr const char* kView = "##view";

PanelContext context_of(const WindowParts& parts, const PanelFonts& fonts, float scale) {
  return {parts.state,  parts.rects,  parts.commands,
          parts.store,  parts.inputs, parts.calls,
          parts.panels, fonts,        palette(parts.state.theme()),
          scale};
}

}  // namespace

void draw_over_picture(const WindowParts& parts, const PanelFonts& fonts, float scale) {
  PanelContext ctx = context_of(parts, fonts, scale);
  ImGui::Begin(kView);  // ImGui adds to the window of that name
  draw_view_labels(ctx);
  ImGui::End();
}

void draw_window(const WindowParts& parts, const PanelFonts& fonts, float scale) {
  ViewState& state = parts.state;
  const WidgetRects last = std::exchange(parts.rects, {});
  PanelContext ctx = context_of(parts, fonts, scale);
  state.layers.clear();
  state.measures_wanted = false;
  note_mouse(state.mouse);
  begin_key_focus(ctx);
  draw_menu_bar(ctx);
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float top = ImGui::GetFrameHeight();
  const bool tight =
      state.lessons.shown && display.x < ctx.px(kLeftWidth + kRightWidth + kLeastViewBesideLesson);
  const float status_height = ctx.px(kStatusHeight), left = tight ? 0 : ctx.px(kLeftWidth);
  const float middle = std::max(0.0f, display.y - top - status_height);
  const float usual_bottom = bottom_height(ctx, middle);
  const float bottom = tight ? std::min(usual_bottom, kBottomBesideLesson * middle) : usual_bottom;
  const bool high =
      tight || state.window.presenter_size;  // the lesson goes on beside the page below
  const float width = std::max(1.0f, display.x - left);
  if (!tight) left_panel(ctx, last, top, middle);
  const float beside = right_panel(ctx, top, high ? middle : middle - bottom);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  const float view = std::max(1.0f, width - beside);
  begin(kView, {{left, top}, {view, middle - bottom}},
        ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoBackground);
  ImGui::PopStyleVar();
  draw_viewport(ctx);
  ImGui::End();
  bottom_panel(ctx, {{left, top + middle - bottom}, {high ? view : width, bottom}});
  status(ctx, display.y - status_height, display.x, status_height);
  for (const PanelSpec& p : panels_at(PanelPlace::over)) ctx.panels.of(p).draw(ctx);
  draw_dialogs(ctx);
  end_key_focus(ctx);
}

}  // namespace alphascope
