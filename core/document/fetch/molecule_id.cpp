// SPDX-License-Identifier: GPL-3.0-or-later
// Checks ids character by character, because they become parts of addresses.
#include "core/document/fetch/molecule_id.hpp"

#include <system_error>

#include "core/text/as_sentence.hpp"
#include "core/text/printable.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPdb = "pdb:", kAlphaFold = "af:", kLongPdb = "pdb_";
constexpr std::size_t kShownCharacters = 40;

// Not those of <cctype>, which depend on the locale.
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_upper(char c) {
  return c >= 'A' && c <= 'Z';
}

std::string in_upper_case(std::string_view text) {
  std::string upper(text);
  for (char& c : upper) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return upper;
}

std::string in_lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (is_upper(c)) c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

// Whether the text is as the pattern: 0 is a digit, A a letter in upper case, X either of them; 1
// is a digit that is not 0.
bool matches(std::string_view text, std::string_view pattern) {
  if (text.size() != pattern.size()) return false;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const bool digit = is_digit(text[k]), letter = is_upper(text[k]);
    const bool fits = pattern[k] == '0'   ? digit
                      : pattern[k] == '1' ? digit && text[k] != '0'
                      : pattern[k] == 'A' ? letter
                                          : digit || letter;
    if (!fits) return false;
  }
  return true;
}

// The id of an entry of the PDB; empty if the text is none. An id of twelve characters whose digits
// begin with 0000 is the entry that has the last four characters as its id.
std::string pdb_id(std::string_view text) {
  const std::string upper = in_upper_case(text);
  if (matches(upper, "1XXX")) return upper;
  if (!in_lower_case(text).starts_with(kLongPdb)) return {};
  const std::string_view rest = std::string_view(upper).substr(kLongPdb.size());
  if (!matches(rest, "XXXXXXXX")) return {};
  if (rest.starts_with("0000") && matches(rest.substr(4), "1XXX")) {
    return std::string(rest.substr(4));
  }
  return in_lower_case(text);
}

// The accession of UniProt; empty if the text is none. UniProt's rule: six characters, or ten.
std::string accession(std::string_view text) {
  const std::string upper = in_upper_case(text);
  const bool opq =
      !upper.empty() && std::string_view("OPQ").find(upper[0]) != std::string_view::npos;
  const bool valid =
      opq ? matches(upper, "A0XXX0") : matches(upper, "A0AXX0") || matches(upper, "A0AXX0AXX0");
  return valid ? upper : std::string();
}

// `examples` go on with the fault for people, and `more` for the command line.
[[noreturn]] void refuse(std::string_view typed, const std::string& fault, const char* examples,
                         const char* more) {
  std::string shown(typed.substr(0, kShownCharacters));
  if (typed.size() > kShownCharacters) shown += "…";
  throw InvalidId("\"" + printable(shown) + "\": there is no such file, and " + fault + more,
                  as_sentence(fault + examples));
}

}  // namespace

std::string MoleculeId::text() const {
  return std::string(archive == Archive::pdb ? kPdb : kAlphaFold) + id;
}

std::optional<MoleculeId> molecule_id(std::string_view typed) {
  const std::string lower = in_lower_case(typed.substr(0, kPdb.size()));
  MoleculeId found{Archive::pdb, {}, std::string(typed), false};
  if (lower == kPdb) {
    found.id = pdb_id(typed.substr(kPdb.size()));
    if (found.id.empty()) {
      refuse(typed, "the part after pdb: is not a valid id of the PDB",
             ", such as 1CRN or pdb_00001crn",
             ". An id has four letters or digits, such as pdb:1CRN, or twelve characters, such as "
             "pdb:pdb_00001crn. For an assembly, add --assembly ID");
    }
    return found;
  }
  if (lower.starts_with(kAlphaFold)) {
    found.archive = Archive::alphafold;
    found.id = accession(typed.substr(kAlphaFold.size()));
    if (found.id.empty()) {
      refuse(typed, "the part after af: is not a valid accession of UniProt", ", such as P69905",
             ". An accession has six or ten letters and digits, such as af:P69905");
    }
    return found;
  }
  found.id = pdb_id(typed);
  if (found.id.empty()) return std::nullopt;
  found.without_name = true;
  return found;
}

std::optional<MoleculeId> molecule_id_unless_file(const fs::path& typed) {
  std::error_code error;
  const fs::file_type type = fs::symlink_status(typed, error).type();
  // A name that is too long belongs to no file, and its error is not "not found".
  if (type != fs::file_type::not_found && type != fs::file_type::none) return std::nullopt;
  return molecule_id(typed.native());
}

}  // namespace alphascope
