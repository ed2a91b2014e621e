// SPDX-License-Identifier: GPL-3.0-or-later
// Turns a phrase into a sentence.
#pragma once

#include <cctype>
#include <string>

namespace alphascope {

// Makes the first letter a capital if it is an English one, and adds a full stop. An empty phrase
// stays empty.
inline std::string as_sentence(std::string phrase) {
  if (phrase.empty()) return phrase;
  phrase.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(phrase.front())));
  if (phrase.back() != '.') phrase += '.';
  return phrase;
}

}  // namespace alphascope
