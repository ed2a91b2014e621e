// Collects the atoms that a reader meets, with exact decimal coordinates, and puts them on the
// coarsest decimal lattice that holds all of them.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/files/read_error.hpp"
#include "core/molecule/molecule.hpp"
#include "core/read/decimal.hpp"
#include "core/read/residues/residue_records.hpp"

namespace alphascope {

// What a reader gives for a number that the file leaves out.
inline constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();

// Å², or kNoNumber.
inline void take_b_factor(float b_factor, Atom& atom) {
  atom.has_b_factor = !std::isnan(b_factor);
  if (atom.has_b_factor) atom.b_factor = b_factor;
}

class MoleculeBuilder {
 public:
  MoleculeBuilder(std::filesystem::path source, std::string format);

  // Names are interned here by the reader; title and notes are set directly.
  Molecule& molecule() { return molecule_; }

  void reserve(std::size_t atoms);

  // The next atom goes to a new model. A model without atoms is dropped.
  void begin_model(int number);

  void add(const Atom& atom, const std::array<Decimal, 3>& position) {
    molecule_.atoms.push_back(atom);
    make_visible(molecule_.atoms.back().altloc);
    make_visible(molecule_.atoms.back().insertion_code);
    for (const Decimal& c : position) note_coordinate(c);
    positions_.push_back(position);
  }
  // radius >= 0 (Å).
  void add(const Atom& atom, const std::array<Decimal, 3>& position, const Decimal& radius);

  std::size_t size() const { return molecule_.atoms.size(); }

  // For formats that know residues: what records say of the next atoms, and what finish() judges
  // them by. Without any the kinds stay as the reader gives them.
  void set_record(const ResidueRecord& record) {
    has_residues_ = true;
    records_.add(size(), record);
  }
  ResidueRecords& records() {
    has_residues_ = true;
    return records_;
  }

  // Lattice digits: as many as some value of the file uses (trailing zeros do not count), at least
  // kMinLatticeDigits, at most what the largest coordinate and radius leave room for; with fewer
  // than the file uses, values are rounded once and the largest change is recorded.
  // Title, notes and assemblies become printable. What residues are is decided.
  // Throws ReadError when there are no atoms or a value is beyond the lattice of whole ångströms.
  Molecule finish();

 private:
  static void make_visible(char& letter) {
    if (letter < ' ' || letter > '~') letter = '?';
  }
  void make_texts_printable();
  void note_coordinate(const Decimal& value) {
    if (value.digits > most_digits_) most_digits_ = value.digits;
  }
  int choose_digits() const;
  void place(int digits);
  [[noreturn]] void refuse_value(std::size_t atom, const char* what, const Decimal& value) const;

  Molecule molecule_;
  std::vector<std::array<Decimal, 3>> positions_;
  std::vector<Decimal> radii_;  // empty, or one per atom; mantissa -1 for an atom without
  ResidueRecords records_;
  bool has_residues_ = false;
  int most_digits_ = kMinLatticeDigits;
};

}  // namespace alphascope
