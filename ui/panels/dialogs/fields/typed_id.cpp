// SPDX-License-Identifier: GPL-3.0-or-later
// Reads typed ids, and words what is wrong with them.
#include "ui/panels/dialogs/fields/typed_id.hpp"

#include "core/text/printable.hpp"

namespace alphascope {
namespace {

std::string without_blanks(std::string_view text) {
  constexpr const char* kBlanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == text.npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(kBlanks) - first + 1));
}

// Whether the text is an accession without the name of its archive.
bool is_accession(const std::string& text) {
  try {
    return molecule_id("af:" + text).has_value();
  } catch (const InvalidId&) {
    return false;
  }
}

}  // namespace

TypedId read_typed_id(std::string_view text, const FetchOptions& options) {
  TypedId typed;
  const std::string id = without_blanks(text);
  if (id.empty()) return typed;
  try {
    typed.id = molecule_id(id);
    if (!typed.id) {
      typed.fault = is_accession(id)
                        ? "This is an accession of UniProt. Its model is af:" + printable(id) + "."
                        : "This is not a valid id. Ids look like 1CRN, pdb_00001crn and af:P69905.";
    }
  } catch (const InvalidId& error) {
    typed.fault = error.rule;
  }
  if (!typed.id) return typed;
  typed.id->without_name = false;  // nobody looked for a file of that name
  if (const auto before = fetched_before(*typed.id, options)) typed.before = before->from;
  return typed;
}

const TypedId& IdField::read(const FetchOptions& options) {
  if (read_text_ != text) {
    read_ = read_typed_id(text, options);
    read_text_ = text;
  }
  return read_;
}

void IdField::clear() {
  text.clear();
  read_text_.reset();
}

}  // namespace alphascope
