// SPDX-License-Identifier: GPL-3.0-or-later
// PQR as PDB2PQR and APBS use it. ATOM and HETATM lines have fields between blanks:
//   serial name residue [chain] residue-number x y z charge radius [element]
// Where coordinates run into one another, the columns of the PDB format count. Charges are not
// used. Open Babel writes the element. Old files of ambpdb say in a remark that their radius comes
// first.
#include <charconv>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/read/file_format.hpp"
#include "core/read/frame_marks.hpp"
#include "core/read/molecule_builder.hpp"
#include "core/read/pdb/pdb_records.hpp"
#include "core/read/residues/atom_names.hpp"
#include "core/text/printable.hpp"
#include "core/text_files/line_reader.hpp"

namespace alphascope {
namespace {

constexpr std::size_t kProgressLines = 65536;
constexpr std::size_t kMostFields = 12;

bool is_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

class PqrReader {
 public:
  explicit PqrReader(const ReaderInput& input)
      : input_(input), lines_(input.text), builder_(input.source, "PQR") {}

  Molecule read() {
    refuse_pdb();
    std::string_view line;
    while (lines_.next(line)) {
      if (lines_.number() % kProgressLines == 0) input_.report(lines_.bytes_left());
      if (line.starts_with("ATOM") || line.starts_with("HETATM")) {
        if (between_models_) builder_.begin_model(++models_);
        between_models_ = false;
        models_ = std::max(models_, 1);
        take_atom(line);
      } else if (line.starts_with("MODEL")) {
        builder_.begin_model(++models_);
        between_models_ = false;
      } else if (line.starts_with("ENDMDL")) {
        between_models_ = true;
      } else if (line.starts_with("REMARK") && line.find("radii in columns 55-62") != line.npos) {
        radius_first_ = true;
      } else if (pdb_mark(line) == "END") {
        frames_.end_record(builder_.size());
      } else if (pdb_mark(line) == "TER") {
        ++sections_;
        frames_.ter_record(builder_.size());
      }
    }
    builder_.records().ter_count = sections_;
    guesser_.add_note(builder_.molecule(), "because PQR files hold none");
    if (radius_first_) {
      builder_.molecule().notes.push_back(
          "Radii are read from the column before the charges, because a remark in the file says "
          "so");
    }
    frames_.split(builder_.molecule());
    return builder_.finish();
  }

 private:
  void take_atom(std::string_view line) {
    line_ = line;
    const std::size_t tag = line[0] == 'H' ? 6 : 4;
    Atom atom;
    atom.hetero = tag == 6;
    atom.source_line = static_cast<std::uint32_t>(lines_.number());
    std::array<Decimal, 3> position;
    Decimal radius;
    element_ = {};
    if (!take_fields(line.substr(tag), atom, position, radius)) {
      take_columns(line, tag, atom, position, radius);
    }
    if (radius.mantissa < 0) fail("the radius is negative", "Radii are in Å and at least 0");
    const ResidueFamily family = guesser_.identify(atom, stated_element(element_), NamePlace::free,
                                                   builder_.molecule().names);
    atom.kind = residue_kind(family, atom.hetero);
    builder_.set_record({.section = sections_});
    builder_.add(atom, position, radius);
  }

  // Reads the fields between blanks. False when some numbers run into one another.
  bool take_fields(std::string_view rest, Atom& atom, std::array<Decimal, 3>& position,
                   Decimal& radius) {
    std::size_t n = 0;
    for (; n < kMostFields; ++n) {
      fields_[n] = next_field(rest);
      if (fields_[n].empty()) break;
    }
    // After ten or eleven fields the last one may be the element.
    if (n >= 10 && is_element(fields_[n - 1])) element_ = fields_[--n];
    if (n < 9 || n > 10) return false;
    for (std::size_t k = 0; k < 5; ++k) {
      Decimal charge;
      Decimal& value = k < 3 ? position[k] : (k == 3) != radius_first_ ? charge : radius;
      if (parse_decimal(fields_[n - 5 + k], value) != DecimalStatus::ok) return false;
    }
    name_atom(atom, fields_[0], fields_[1], fields_[2], n == 10 ? fields_[3] : std::string_view(),
              fields_[n - 6]);
    return true;
  }

  void take_columns(std::string_view line, std::size_t tag, Atom& atom,
                    std::array<Decimal, 3>& position, Decimal& radius) {
    const auto columns = [&](std::size_t first, std::size_t last) {
      return line.size() < first ? std::string_view() : line.substr(first - 1, last - first + 1);
    };
    for (std::size_t k = 0; k < 3; ++k) {
      position[k] = number(trimmed(columns(31 + 8 * k, 38 + 8 * k)), "xyz"[k]);
    }
    std::string_view rest = columns(55, line.size());
    const Decimal charge = number(next_field(rest), radius_first_ ? 'r' : 'q');
    radius = number(next_field(rest), radius_first_ ? 'q' : 'r');
    if (radius_first_) radius = charge;
    if (is_element(trimmed(rest))) {
      element_ = trimmed(rest);
    } else if (!trimmed(rest).empty()) {
      fail_shape();
    }
    std::string_view front = columns(tag + 1, 30);
    std::size_t n = 0;
    for (; n < kMostFields; ++n) {
      fields_[n] = next_field(front);
      if (fields_[n].empty()) break;
    }
    if (n < 4 || n > 5) fail_shape();
    name_atom(atom, fields_[0], fields_[1], fields_[2], n == 5 ? fields_[3] : std::string_view(),
              fields_[n - 1]);
  }

  static bool is_element(std::string_view text) {
    return stated_element(text).what == ElementStatement::element;
  }

  // Refuses a PDB file, whose occupancies and B factors would pass for charges and radii. Each has
  // two decimals in the columns of the PDB format. One is too large for a radius, or elements
  // follow.
  void refuse_pdb() const {
    constexpr double kLargestRadius = 4;  // Å
    LineReader lines(input_.text);
    std::string_view line;
    bool too_large = false;
    std::size_t first = 0;
    while (lines.next(line)) {
      if (!line.starts_with("ATOM") && !line.starts_with("HETATM")) continue;
      if (first == 0) first = lines.number();
      Decimal occupancy, b_factor;
      const std::string_view q = columns(line, 55, 60), r = columns(line, 61, 66);
      const bool as_printed = q.size() == 6 && r.size() == 6 && q[3] == '.' && r[3] == '.';
      if (!as_printed || parse_decimal(trimmed(q), occupancy) != DecimalStatus::ok ||
          parse_decimal(trimmed(r), b_factor) != DecimalStatus::ok) {
        return;
      }
      if (occupancy.to_double() < 0 || occupancy.to_double() > 1) return;
      const bool element = is_element(trimmed(columns(line, 77, 78)));
      too_large = too_large || element || b_factor.to_double() > kLargestRadius;
    }
    if (!too_large) return;
    throw ReadError(input_.source, first,
                    "this is a PDB file: columns 55-66 hold occupancies and B factors, and no "
                    "charges and radii",
                    "A PDB file should be named .pdb");
  }

  void name_atom(Atom& atom, std::string_view serial, std::string_view name,
                 std::string_view residue, std::string_view chain, std::string_view number) {
    NameTable& names = builder_.molecule().names;
    std::from_chars(serial.data(), serial.data() + serial.size(), atom.serial);
    atom.name = names.intern(name);
    atom.residue_name = names.intern(residue);
    // "A1001": the chain has run into a long number.
    if (chain.empty() && number.size() > 1 && is_letter(number.front())) {
      chain = number.substr(0, 1);
      number.remove_prefix(1);
    }
    atom.chain = atom.label_chain = names.intern(chain);
    const auto [end, error] =
        std::from_chars(number.data(), number.data() + number.size(), atom.residue_number);
    const std::size_t used = static_cast<std::size_t>(end - number.data());
    if (error != std::errc() || number.size() - used > 1) {
      fail("expected a residue number, found \"" + shortened(number) + "\"", kRemedy);
    }
    if (used < number.size()) atom.insertion_code = number[used];
  }

  Decimal number(std::string_view text, char what) const {
    Decimal value;
    const DecimalStatus status = parse_decimal(text, value);
    if (status == DecimalStatus::ok) return value;
    const std::string name = what == 'q'   ? "the charge"
                             : what == 'r' ? "the radius"
                                           : std::string(1, what);
    if (text.empty()) fail(name + " is missing", kRemedy);
    fail("expected a number for " + name + ", found \"" + shortened(text) + "\"",
         status == DecimalStatus::not_finite
             ? "Coordinates and radii must be finite; remove this atom or compute it again"
             : kRemedy);
  }

  [[noreturn]] void fail_shape() const {
    fail("this is not a PQR atom: \"" + shortened(line_) + "\"", kRemedy);
  }

  [[noreturn]] void fail(std::string reason, std::string remedy) const {
    throw ReadError(input_.source, lines_.number(), std::move(reason), std::move(remedy));
  }

  static constexpr const char* kRemedy =
      "PQR lines are \"ATOM serial name residue [chain] number x y z charge radius\"; a PDB file "
      "should be named .pdb";

  const ReaderInput& input_;
  LineReader lines_;
  MoleculeBuilder builder_;
  AtomGuesser guesser_;
  std::array<std::string_view, kMostFields> fields_;
  FrameMarks frames_;
  std::string_view line_, element_;
  int models_ = 0;
  std::uint32_t sections_ = 0;  // TER records so far
  bool between_models_ = false, radius_first_ = false;
};

Molecule read_pqr(const ReaderInput& input) {
  return PqrReader(input).read();
}

Recognised recognise_pqr(const FileSample& sample) {
  return begins_as_pqr(sample) ? Recognised::certain : Recognised::by_ending;
}

}  // namespace

FileFormat pqr_format() {
  return {"pqr", "PQR", {".pqr"}, recognise_pqr, read_pqr};
}

}  // namespace alphascope
