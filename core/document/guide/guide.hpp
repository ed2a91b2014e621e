// SPDX-License-Identifier: GPL-3.0-or-later
// The user guide: the pages that docs/guide/README.md lists, the targets of their links, and a
// search through all of them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/document/guide/markdown.hpp"

namespace alphascope {

struct GuidePage {
  std::string file;          // within the folder of docs: "guide/window.md"
  std::string title;         // "The window"
  std::string summary = {};  // for whom or what the page is; may be empty
  std::vector<MarkdownBlock> blocks = {};
  std::string problem = {};  // why it cannot be read; empty: it was

  std::string name() const;  // "window": the file's name without folder and ending
};

struct Guide {
  std::filesystem::path docs;    // the folder of docs
  std::vector<GuidePage> pages;  // in the order of README.md, which is the first
};

// Reads the guide below the folder of docs. Throws ReadError if README.md cannot be read. Another
// page that cannot be read has its `problem`.
Guide load_guide(const std::filesystem::path& docs);

// A place in the guide: a block of a page.
struct GuidePlace {
  std::size_t page = 0, block = 0;

  bool operator==(const GuidePlace&) const = default;
};

// The place to which a link leads, written in `page`. Empty: it is no page of the guide.
std::optional<GuidePlace> follow_link(const Guide& guide, std::size_t page, std::string_view link);
// The page of this name, such as "window", or "window#undo" for one of its headings.
std::optional<GuidePlace> find_page(const Guide& guide, std::string_view name);

struct GuideHit {
  GuidePlace place;
  std::string heading;  // above the text; empty: none
  std::string excerpt;  // the text around the first word found, on one line
};

// The words of a query, in small letters.
std::vector<std::string> query_words(std::string_view query);
// The next word of `text` from `from` on that begins with one of the words, in any case: where it
// is and how long. {npos, 0}: none.
std::pair<std::size_t, std::size_t> find_word(std::string_view text,
                                              const std::vector<std::string>& words,
                                              std::size_t from);
// All blocks in which each word of the query begins a word, in the order of pages.
std::vector<GuideHit> search_guide(const Guide& guide, std::string_view query);

}  // namespace alphascope
