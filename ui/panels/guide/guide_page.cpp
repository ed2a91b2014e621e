// SPDX-License-Identifier: GPL-3.0-or-later
// Puts the blocks of a page below each other, and draws those in sight.
#include "ui/panels/guide/guide_page.hpp"

#include <algorithm>
#include <utility>

#include "core/document/guide/guide.hpp"
#include "ui/calls.hpp"
#include "ui/panels/guide/guide_text.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/key_focus.hpp"
#include "ui/widgets/style.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

constexpr float kWidestText = 760;  // pixels at scale 1; longer lines are hard to read
constexpr const char* kCopyMenu = "guide.copy";

// Finds the columns of all tables.
std::vector<std::vector<float>> columns_of(PanelContext& ctx,
                                           const std::vector<MarkdownBlock>& blocks, float width) {
  std::vector<std::vector<float>> columns(blocks.size());
  const auto ends_table = [](const MarkdownBlock& block) {
    return block.kind != MarkdownKind::row || block.head;
  };
  for (std::size_t begin = 0; begin < blocks.size();) {
    const auto first = blocks.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto end = static_cast<std::size_t>(std::find_if(first + 1, blocks.end(), ends_table) -
                                              blocks.begin());
    if (first->kind == MarkdownKind::row) {
      std::fill(columns.begin() + static_cast<std::ptrdiff_t>(begin),
                columns.begin() + static_cast<std::ptrdiff_t>(end),
                guide_columns(ctx, blocks, begin, end, width));
      begin = end;
    } else {
      ++begin;
    }
  }
  return columns;
}

void lay_out(PanelContext& ctx, const GuidePage& page, float width, GuideLayout& layout) {
  const float letters = ImGui::GetFontSize();
  if (layout.page == &page && layout.width == width && layout.letters == letters) return;
  layout = {&page, width, letters, {0}, columns_of(ctx, page.blocks, width)};
  for (std::size_t n = 0; n < page.blocks.size(); ++n) {
    const MarkdownBlock& block = page.blocks[n];
    float height = put_guide_block(ctx, block, {0, 0}, width, layout.columns[n], {.draws = false});
    const bool ends = n + 1 == page.blocks.size() || page.blocks[n + 1].kind != block.kind;
    if (ends && block.kind == MarkdownKind::row) height += ctx.px(12);
    if (ends && block.kind == MarkdownKind::item) height += ctx.px(5);
    layout.tops.push_back(layout.tops.back() + height);
  }
}

// Makes a button of a link. Returns whether it was clicked.
bool link_button(PanelContext& ctx, const ShownLink& link, const std::string& name) {
  ImGui::SetCursorScreenPos(link.low);
  const bool clicked = ImGui::InvisibleButton(
      name.c_str(), {std::max(1.0f, link.high.x - link.low.x), link.high.y - link.low.y});
  record(ctx, name.c_str());
  key_stop(ctx, name.c_str());
  if (ImGui::IsItemHovered()) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    ImGui::GetWindowDrawList()->AddRectFilled(link.low, link.high, to_u32(ctx.palette.accent, 0.2f),
                                              ctx.px(2));
  }
  tooltip(ctx, link.target.c_str());
  return clicked;
}

void copy(PanelContext& ctx, const std::string& text) {
  ctx.calls.files.copy(text);
  ctx.state.notice = "Copied.";
}

void copy_button(PanelContext& ctx, const MarkdownBlock& block, std::size_t n, ImVec2 corner,
                 float width) {
  const std::string name = "guide.copy_code." + std::to_string(n);
  ImGui::SetCursorScreenPos({corner.x + width - ctx.px(kCopyButtonWidth), corner.y + ctx.px(4)});
  ImGui::PushFont(ctx.fonts.small);
  if (button(ctx, name.c_str(), "Copy", {ctx.px(kCopyButtonWidth - 6), 0}, ButtonKind::quiet)) {
    copy(ctx, plain_text(block));
  }
  ImGui::PopFont();
}

const char* copy_title(MarkdownKind kind) {
  switch (kind) {
    case MarkdownKind::heading:
      return "Copy this heading";
    case MarkdownKind::code:
      return "Copy this code";
    case MarkdownKind::row:
      return "Copy this row";
    case MarkdownKind::item:
      return "Copy this item";
    case MarkdownKind::picture:
      return "Copy this description";
    case MarkdownKind::paragraph:
      break;
  }
  return "Copy this paragraph";
}

std::string text_of_page(const GuidePage& page) {
  std::string text;
  for (const MarkdownBlock& block : page.blocks) text += plain_text(block) + "\n";
  return text;
}

// The menu of the right mouse button.
void copy_menu(PanelContext& ctx, const GuidePage& page, GuideView& view, float top) {
  if (ImGui::IsWindowHovered() && ImGui::IsMouseReleased(1)) {
    const float y = ImGui::GetIO().MousePos.y - top;
    const auto& tops = view.layout.tops;
    const auto below = std::upper_bound(tops.begin(), tops.end() - 1, y) - tops.begin();
    view.copied = static_cast<std::size_t>(std::max<std::ptrdiff_t>(below, 1) - 1);
    ImGui::OpenPopup(kCopyMenu);
  }
  if (!ImGui::BeginPopup(kCopyMenu)) return;
  close_on_escape();
  if (view.copied < page.blocks.size()) {
    const MarkdownBlock& block = page.blocks[view.copied];
    if (ImGui::MenuItem(copy_title(block.kind))) copy(ctx, plain_text(block));
    record(ctx, "guide.copy.block");
  }
  if (ImGui::MenuItem("Copy the whole page")) copy(ctx, text_of_page(page));
  record(ctx, "guide.copy.page");
  ImGui::EndPopup();
}

void mark_block(const PanelContext& ctx, ImVec2 corner, float height) {
  ImGui::GetWindowDrawList()->AddRectFilled({corner.x - ctx.px(10), corner.y},
                                            {corner.x - ctx.px(7), corner.y + height - ctx.px(4)},
                                            to_u32(ctx.palette.accent), ctx.px(1));
}

void scroll(const PanelContext& ctx, GuideView& view) {
  constexpr float kAbove = 40;  // what is above the block stays in sight, in pixels at scale 1
  if (const auto block = std::exchange(view.scroll_to, std::nullopt)) {
    const std::size_t n = std::min(*block, view.layout.tops.size() - 1);
    ImGui::SetScrollY(n == 0 ? 0 : std::max(0.0f, view.layout.tops[n] - ctx.px(kAbove)));
  } else if (const float by = std::exchange(view.scroll_by, 0.0f); by != 0) {
    const float most = std::max(0.0f, view.layout.tops.back() - ImGui::GetWindowHeight() / 2);
    ImGui::SetScrollY(std::clamp(ImGui::GetScrollY() + by, 0.0f, most));
  }
  view.scroll = ImGui::GetScrollY();
}

// Draws the blocks in sight. Returns the link that was clicked.
std::string draw_blocks(PanelContext& ctx, const GuidePage& page, GuideView& view, ImVec2 corner,
                        float width) {
  const float low = ImGui::GetWindowPos().y, high = low + ImGui::GetWindowHeight();
  std::string clicked;
  for (std::size_t n = 0; n < page.blocks.size(); ++n) {
    const float top = corner.y + view.layout.tops[n], end = corner.y + view.layout.tops[n + 1];
    if (end < low || top > high) continue;
    if (view.marked == n) {
      mark_block(ctx, {corner.x, top}, end - top);
      ctx.rects["guide.marked." + std::to_string(n)] = {corner.x, top, corner.x + width, end,
                                                        top >= low && end <= high};
    }
    std::vector<ShownLink> links;
    put_guide_block(ctx, page.blocks[n], {corner.x, top}, width, view.layout.columns[n],
                    {.words = view.words.empty() ? nullptr : &view.words, .links = &links});
    if (page.blocks[n].kind == MarkdownKind::code) {
      copy_button(ctx, page.blocks[n], n, {corner.x, top}, width);
    }
    for (std::size_t k = 0; k < links.size(); ++k) {
      const std::string name =
          "guide.link." + links[k].target + "." + std::to_string(n) + "." + std::to_string(k);
      if (link_button(ctx, links[k], name)) clicked = links[k].target;
    }
  }
  return clicked;
}

}  // namespace

std::string draw_guide_page(PanelContext& ctx, const Guide& guide, GuideView& view) {
  const GuidePage& page = guide.pages[view.page];
  std::string clicked;
  ImGui::BeginChild("text", {0, 0}, false);
  // The scroll bar's place is left free, so the text keeps its width when the bar appears.
  const float room = ImGui::GetWindowWidth() - ImGui::GetStyle().ScrollbarSize;
  const float left = ctx.px(14), width = std::min(ctx.px(kWidestText), room - left - ctx.px(10));
  if (!page.problem.empty()) {
    wrapped_text(page.problem);
    record(ctx, "guide.page_problem");
  } else if (width > ctx.px(20)) {
    lay_out(ctx, page, width, view.layout);
    const ImVec2 start = ImGui::GetCursorScreenPos(), corner{start.x + left, start.y};
    ImGui::Dummy({1, view.layout.tops.back() + ctx.px(20)});
    record(ctx, "guide.text");
    scroll(ctx, view);
    clicked = draw_blocks(ctx, page, view, corner, width);
    copy_menu(ctx, page, view, corner.y);
  }
  ImGui::EndChild();
  return clicked;
}

}  // namespace alphascope
