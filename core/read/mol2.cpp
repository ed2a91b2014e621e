// SPDX-License-Identifier: GPL-3.0-or-later
// MOL2 of Tripos: sections that begin with "@<TRIPOS>", of which these are read:
//   MOLECULE      name; number of atoms; further molecules become models
//   ATOM          number name x y z type [substructure-number [substructure-name …]]
//   BOND          number atom atom type (1, 2, 3, am, ar; nc: not connected)
//   SUBSTRUCTURE  number name first-atom [type [dictionary [chain [residue-name …]]]]
// SYBYL's atom types give the elements. Substructures are residues.
#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/read/file_format.hpp"
#include "core/read/molecule_builder.hpp"
#include "core/read/residues/atom_names.hpp"
#include "core/text/printable.hpp"
#include "core/text_files/line_reader.hpp"

namespace alphascope {
namespace {

constexpr std::size_t kProgressLines = 65536;
constexpr std::size_t kShortestAtom = 14;  // bytes of "1 C 0 0 0 C.3" with its line end
constexpr std::string_view kMark = "@<TRIPOS>";

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_upper(char c) {
  return c >= 'A' && c <= 'Z';
}
bool is_lower(char c) {
  return c >= 'a' && c <= 'z';
}

// The element of a type such as "C.ar", "N.am", "Cl" or "Cr.th". SYBYL writes the symbol with one
// capital, then a point and the kind. "ca" and "CA" are types of force fields and mean carbon, so
// they state no element.
StatedElement sybyl_element(std::string_view type) {
  const std::string_view head = type.substr(0, type.find('.'));
  if (head == "LP" || head == "Du") return {ElementStatement::virtual_site, kUnknownElement};
  for (const std::string_view any : {"Any", "Hal", "Het", "Hev"}) {
    if (head == any) return {ElementStatement::placeholder, kUnknownElement};
  }
  const bool as_people = (head.size() == 1 && is_upper(head[0])) ||
                         (head.size() == 2 && is_upper(head[0]) && is_lower(head[1]));
  return as_people ? stated_element(head) : StatedElement{ElementStatement::other, kUnknownElement};
}

// True for placeholders such as "****" and "<0>".
bool is_no_name(std::string_view text) {
  return text.empty() || text.front() == '<' || text.find_first_not_of('*') == text.npos;
}

BondOrder bond_order(std::string_view type) {
  if (type == "1" || type == "am") return BondOrder::one;  // am: amide
  if (type == "2") return BondOrder::two;
  if (type == "3") return BondOrder::three;
  return type == "ar" ? BondOrder::aromatic : BondOrder::unknown;
}

struct Substructure {
  std::string_view name, chain, residue;  // empty: not given
};

struct ResidueOfAtom {
  std::string_view name;
  std::int32_t number = 0;
  char insertion_code = ' ';
};

// Splits "HIS87" and "HIS87A". The whole text is the name where it has no number.
ResidueOfAtom parts_of_name(std::string_view text, std::int32_t number) {
  std::size_t end = text.size();
  char code = ' ';
  if (end > 1 && is_upper(text[end - 1]) && is_digit(text[end - 2])) code = text[--end];
  std::size_t begin = end;
  while (begin > 0 && is_digit(text[begin - 1])) --begin;
  ResidueOfAtom parts{text.substr(0, begin), 0, code};
  if (begin == 0 || begin == end || !parse_whole(text.substr(begin, end - begin), parts.number)) {
    return {text, number, ' '};
  }
  return parts;
}

// The residue name recorded for the substructure decides. Without a record a known residue name
// counts. "PO4" is such a name, and "ALA4" is residue 4 of type ALA.
ResidueOfAtom residue_of(std::string_view name, std::int32_t number, std::string_view recorded) {
  if (is_no_name(name)) name = {};
  const ResidueOfAtom whole{name, number, ' '}, parts = parts_of_name(name, number);
  if (!is_no_name(recorded)) {
    if (parts.name == recorded) return parts;
    return {recorded, name == recorded ? number : parts.number, parts.insertion_code};
  }
  if (residue_family(name) != ResidueFamily::unknown) return whole;
  if (residue_family(parts.name) != ResidueFamily::unknown) return parts;
  return parts.number == number ? parts : whole;
}

class Mol2Reader {
 public:
  explicit Mol2Reader(const ReaderInput& input)
      : input_(input), lines_(input.text), builder_(input.source, "MOL2") {}

  Molecule read() {
    std::string_view line;
    while (lines_.next(line)) {
      if (lines_.number() % kProgressLines == 0) input_.report(lines_.bytes_left());
      if (line.starts_with(kMark)) {
        begin_section(trimmed(line.substr(kMark.size())));
      } else if (section_ == Section::molecule) {
        take_molecule(line);
      } else if (!trimmed(line).empty() && line.front() != '#') {
        take(line);
      }
    }
    finish_molecule();
    guesser_.add_note(builder_.molecule(), "because their types name none");
    return builder_.finish();
  }

 private:
  enum class Section : std::uint8_t { other, molecule, atoms, bonds, substructures };

  struct Placed {
    std::size_t atom = 0;
    std::int32_t substructure = 0;
    std::string_view name, type;
  };

  void begin_section(std::string_view name) {
    section_ = name == "MOLECULE"       ? Section::molecule
               : name == "ATOM"         ? Section::atoms
               : name == "BOND"         ? Section::bonds
               : name == "SUBSTRUCTURE" ? Section::substructures
                                        : Section::other;
    if (section_ == Section::molecule) {
      finish_molecule();
      builder_.begin_model(++molecules_);
      molecule_line_ = 0;
    } else if (molecules_ == 0 && section_ != Section::other) {
      fail("@<TRIPOS>" + shortened(name) + " comes before any @<TRIPOS>MOLECULE",
           "A MOL2 file begins with @<TRIPOS>MOLECULE, a name and the number of atoms; the file's "
           "beginning may be missing");
    }
  }

  // The name may be blank. The count is the first field of the next line.
  void take_molecule(std::string_view line) {
    ++molecule_line_;
    if (molecule_line_ == 1 && molecules_ == 1) {
      builder_.molecule().title = std::string(trimmed(line));
    }
    if (molecule_line_ != 2) return;
    count_line_ = lines_.number();
    const std::string_view whole = trimmed(line);
    if (!parse_whole(next_field(line), count_)) {
      fail("expected the number of atoms, found \"" + shortened(whole) + "\"",
           "Behind @<TRIPOS>MOLECULE come a name and, in the next line, the number of atoms");
    }
    if (builder_.size() == 0) {
      builder_.reserve(std::min(count_, lines_.bytes_left() / kShortestAtom));
    }
  }

  void take(std::string_view line) {
    if (trimmed(line).ends_with('\\')) {
      fail("the line goes on in the next one, which is not read",
           "Write the file again with each record in one line, for example with Open Babel");
    }
    if (section_ == Section::atoms) take_atom(line);
    if (section_ == Section::bonds) take_bond(line);
    if (section_ == Section::substructures) take_substructure(line);
  }

  void take_atom(std::string_view line) {
    if (placed_.size() == count_) {
      fail("more atoms than the " + std::to_string(count_) + " that line " +
               std::to_string(count_line_) + " announces",
           "Correct the count or remove the surplus lines");
    }
    Atom atom;
    atom.source_line = static_cast<std::uint32_t>(lines_.number());
    atom.serial = static_cast<std::int32_t>(builder_.size() + 1);  // unique within the molecule
    const std::int64_t id = whole_number(next_field(line), "the number of the atom");
    if (!serials_.emplace(id, atom.serial).second) {
      fail("atom " + std::to_string(id) + " is there twice", "Number the atoms of a molecule anew");
    }
    atom.name = builder_.molecule().names.intern(next_field(line));
    std::array<Decimal, 3> position;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      position[axis] = number(next_field(line), "xyz"[axis]);
    }
    Placed placed{.atom = builder_.size(), .substructure = 0, .name = {}, .type = next_field(line)};
    if (placed.type.empty()) {
      fail("the line ends before the type of the atom",
           "An atom is \"number name x y z type\"; the line may be truncated");
    }
    const std::string_view substructure = next_field(line);
    if (!substructure.empty()) {
      placed.substructure =
          static_cast<std::int32_t>(whole_number(substructure, "the number of the substructure"));
    }
    placed.name = next_field(line);
    builder_.set_record({});
    builder_.add(atom, position);
    placed_.push_back(placed);
  }

  void take_bond(std::string_view line) {
    next_field(line);
    const std::int32_t a = bonded_atom(next_field(line)), b = bonded_atom(next_field(line));
    const std::string_view type = next_field(line);
    if (type != "nc") builder_.records().bonds.add({a, b, bond_order(type)});
  }

  std::int32_t bonded_atom(std::string_view text) const {
    const std::int64_t id = whole_number(text, "the number of a bonded atom");
    const auto found = serials_.find(id);
    if (found != serials_.end()) return found->second;
    fail("the bond names atom " + std::to_string(id) + ", which is not in the molecule",
         "Correct the bond, or fetch the file again");
  }

  void take_substructure(std::string_view line) {
    const std::int64_t id = whole_number(next_field(line), "the number of the substructure");
    Substructure s;
    s.name = next_field(line);
    for (int passed_over = 0; passed_over < 3; ++passed_over) next_field(line);
    s.chain = next_field(line);
    s.residue = next_field(line);
    substructures_[id] = s;
  }

  // Called at the end, because substructures follow the atoms and elements depend on residue names.
  void finish_molecule() {
    if (molecules_ == 0) return;
    if (placed_.size() != count_) {
      throw ReadError(input_.source, count_line_,
                      "this line announces " + std::to_string(count_) + " atoms, but " +
                          std::to_string(placed_.size()) + " follow",
                      "The file is incomplete or the count is wrong; fetch it again");
    }
    Molecule& molecule = builder_.molecule();
    for (const Placed& placed : placed_) {
      Atom& atom = molecule.atoms[placed.atom];
      const auto found = substructures_.find(placed.substructure);
      const Substructure s = found == substructures_.end() ? Substructure{} : found->second;
      const ResidueOfAtom residue =
          residue_of(placed.name.empty() ? s.name : placed.name, placed.substructure, s.residue);
      atom.residue_name = molecule.names.intern(residue.name);
      atom.residue_number = residue.number;
      atom.insertion_code = residue.insertion_code;
      if (!is_no_name(s.chain)) atom.chain = atom.label_chain = molecule.names.intern(s.chain);
      const ResidueFamily family =
          guesser_.identify(atom, sybyl_element(placed.type), NamePlace::free, molecule.names);
      atom.kind = residue_kind(family, false);
    }
    placed_.clear();
    serials_.clear();
    substructures_.clear();
    count_ = 0;
  }

  std::int64_t whole_number(std::string_view text, const char* what) const {
    std::int32_t value = 0;
    if (parse_whole(text, value)) return value;
    fail(std::string("expected ") + what + ", found \"" + shortened(text) + "\"",
         "It must be a whole number; the line may be truncated or damaged");
  }

  Decimal number(std::string_view text, char what) const {
    Decimal value;
    const DecimalStatus status = parse_decimal(text, value);
    if (status == DecimalStatus::ok) return value;
    fail(
        std::string("expected a number for ") + what + ", found \"" + shortened(text) + "\"",
        remedy_of_number(
            status, "An atom is \"number name x y z type\"; the line may be truncated or damaged"));
  }

  [[noreturn]] void fail(std::string reason, std::string remedy) const {
    throw ReadError(input_.source, lines_.number(), std::move(reason), std::move(remedy));
  }

  const ReaderInput& input_;
  LineReader lines_;
  MoleculeBuilder builder_;
  AtomGuesser guesser_;
  Section section_ = Section::other;
  int molecules_ = 0;
  std::size_t molecule_line_ = 0;  // line of the section MOLECULE
  // State of the molecule that is being read.
  std::size_t count_ = 0, count_line_ = 0;
  std::vector<Placed> placed_;
  std::unordered_map<std::int64_t, std::int32_t> serials_;  // keys are the numbers in the file
  std::unordered_map<std::int64_t, Substructure> substructures_;
};

Molecule read_mol2(const ReaderInput& input) {
  return Mol2Reader(input).read();
}

Recognised recognise_mol2(const FileSample& sample) {
  return sample.first.starts_with(kMark) ? Recognised::certain : Recognised::by_ending;
}

}  // namespace

FileFormat mol2_format() {
  return {"mol2", "MOL2", {".mol2"}, recognise_mol2, read_mol2};
}

}  // namespace alphascope
