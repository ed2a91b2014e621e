// SPDX-License-Identifier: GPL-3.0-or-later
// The window of the user guide: the list of pages or of places found at the left, a page at the
// right. It lies over the others, so a reader can try things out beside it.
#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/document/commands/commands.hpp"
#include "core/document/guide/guide.hpp"
#include "ui/calls.hpp"
#include "ui/fitted_text.hpp"
#include "ui/panels/guide/guide_page.hpp"
#include "ui/panels/guide/guide_state.hpp"
#include "ui/panels/panel.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/key_focus.hpp"
#include "ui/widgets/keys.hpp"
#include "ui/widgets/style.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

constexpr const char* kSearch = "guide.search";
constexpr std::size_t kNone = static_cast<std::size_t>(-1);
constexpr std::size_t kMostHits = 200;  // that are listed

// A place that was read before, with its scroll position in pixels.
struct Visited {
  std::size_t page = 0;
  float scroll = 0;
};

struct GuideMemory {
  std::shared_ptr<const Guide> guide;  // null: not read yet
  GuideView view;
  std::vector<Visited> visited;
  std::string query, searched;  // as typed, and as found
  std::vector<GuideHit> hits;
  std::size_t hit = kNone;                                      // the one that was followed last
  int frames_open = 0;                                          // since the guide was opened
  float placed_width = 0, placed_height = 0, placed_scale = 0;  // of the display then, in pixels
};

void go_to(GuideMemory& m, GuidePlace place, bool remember = true) {
  if (remember) m.visited.push_back({m.view.page, m.view.scroll});
  m.view.page = place.page;
  m.view.scroll_to = place.block;
  m.view.marked.reset();
}

void go_back(GuideMemory& m) {
  if (m.visited.empty()) return;
  const Visited last = m.visited.back();
  m.visited.pop_back();
  m.view.page = last.page;
  m.view.scroll_to.reset();
  m.view.scroll_by = last.scroll - m.view.scroll;
  m.view.marked.reset();
}

// Opens a page of the guide, or copies an address.
void follow(PanelContext& ctx, GuideMemory& m, const std::string& link) {
  if (const auto place = follow_link(*m.guide, m.view.page, link)) return go_to(m, *place);
  ctx.calls.files.copy(link);
  ctx.state.notice = "The user guide does not contain " + link + ". Its address was copied.";
}

// --- search

void search(GuideMemory& m) {
  if (m.query == m.searched) return;
  m.searched = m.query;
  m.hits = search_guide(*m.guide, m.query);
  m.hit = kNone;
  m.view.words = query_words(m.query);
  m.view.marked.reset();
}

void show_hit(GuideMemory& m, std::size_t n) {
  m.hit = n;
  go_to(m, m.hits[n].place, m.hits[n].place.page != m.view.page);
  m.view.marked = m.hits[n].place.block;
}

// Goes to the next or previous hit, around the ends.
void step_hit(GuideMemory& m, int step) {
  const std::size_t count = std::min(m.hits.size(), kMostHits);
  if (count == 0) return;
  if (m.hit == kNone) return show_hit(m, step > 0 ? 0 : count - 1);
  show_hit(m, (m.hit + count + static_cast<std::size_t>(step + static_cast<int>(count))) % count);
}

void draw_search(PanelContext& ctx, GuideMemory& m) {
  const char* const clear = "Clear";
  const bool clears = !m.query.empty();
  const float gap = ctx.px(4);
  ImGui::SetNextItemWidth(clears ? -button_width(clear) - gap : -1);
  const bool entered = text_field(ctx, kSearch, m.query, "Search all pages");
  tooltip(ctx, "Ctrl+F. Enter and Down go to the next place, Up to the one before.");
  if (clears) {
    ImGui::SameLine(0, gap);
    if (button(ctx, "guide.clear", clear)) m.query.clear();
  }
  search(m);
  if (!entered) return;
  step_hit(m, 1);
  type_into(ctx, kSearch);  // so that Enter goes on
}

// A row of a list, `lines` lines high. Its texts are drawn by row_text().
bool list_row(PanelContext& ctx, const std::string& name, bool chosen, float height) {
  const float width = ImGui::GetContentRegionAvail().x;
  const bool clicked =
      ImGui::Selectable(("##" + name).c_str(), chosen, 0, {std::max(1.0f, width), height});
  record(ctx, name.c_str());
  key_stop(ctx, name.c_str());
  return clicked;
}

// Writes a text over the last row, cut at the row's right end. `x` and `y` count from its corner.
void row_text(PanelContext& ctx, const std::string& text, float x, float y, const Colour& colour) {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const float room = high.x - low.x - x - ctx.px(4);
  const std::string shown = fitted_beginning(
      text, room, [](const std::string& some) { return ImGui::CalcTextSize(some.c_str()).x; });
  ImGui::GetWindowDrawList()->AddText({low.x + x, low.y + y}, to_u32(colour), shown.c_str());
}

// A place found: the heading above it, and its text in small letters.
bool hit_row(PanelContext& ctx, const GuideHit& hit, std::size_t n, bool chosen) {
  const float line = ImGui::GetTextLineHeight(), height = 2 * line + ctx.px(4);
  const bool clicked = list_row(ctx, "guide.hit." + std::to_string(n + 1), chosen, height);
  row_text(ctx, hit.heading, ctx.px(14), ctx.px(1), ctx.palette.text);
  ImGui::PushFont(ctx.fonts.small);
  row_text(ctx, hit.excerpt, ctx.px(14), line + ctx.px(2), ctx.palette.text_muted);
  ImGui::PopFont();
  return clicked;
}

void draw_hits(PanelContext& ctx, GuideMemory& m) {
  const std::size_t count = std::min(m.hits.size(), kMostHits);
  if (m.hits.empty()) {
    muted_wrapped(ctx, "No page contains " + std::string(m.view.words.size() > 1 ? "all of " : "") +
                           "“" + m.query + "”. A search finds the beginnings of words.");
    return record(ctx, "guide.no_hit");
  }
  muted_wrapped(ctx,
                std::to_string(m.hits.size()) + (m.hits.size() == 1 ? " place" : " places") +
                    (count < m.hits.size() ? "; the first " + std::to_string(count) + " are listed"
                                           : std::string()));
  record(ctx, "guide.hits");
  ImGui::BeginChild("hits", {0, 0}, false);
  for (std::size_t n = 0; n < count; ++n) {
    const std::size_t page = m.hits[n].place.page;
    if (n == 0 || m.hits[n - 1].place.page != page) strong_text(ctx, m.guide->pages[page].title);
    if (hit_row(ctx, m.hits[n], n, n == m.hit)) show_hit(m, n);
    if (n == m.hit && m.view.scroll_to) ImGui::SetScrollHereY();
  }
  ImGui::EndChild();
}

// --- the list of pages

// The main headings of the open page.
void draw_headings(PanelContext& ctx, GuideMemory& m) {
  const std::vector<MarkdownBlock>& blocks = m.guide->pages[m.view.page].blocks;
  ImGui::PushFont(ctx.fonts.small);
  for (std::size_t n = 0; n < blocks.size(); ++n) {
    if (blocks[n].kind != MarkdownKind::heading || blocks[n].level != 2) continue;
    const std::string name = "guide.heading." + std::to_string(n);
    if (list_row(ctx, name, false, ImGui::GetTextLineHeight())) go_to(m, {m.view.page, n});
    row_text(ctx, plain_text(blocks[n]), ctx.px(20), 0, ctx.palette.text_muted);
  }
  ImGui::PopFont();
}

void draw_pages(PanelContext& ctx, GuideMemory& m) {
  ImGui::BeginChild("list", {0, 0}, false);
  const std::vector<GuidePage>& pages = m.guide->pages;
  const auto of_guide = [&](std::size_t n) { return pages[n].file.starts_with("guide/"); };
  for (std::size_t n = 0; n < pages.size(); ++n) {
    if (n > 0 && of_guide(n - 1) && !of_guide(n)) {
      ImGui::Dummy({0, ctx.px(4)});
      ImGui::SetCursorPosX(ctx.px(4));
      muted_text(ctx, "Reference");
    }
    const bool open = n == m.view.page;
    const bool clicked =
        list_row(ctx, "guide.page." + pages[n].name(), open, ImGui::GetTextLineHeight());
    if (!pages[n].summary.empty()) tooltip(ctx, ("Read it to " + pages[n].summary + ".").c_str());
    row_text(ctx, pages[n].title, ctx.px(8), 0, ctx.palette.text);
    if (open) draw_headings(ctx, m);
    if (clicked) go_to(m, {n, 0});
  }
  ImGui::EndChild();
}

// --- the page

void draw_head(PanelContext& ctx, GuideMemory& m) {
  ImGui::BeginDisabled(m.visited.empty());
  if (button(ctx, "guide.back", "← Back")) go_back(m);
  ImGui::EndDisabled();
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  muted_text(ctx, fitted_text(m.guide->pages[m.view.page].title, ImGui::GetContentRegionAvail().x));
  record(ctx, ("guide.title." + m.guide->pages[m.view.page].name()).c_str());
}

void draw_columns(PanelContext& ctx, GuideMemory& m) {
  constexpr float kLeast = 150, kMost = 270, kShare = 0.3f;  // pixels at scale 1; of the width
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::BeginChild("pages", {std::clamp(kShare * width, ctx.px(kLeast), ctx.px(kMost)), 0}, false);
  draw_search(ctx, m);
  ImGui::Dummy({0, ctx.px(2)});
  if (m.view.words.empty()) {
    draw_pages(ctx, m);
  } else {
    draw_hits(ctx, m);
  }
  ImGui::EndChild();
  ImGui::SameLine(0, ctx.px(12));
  ImGui::BeginChild("page", {0, 0}, false);
  draw_head(ctx, m);
  const std::string link = draw_guide_page(ctx, *m.guide, m.view);
  ImGui::EndChild();
  if (!link.empty()) follow(ctx, m, link);
}

// --- the window

// Keys scroll the page while the guide is in front, and Escape closes it.
void take_keys(PanelContext& ctx, GuideMemory& m) {
  GuideState& g = ctx.state.guide;
  const bool typing = ImGui::GetIO().WantTextInput && !m.query.empty();
  if (ImGui::IsKeyPressed(key::kEscape, false) && !typing) g.shown = false;
  const float page = 0.85f * ImGui::GetWindowHeight(), line = 3 * ImGui::GetTextLineHeight();
  constexpr float kWhole = 1e9f;
  float& by = m.view.scroll_by;
  if (ImGui::IsKeyPressed(key::kPageDown)) by += page;
  if (ImGui::IsKeyPressed(key::kPageUp)) by -= page;
  if (ImGui::GetIO().KeyCtrl && ImGui::IsKeyPressed(key::kF, false)) type_into(ctx, kSearch);
  const int arrows =
      (ImGui::IsKeyPressed(key::kDown) ? 1 : 0) - (ImGui::IsKeyPressed(key::kUp) ? 1 : 0);
  if (arrows != 0 && typing && !m.hits.empty()) {
    step_hit(m, arrows);
  } else {
    by += static_cast<float>(arrows) * line;
  }
  if (typing) return;
  if (ImGui::IsKeyPressed(key::kHome)) by -= kWhole;
  if (ImGui::IsKeyPressed(key::kEnd)) by += kWhole;
}

void take_state(PanelContext& ctx, GuideMemory& m) {
  GuideState& g = ctx.state.guide;
  if (m.guide != g.guide) m.guide = g.guide;  // read for the first time
  if (!m.guide || g.asked_page.empty()) return;
  const std::string asked = std::exchange(g.asked_page, {});
  if (const auto place = find_page(*m.guide, asked)) return go_to(m, *place);
  std::string names;
  for (const GuidePage& page : m.guide->pages) names += (names.empty() ? "" : ", ") + page.name();
  ctx.state.refuse_late("The user guide has no page \"" + asked + "\". Its pages are " + names +
                        ".");
}

void draw_contents(PanelContext& ctx, GuideMemory& m) {
  const GuideState& g = ctx.state.guide;
  if (m.guide) {
    draw_columns(ctx, m);
    // The field must have been drawn before it can be typed into.
    if (++m.frames_open == 2) type_into(ctx, kSearch);
  } else if (!g.problem.empty()) {
    wrapped_text(g.problem);
    record(ctx, "guide.problem");
  } else {
    muted_text(ctx, "Reading the user guide…");
  }
}

// Places the guide in the middle at first, and when display or scale have changed.
void begin_guide(PanelContext& ctx, GuideMemory& m) {
  constexpr float kWidth = 980, kHeight = 660, kMargin = 20;  // pixels at scale 1
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const ImVec2 most{display.x - 2 * ctx.px(kMargin), display.y - 3 * ctx.px(kMargin)};
  const ImVec2 size{std::min(ctx.px(kWidth), most.x), std::min(ctx.px(kHeight), most.y)};
  ImGui::SetNextWindowSizeConstraints(
      {std::min(ctx.px(440), size.x), std::min(ctx.px(260), size.y)}, {display.x, display.y});
  if (m.placed_width != display.x || m.placed_height != display.y || m.placed_scale != ctx.scale) {
    ImGui::SetNextWindowSize(size);
    ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    m.placed_width = display.x;
    m.placed_height = display.y;
    m.placed_scale = ctx.scale;
  }
  if (std::exchange(ctx.state.guide.to_front, false)) ImGui::SetNextWindowFocus();
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ctx.px(6));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::Begin("User guide", &ctx.state.guide.shown,
               ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings);
  ImGui::PopStyleVar(2);
}

void draw_guide(PanelContext& ctx, GuideMemory& m) {
  ctx.state.keys.reading = false;
  if (!ctx.state.guide.shown) {
    m.frames_open = 0;
    return;
  }
  take_state(ctx, m);
  begin_guide(ctx, m);
  const bool in_front = ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows) &&
                        !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
  if (in_front) take_keys(ctx, m);
  ctx.state.keys.reading = in_front && ctx.state.guide.shown;
  draw_contents(ctx, m);
  ImGui::End();
}

void add_guide_commands(Commands& commands, ViewState& state, GuideMemory&) {
  commands.add({.id = "help.guide",
                .title = "User guide",
                .help = "Shows the user guide, and searches it",
                .synonyms = {{"manual documentation docs help search"}},
                .shortcuts = {{"Shift+F1"}},
                .works_everywhere = true,
                .menu = "Help",
                .parameters = {{.name = "page",
                                .help = "Name of a page, perhaps with a heading; if left out, the "
                                        "page read last",
                                .example = "window#undo",
                                .optional = true}},
                .run = [&state](const Arguments& arguments) {
                  GuideState& g = state.guide;
                  if (!g.shown) g.problem.clear();  // looks for the files once more
                  g.shown = g.to_front = true;
                  g.asked_page = arguments.text("page");
                  return Outcome();
                }});
}

}  // namespace

std::unique_ptr<Panel> guide_panel() {
  return panel_of(draw_guide, add_guide_commands);
}

}  // namespace alphascope
