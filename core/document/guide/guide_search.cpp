// SPDX-License-Identifier: GPL-3.0-or-later
// Searches the pages of the guide for words.
#include <algorithm>

#include "core/document/guide/guide.hpp"
#include "core/text/letter_case.hpp"
#include "core/text/text_parts.hpp"
#include "core/text/utf8.hpp"

namespace alphascope {
namespace {

constexpr std::size_t kBefore = 24, kExcerpt = 160;  // bytes of an excerpt

// Letters and digits; bytes of other letters than ASCII count as letters.
bool in_word(char c) {
  return (lower_case(c) >= 'a' && lower_case(c) <= 'z') || (c >= '0' && c <= '9') ||
         static_cast<unsigned char>(c) >= 0x80;
}

bool begins_with(std::string_view text, std::string_view word) {
  if (text.size() < word.size()) return false;
  return std::equal(word.begin(), word.end(), text.begin(),
                    [](char a, char b) { return a == lower_case(b); });
}

// The text around `at`, with "…" where something is left out.
std::string excerpt_of(const std::string& text, std::size_t at) {
  std::size_t begin = at > kBefore ? at - kBefore : 0;
  if (begin > 0) {
    const std::size_t blank = text.find_first_of(" \t\n", begin);
    begin = blank < at ? blank + 1 : at;
  }
  std::size_t end = std::min(begin + kExcerpt, text.size());
  while (end < text.size() && continues_character(text[end])) --end;
  std::string excerpt = text.substr(begin, end - begin);
  for (char& c : excerpt) c = c == '\t' || c == '\n' ? ' ' : c;
  return (begin > 0 ? "…" : "") + excerpt + (end < text.size() ? "…" : "");
}

bool has_all(const std::string& text, const std::vector<std::string>& words) {
  return std::all_of(words.begin(), words.end(), [&](const std::string& word) {
    return find_word(text, {word}, 0).first != text.npos;
  });
}

}  // namespace

std::vector<std::string> query_words(std::string_view query) {
  return words_of(lower_case(query));
}

std::pair<std::size_t, std::size_t> find_word(std::string_view text,
                                              const std::vector<std::string>& words,
                                              std::size_t from) {
  for (std::size_t at = from; at < text.size(); ++at) {
    // A query such as "--alpha" begins with a mark, so it may follow a letter.
    if (at > 0 && in_word(text[at - 1]) && in_word(text[at])) continue;
    for (const std::string& word : words) {
      if (!word.empty() && begins_with(text.substr(at), word)) return {at, word.size()};
    }
  }
  return {text.npos, 0};
}

std::vector<GuideHit> search_guide(const Guide& guide, std::string_view query) {
  const std::vector<std::string> words = query_words(query);
  std::vector<GuideHit> hits;
  if (words.empty()) return hits;
  for (std::size_t p = 0; p < guide.pages.size(); ++p) {
    std::string heading;
    const std::vector<MarkdownBlock>& blocks = guide.pages[p].blocks;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      const std::string text = plain_text(blocks[b]);
      if (blocks[b].kind == MarkdownKind::heading) heading = text;
      if (!has_all(text, words)) continue;
      hits.push_back({{p, b}, heading, excerpt_of(text, find_word(text, words, 0).first)});
    }
  }
  return hits;
}

}  // namespace alphascope
