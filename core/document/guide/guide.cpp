// SPDX-License-Identifier: GPL-3.0-or-later
// Loads the pages, and follows links between them. guide_search.cpp searches them.
#include "core/document/guide/guide.hpp"

#include <algorithm>
#include <utility>

#include "core/files/read_error.hpp"
#include "core/text/letter_case.hpp"
#include "core/text_files/small_text.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFirstPage = "guide/README.md";
constexpr std::uint64_t kLargestPage = std::uint64_t{4} << 20;  // bytes
constexpr std::size_t kMostPages = 100;

std::vector<MarkdownBlock> read_page(const fs::path& file) {
  return read_markdown(
      read_small_text(file, {"the page of the user guide", kLargestPage,
                             "Install the documentation again; its pages are smaller"}));
}

bool is_address(std::string_view link) {
  return link.find("://") != link.npos || link.starts_with("mailto:");
}

// The file to which a link leads, within the folder of docs. Empty: no page.
std::string file_of_link(const std::string& from, std::string_view link) {
  const std::string_view target = link.substr(0, link.find('#'));
  if (is_address(link)) return {};
  if (target.empty()) return from;
  const fs::path file = (fs::path(from).parent_path() / target).lexically_normal();
  return file.extension() == ".md" ? file.string() : std::string();
}

// The text of the first heading; without one, the file's name.
std::string title_of(const GuidePage& page) {
  for (const MarkdownBlock& block : page.blocks) {
    if (block.kind == MarkdownKind::heading) return plain_text(block);
  }
  return page.name();
}

void add_page(Guide& guide, GuidePage page) {
  const auto listed = [&](const GuidePage& other) { return other.file == page.file; };
  if (page.file.empty() || guide.pages.size() == kMostPages) return;
  if (std::any_of(guide.pages.begin(), guide.pages.end(), listed)) return;
  try {
    page.blocks = read_page(guide.docs / page.file);
  } catch (const ReadError& error) {
    page.problem = error.what();
  }
  if (page.title.empty()) page.title = title_of(page);
  guide.pages.push_back(std::move(page));
}

// Adds the pages to which a block of README.md links. A row of its table gives the title and the
// summary of a page.
void add_linked_pages(Guide& guide, const MarkdownBlock& block) {
  const bool row = block.kind == MarkdownKind::row && !block.cells.empty();
  for (std::size_t cell = 0; cell < block.cells.size(); ++cell) {
    for (const MarkdownSpan& span : block.cells[cell]) {
      if (span.link.empty()) continue;
      GuidePage page{.file = file_of_link(kFirstPage, span.link), .title = {}};
      if (row && cell == 0) {
        page.title = plain_text(block.cells[0]);
        if (block.cells.size() > 1) page.summary = plain_text(block.cells[1]);
      }
      add_page(guide, std::move(page));
    }
  }
}

}  // namespace

std::string GuidePage::name() const {
  return fs::path(file).stem().string();
}

Guide load_guide(const fs::path& docs) {
  Guide guide{.docs = docs, .pages = {}};
  GuidePage first{
      .file = kFirstPage, .title = {}, .summary = {}, .blocks = read_page(docs / kFirstPage)};
  first.title = title_of(first);
  guide.pages.push_back(std::move(first));
  const std::vector<MarkdownBlock> blocks = guide.pages.front().blocks;
  for (const MarkdownBlock& block : blocks) add_linked_pages(guide, block);
  return guide;
}

std::optional<GuidePlace> follow_link(const Guide& guide, std::size_t page, std::string_view link) {
  const std::string file = file_of_link(guide.pages.at(page).file, link);
  const auto found = std::find_if(guide.pages.begin(), guide.pages.end(),
                                  [&](const GuidePage& p) { return p.file == file; });
  if (file.empty() || found == guide.pages.end()) return std::nullopt;
  GuidePlace place{static_cast<std::size_t>(found - guide.pages.begin()), 0};
  const std::size_t mark = link.find('#');
  const std::string_view wanted = mark == link.npos ? "" : link.substr(mark + 1);
  // Headings with the same words get -1, -2 and so on; the first of them is near enough.
  for (std::size_t n = 0; n < found->blocks.size() && !wanted.empty(); ++n) {
    const MarkdownBlock& block = found->blocks[n];
    if (block.kind != MarkdownKind::heading) continue;
    if (markdown_anchor(plain_text(block)) != wanted) continue;
    place.block = n;
    break;
  }
  return place;
}

std::optional<GuidePlace> find_page(const Guide& guide, std::string_view name) {
  const std::size_t mark = std::min(name.find('#'), name.size());
  std::string page = lower_case(name.substr(0, mark));
  if (page.ends_with(".md")) page.resize(page.size() - 3);
  for (std::size_t n = 0; n < guide.pages.size(); ++n) {
    const bool same =
        lower_case(guide.pages[n].name()) == page || lower_case(guide.pages[n].title) == page;
    if (same) return follow_link(guide, n, name.substr(mark));
  }
  return std::nullopt;
}

}  // namespace alphascope
