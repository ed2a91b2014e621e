// SPDX-License-Identifier: GPL-3.0-or-later
// Scores commands by the words that a user types.
#include "core/document/commands/command_search.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <sstream>

#include "core/document/commands/commands.hpp"
#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/text/letter_case.hpp"

namespace alphascope {
namespace {

// Cost of a word by the place of its match. The least sum comes first.
constexpr int kIdItself = 0, kWordOfTitle = 1, kStartInTitle = 2, kStartInId = 3, kInside = 4,
              kStartInHelp = 6, kInOrder = 8;
constexpr int kSynonym = 2, kStartOfSynonym = 3;
constexpr int kWithArguments = 3;  // larger than kSynonym, since a synonym is more likely meant

bool part_of_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || static_cast<unsigned char>(c) >= 0x80;
}

enum class Found : std::uint8_t { nowhere, inside, at_start, whole };

Found find_word(std::string_view text, std::string_view word) {
  Found best = Found::nowhere;
  for (std::size_t at = text.find(word); at != std::string_view::npos;
       at = text.find(word, at + 1)) {
    const bool start = at == 0 || !part_of_word(text[at - 1]);
    const std::size_t end = at + word.size();
    const bool whole = start && (end == text.size() || !part_of_word(text[end]));
    best = std::max(best, whole ? Found::whole : start ? Found::at_start : Found::inside);
  }
  return best;
}

bool in_order(std::string_view text, std::string_view letters) {
  for (const char c : text) {
    if (!letters.empty() && c == letters.front()) letters.remove_prefix(1);
  }
  return letters.empty();
}

std::optional<int> cost(const CommandSpec& spec, const std::string& word) {
  const std::string id = lower_case(spec.id);
  std::string title = lower_case(spec.title);
  if (title.ends_with("…")) title.resize(title.size() - std::string_view("…").size());
  if (word == id) return kIdItself;
  const Found in_title = find_word(title, word), in_id = find_word(id, word);
  if (in_title == Found::whole) return kWordOfTitle;
  if (in_title == Found::at_start) return kStartInTitle;
  if (in_id >= Found::at_start) return kStartInId;
  if (in_title == Found::inside || in_id == Found::inside) return kInside;
  if (find_word(lower_case(spec.help), word) >= Found::at_start) return kStartInHelp;
  // A single letter would match nearly everything.
  if (word.size() > 1 && (in_order(title, word) || in_order(id, word))) return kInOrder;
  return std::nullopt;
}

struct Word {
  std::string text;
  std::size_t begin;  // position in the typed text
};

std::vector<Word> typed_words(std::string_view typed) {
  std::vector<Word> words;
  for (std::size_t at = typed.find_first_not_of(' '); at != std::string_view::npos;) {
    const std::size_t end = std::min(typed.find(' ', at), typed.size());
    words.push_back({lower_case(typed.substr(at, end - at)), at});
    at = typed.find_first_not_of(' ', end);
  }
  return words;
}

bool looks_like_a_number(const std::string& word) {
  const char c = word.front();
  return std::isdigit(static_cast<unsigned char>(c)) || c == '-' || c == '+' || c == '.' ||
         word.starts_with("−");
}

// Text that is no valid number counts as an argument, too; the command then explains the mistake.
bool may_be_arguments(const CommandSpec& spec, std::string_view text, const std::string& first) {
  if (spec.parameters.empty()) return false;
  if (spec.parameters[0].kind == Parameter::Kind::number && looks_like_a_number(first)) return true;
  const CommandLine line = Commands::parse_words(spec, text);
  if (!line.error.empty()) return false;
  const Commands::Reading reading = Commands::read(spec, line.words);
  return reading.error.empty() || reading.missing != nullptr;
}

struct Scored {
  CommandMatch match;
  int cost;
};

std::optional<Scored> match(const CommandSpec& spec, std::string_view typed,
                            const std::vector<Word>& words) {
  int sum = 0;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string_view rest = typed.substr(words[i].begin);
    const bool named = i > 0 && words[0].text == lower_case(spec.id);
    if (named) return Scored{{&spec, std::string(rest)}, kIdItself};
    const auto word = cost(spec, words[i].text);
    const bool number = looks_like_a_number(words[i].text);
    if (i > 0 && (!word || number) && may_be_arguments(spec, rest, words[i].text)) {
      return Scored{{&spec, std::string(rest)}, sum + kWithArguments};
    }
    if (!word) return std::nullopt;
    sum += *word;
  }
  return Scored{{&spec, {}}, sum};
}

// At least one word must match a synonym; the others may match the command itself.
std::optional<Scored> match(const CommandSpec& spec, const Synonym& synonym,
                            const std::vector<Word>& words) {
  const std::string synonyms = lower_case(synonym.words);
  int sum = 0;
  bool any = false;
  for (const Word& word : words) {
    const Found found = find_word(synonyms, word.text);
    any |= found >= Found::at_start;
    if (found >= Found::at_start) {
      sum += found == Found::whole ? kSynonym : kStartOfSynonym;
    } else if (const auto own = cost(spec, word.text)) {
      sum += *own;
    } else {
      return std::nullopt;
    }
  }
  if (!any) return std::nullopt;
  return Scored{{&spec, synonym.arguments}, sum};
}

}  // namespace

std::vector<CommandMatch> search_commands(const Commands& commands, std::string_view typed) {
  const std::vector<Word> words = typed_words(typed);
  std::vector<Scored> found;
  for (const CommandSpec& spec : commands.all()) {
    auto best = match(spec, typed, words);
    for (const Synonym& synonym : spec.synonyms) {
      auto scored = match(spec, synonym, words);
      if (!scored) continue;
      if (!synonym.arguments.empty()) {
        found.push_back(std::move(*scored));  // beside the command itself
      } else if (!best || scored->cost < best->cost) {
        best = std::move(scored);
      }
    }
    if (best) found.push_back(std::move(*best));
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Scored& a, const Scored& b) { return a.cost < b.cost; });
  std::vector<CommandMatch> matches;
  matches.reserve(found.size());
  for (Scored& s : found) matches.push_back(std::move(s.match));
  return matches;
}

}  // namespace alphascope
