// SPDX-License-Identifier: GPL-3.0-or-later
// XYZ: a line with the number of atoms, a comment, then "symbol x y z …". Further frames follow in
// the same way and become models. The comment of extended XYZ describes the columns. Tinker's files
// have the same ending, but no comment, and they number their atoms.
#include <optional>
#include <set>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/read/field_kinds.hpp"
#include "core/read/file_format.hpp"
#include "core/read/molecule_builder.hpp"
#include "core/read/residues/atom_names.hpp"
#include "core/read/residues/virtual_sites.hpp"
#include "core/text/printable.hpp"
#include "core/text_files/line_reader.hpp"

namespace alphascope {
namespace {

constexpr std::size_t kProgressAtoms = 65536;

struct XyzLayout {
  std::size_t symbol = 0, x = 1;
  std::optional<std::size_t> radius;
  std::size_t fields = 4;  // at least
};

// The element of "C", "CL", "C12", "13C" or "6". These are a symbol, perhaps with a number or the
// isotope's mass, or an atomic number. kUnknownElement for a placeholder or the name of an atom.
Element element_of(std::string_view symbol) {
  std::size_t number = 0;
  if (parse_whole(symbol, number)) {
    return number <= kHeaviestElement ? static_cast<Element>(number) : kUnknownElement;
  }
  const std::size_t mass = std::min(symbol.find_first_not_of("0123456789"), symbol.size());
  if (mass > 0 && mass <= 3) return element_from_symbol(symbol.substr(mass));
  std::size_t letters = 0;
  while (letters < symbol.size() && (symbol[letters] | 0x20) >= 'a' &&
         (symbol[letters] | 0x20) <= 'z') {
    ++letters;
  }
  return element_from_symbol(symbol.substr(0, letters));
}

class XyzReader {
 public:
  XyzReader(const ReaderInput& input, bool tinker)
      : input_(input),
        lines_(input.text),
        builder_(input.source, tinker ? "Tinker XYZ" : "XYZ"),
        tinker_(tinker) {
    if (tinker) layout_ = {1, 2, std::nullopt, 5};
  }

  Molecule read() {
    std::string_view line;
    int frame = 0;
    while (next_filled(line)) {
      read_count(line);
      builder_.begin_model(++frame);
      if (!tinker_) read_comment();
      for (std::size_t k = 0; k < count_; ++k) {
        if (!lines_.next(line) || trimmed(line).empty()) {
          fail("the atoms end after " + std::to_string(k) + " of the " + std::to_string(count_) +
                   " that line " + std::to_string(count_line_) + " announces",
               "The file is truncated or the count is wrong; fetch it again or correct the count");
        }
        if (tinker_ && k == 0 && is_box(line)) {
          --k;
          continue;
        }
        take_atom(line);
      }
    }
    if (!tinker_ && guesser_.guessed() > 0) read_all_as_names();
    if (are_types()) forget_elements();
    guesser_.add_note(builder_.molecule(), "because they stand in place of symbols");
    return builder_.finish();
  }

 private:
  bool next_filled(std::string_view& line) {
    while (lines_.next(line)) {
      if (!trimmed(line).empty()) return true;
    }
    return false;
  }

  void read_count(std::string_view line) {
    const std::string_view whole = trimmed(line);
    count_line_ = lines_.number();
    const std::string_view first = next_field(line);
    const bool alone = trimmed(line).empty();
    if (!parse_whole(first, count_) || (!alone && !tinker_)) {
      fail("expected the number of atoms, found \"" + shortened(whole) + "\"",
           builder_.size() == 0 ? "An XYZ file begins with the number of its atoms"
                                : "The count of the frame before may be too small; correct it");
    }
    if (tinker_ && builder_.size() == 0) builder_.molecule().title = std::string(trimmed(line));
    // An atom takes at least eight characters, so a wrong count cannot reserve much memory.
    if (builder_.size() == 0) builder_.reserve(std::min(count_, lines_.bytes_left() / 8));
  }

  void read_comment() {
    std::string_view comment;
    if (!lines_.next(comment)) return;
    if (builder_.size() == 0) {
      builder_.molecule().title = std::string(trimmed(comment));
      of_lammps_ = builder_.molecule().title.starts_with("Atoms. Timestep");
    }
    layout_ = {};
    const std::size_t at = comment.find("Properties=");
    if (at == std::string_view::npos) return;
    std::string_view properties = comment.substr(at + 11);
    if (!properties.empty() && properties.front() == '"') properties.remove_prefix(1);
    read_properties(properties.substr(0, properties.find_first_of(" \t\"")));
  }

  // Reads "species:S:1:pos:R:3:radius:R:1": name, type and number of columns of each property.
  void read_properties(std::string_view text) {
    const std::string_view whole = text;
    const auto part = [&] {
      const std::size_t end = text.find(':');
      const std::string_view result = text.substr(0, end);
      text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
      return result;
    };
    std::size_t column = 0;
    bool symbol = false, position = false;
    while (!text.empty()) {
      const std::string_view name = part(), type = part();
      std::size_t width = 0;
      if (type.empty() || !parse_whole(part(), width) || width > 1000) {
        fail("the list of properties \"" + shortened(whole) + "\" is not complete",
             "It must be triples name:type:columns");
      }
      if (name == "species" && width == 1) layout_.symbol = column, symbol = true;
      if (name == "pos" && width == 3) layout_.x = column, position = true;
      if (name == "radius" && width == 1) layout_.radius = column;
      column += width;
    }
    layout_.fields = column;
    if (!symbol || !position) {
      fail("the properties \"" + shortened(whole) + "\" lack species or positions",
           "Extended XYZ needs species:S:1 and pos:R:3");
    }
  }

  // True for Tinker's periodic box, six numbers in the second line.
  static bool is_box(std::string_view line) {
    Decimal value;
    for (int k = 0; k < 6; ++k) {
      if (parse_decimal(next_field(line), value) != DecimalStatus::ok) return false;
    }
    return trimmed(line).empty();
  }

  void take_atom(std::string_view line) {
    if (builder_.size() % kProgressAtoms == 0) input_.report(lines_.bytes_left());
    std::array<Decimal, 3> position;
    std::optional<Decimal> radius;
    std::string_view symbol;
    std::size_t k = 0;
    for (; k < layout_.fields; ++k) {
      const std::string_view field = next_field(line);
      if (field.empty()) break;
      if (k == layout_.symbol) symbol = field;
      if (k >= layout_.x && k < layout_.x + 3)
        position[k - layout_.x] = number(field, "xyz"[k - layout_.x]);
      if (k == layout_.radius) radius = number(field, 'r');
    }
    if (k < layout_.fields) {
      fail("the line has " + std::to_string(k) + " of the " + std::to_string(layout_.fields) +
               " fields that an atom needs here",
           "Complete the line; XYZ atoms are \"symbol x y z\", extended XYZ has what Properties "
           "lists");
    }
    Atom atom;
    atom.source_line = static_cast<std::uint32_t>(lines_.number());
    atom.serial = static_cast<std::int32_t>(builder_.size() + 1);
    atom.name = builder_.molecule().names.intern(symbol);
    take_element(atom, symbol);
    std::size_t number = 0;
    if (parse_whole(symbol, number)) {
      numbers_.insert(number);
    } else {
      only_numbers_ = false;
    }
    if (!radius) return builder_.add(atom, position);
    if (radius->mantissa < 0) fail("the radius is negative", "Radii are in Å and at least 0");
    builder_.add(atom, position, *radius);
  }

  // True when numbers in place of symbols are types of a simulation. In LAMMPS' files they always
  // are. In other files they are types where they run 1, 2, 3 … without a gap, since few molecules
  // contain helium. Three or more atoms that are all 1 are types, too, since a hydrogen molecule
  // has two atoms.
  bool are_types() const {
    if (tinker_ || !only_numbers_ || numbers_.empty()) return false;
    const bool in_turn = *numbers_.begin() == 1 && *numbers_.rbegin() == numbers_.size();
    return of_lammps_ || (in_turn && (numbers_.size() > 1 || builder_.size() > 2));
  }

  void forget_elements() {
    Molecule& molecule = builder_.molecule();
    for (Atom& atom : molecule.atoms) atom.element = kUnknownElement;
    molecule.notes.push_back(
        "The numbers in place of symbols are types of a simulation (" +
        std::to_string(numbers_.size()) +
        "), which name no elements: write symbols or atomic numbers there to have radii");
  }

  // Tinker's symbols are names of a force field, such as CA, HN, OW and Na+. Some XYZ files have
  // such names as well.
  void take_element(Atom& atom, std::string_view symbol) {
    const NameTable& names = builder_.molecule().names;
    if (!tinker_) {
      const Element element = element_of(symbol);
      // Placeholders such as "Du", "X" and "Bq" begin with none of these letters.
      constexpr std::string_view kOfNames = "CHNOPS";
      const bool name = element == kUnknownElement && kOfNames.find(symbol[0]) != kOfNames.npos;
      if (!name) {
        guesser_.identify(atom, element, NamePlace::free, names);
        // "MW" and "EP" are points of a force field. "X", "Bq" and "Du" stay atoms of no element.
        constexpr std::string_view kOfSites = "MELV";
        if (element == kUnknownElement && kOfSites.find(symbol[0]) != kOfSites.npos &&
            is_virtual_site({"", symbol}, ElementStatement::none)) {
          atom.kind = ResidueKind::dummy;
        }
        return;
      }
    }
    const ResidueFamily family = guesser_.identify(atom, StatedElement{}, NamePlace::free, names);
    if (family == ResidueFamily::dummy) atom.kind = ResidueKind::dummy;
  }

  // Some files have names such as HB2. There "CA", "NE" and "OG" are names as well, not Ca, Ne and
  // Og. "NA" stays sodium, which is more frequent in such files than a nitrogen of that name.
  void read_all_as_names() {
    Molecule& molecule = builder_.molecule();
    for (Atom& atom : molecule.atoms) {
      const std::string_view name = molecule.text(atom.name);
      const bool symbol = name.size() < 2 || name == "NA" || (name[1] >= 'a' && name[1] <= 'z');
      if (symbol || atom.element_guessed || atom.element == kUnknownElement) continue;
      if (guess_element({"", name}) == atom.element) continue;
      guesser_.identify(atom, std::nullopt, NamePlace::free, molecule.names);
    }
  }

  Decimal number(std::string_view text, char what) const {
    Decimal value;
    const DecimalStatus status = parse_decimal(text, value);
    if (status == DecimalStatus::ok) return value;
    fail(std::string("expected a number for ") + what + ", found \"" + shortened(text) + "\"",
         remedy_of_number(status,
                          "The count before these atoms may be wrong, or the file is damaged"));
  }

  [[noreturn]] void fail(std::string reason, std::string remedy) const {
    throw ReadError(input_.source, lines_.number(), std::move(reason), std::move(remedy));
  }

  const ReaderInput& input_;
  LineReader lines_;
  MoleculeBuilder builder_;
  AtomGuesser guesser_;
  XyzLayout layout_;
  std::set<std::size_t> numbers_;  // numbers in place of symbols
  bool tinker_, only_numbers_ = true, of_lammps_ = false;
  std::size_t count_ = 0, count_line_ = 0;
};

Molecule read_xyz(const ReaderInput& input) {
  return XyzReader(input, false).read();
}

Molecule read_tinker(const ReaderInput& input) {
  return XyzReader(input, true).read();
}

// True for "1 OW x y z 221 2". One coordinate may be damaged, because Tinker's reader gives the
// best message for it.
bool is_tinker_atom(std::string_view kinds) {
  if (kinds.size() < 6 || kinds[0] != 'i' || kinds[1] != 'w' || kinds[5] != 'i') return false;
  return std::count(kinds.begin() + 2, kinds.begin() + 5, 'w') <= 1;
}

Recognised recognise_tinker(const FileSample& sample) {
  if (!field_kinds(sample.first).starts_with('i')) return Recognised::no;
  const std::string kinds = field_kinds(sample.second), below = field_kinds(sample.third);
  const bool box = kinds.size() == 6 && are_numbers_from(kinds, 0, 6);
  const bool behind_box = box && below.size() >= 6 && below[0] == 'i' && below[1] == 'w';
  return is_tinker_atom(kinds) || behind_box ? Recognised::certain : Recognised::no;
}

Recognised recognise_xyz(const FileSample& sample) {
  if (field_kinds(sample.first) != "i") return Recognised::by_ending;
  const std::string below = field_kinds(sample.third);
  const bool atom = below.size() >= 4 && below[0] == 'w' && are_numbers_from(below, 1, 3);
  return atom || sample.ending == ".xyz" ? Recognised::likely : Recognised::by_ending;
}

}  // namespace

FileFormat xyz_format() {
  return {"xyz", "XYZ", {".xyz"}, recognise_xyz, read_xyz};
}

FileFormat tinker_format() {
  return {"tinker", "Tinker XYZ", {}, recognise_tinker, read_tinker};
}

}  // namespace alphascope
