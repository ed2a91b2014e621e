// SPDX-License-Identifier: GPL-3.0-or-later
// Collects the atoms that a reader finds, with exact decimal coordinates. Puts them on the coarsest
// decimal lattice that holds all of them.
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

// The value for a number that the file leaves out.
inline constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();

// Å², or kNoNumber.
inline void take_b_factor(float b_factor, Atom& atom) {
  atom.has_b_factor = !std::isnan(b_factor);
  if (atom.has_b_factor) atom.b_factor = b_factor;
}

class MoleculeBuilder {
 public:
  MoleculeBuilder(std::filesystem::path source, std::string format);

  // The reader interns names here, and sets title and notes directly.
  Molecule& molecule() { return molecule_; }

  void reserve(std::size_t atoms);

  // The next atom starts a new model. Models without atoms are dropped.
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

  // For formats with residues. Sets the records of the next atoms; finish() decides residues by
  // them. Without any record, the kinds stay as the reader gave them.
  void set_record(const ResidueRecord& record) {
    has_residues_ = true;
    records_.add(size(), record);
  }
  ResidueRecords& records() {
    has_residues_ = true;
    return records_;
  }

  // Chooses the lattice digits: as many as some value of the file uses, without trailing zeros.
  // They are at least kMinLatticeDigits, and at most what the largest coordinate and radius allow.
  // With fewer digits than the file uses, values are rounded once and the largest change is
  // recorded.
  // Makes title, notes and assemblies printable, and decides residues.
  // Throws ReadError when there are no atoms, or when a value exceeds the lattice of whole
  // ångströms.
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
  std::vector<Decimal> radii_;  // empty, or one per atom; mantissa -1: the atom has no radius
  ResidueRecords records_;
  bool has_residues_ = false;
  int most_digits_ = kMinLatticeDigits;
};

}  // namespace alphascope
