// A phrase as a sentence of its own.
#pragma once

#include <cctype>
#include <string>

namespace alphascope {

// With a capital first letter, where that is an English one, and with a full stop. Of nothing,
// nothing.
inline std::string as_sentence(std::string phrase) {
  if (phrase.empty()) return phrase;
  phrase.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(phrase.front())));
  if (phrase.back() != '.') phrase += '.';
  return phrase;
}

}  // namespace alphascope
