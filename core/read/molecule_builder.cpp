// SPDX-License-Identifier: GPL-3.0-or-later
// Puts collected atoms on a decimal lattice and finishes the molecule.
#include "core/read/molecule_builder.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/read/residues/decide_residues.hpp"
#include "core/read/residues/stated_bonds.hpp"
#include "core/read/residues/virtual_sites.hpp"
#include "core/text/printable.hpp"

namespace alphascope {
namespace {

constexpr Decimal kNoRadius{-1, 0};

std::string text_of(const Decimal& value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.10g", value.to_double());
  return text;
}

}  // namespace

MoleculeBuilder::MoleculeBuilder(std::filesystem::path source, std::string format) {
  molecule_.source = std::move(source);
  molecule_.format = std::move(format);
}

void MoleculeBuilder::reserve(std::size_t atoms) {
  molecule_.atoms.reserve(atoms);
  positions_.reserve(atoms);
}

void MoleculeBuilder::begin_model(int number) {
  std::vector<ModelRange>& models = molecule_.models;
  // Atoms before the first model form a model of their own.
  if (models.empty() && size() > 0) models.push_back({1, 0, size()});
  if (!models.empty()) {
    models.back().end = size();
    if (models.back().size() == 0) models.pop_back();
  }
  models.push_back({number, size(), size()});
}

void MoleculeBuilder::add(const Atom& atom, const std::array<Decimal, 3>& position,
                          const Decimal& radius) {
  radii_.resize(size(), kNoRadius);
  add(atom, position);
  radii_.push_back(radius);
  note_coordinate(radius);
  molecule_.has_file_radii |= radius.mantissa > 0;
}

Molecule MoleculeBuilder::finish() {
  if (molecule_.atoms.empty()) {
    throw ReadError(molecule_.source, 0, "the " + molecule_.format + " file holds no atoms",
                    "Check that it is complete and that it is the coordinate file");
  }
  if (molecule_.models.empty()) molecule_.models.push_back({1, 0, 0});
  molecule_.models.back().end = size();
  if (molecule_.models.back().size() == 0) molecule_.models.pop_back();
  if (!radii_.empty() && !molecule_.has_file_radii) {
    molecule_.notes.push_back("Every radius in the file is 0, so a radii set is used instead");
  }
  if (!radii_.empty()) radii_.resize(size(), kNoRadius);
  place(choose_digits());
  mark_sites_at_atoms(molecule_);
  if (has_residues_) decide_residues(molecule_, records_);
  finish_virtual_sites(molecule_);
  state_bonds(molecule_, records_.bonds);
  records_.secondary.state(molecule_);
  make_texts_printable();
  return std::move(molecule_);
}

// Names are printable already.
void MoleculeBuilder::make_texts_printable() {
  molecule_.title = printable(molecule_.title);
  for (std::string& note : molecule_.notes) note = printable(note);
  for (Assembly& assembly : molecule_.assemblies.list) {
    assembly.id = printable(assembly.id);
    assembly.details = printable(assembly.details);
  }
  for (RefusedAssembly& refused : molecule_.assemblies.refused) {
    refused.id = printable(refused.id);
    refused.reason = printable(refused.reason);
  }
}

int MoleculeBuilder::choose_digits() const {
  double largest_coordinate = 0, largest_radius = 0;
  for (const auto& position : positions_) {
    for (const Decimal& c : position) {
      // Most values have few decimals, so the division is rare.
      largest_coordinate = std::max(largest_coordinate, std::abs(c.to_double()));
    }
  }
  for (const Decimal& r : radii_) largest_radius = std::max(largest_radius, r.to_double());
  int digits = most_digits_;
  const auto fits = [&](int d) {
    const double units = Lattice{d}.units_per_angstrom();
    return largest_coordinate * units <= kMaxLatticeCoordinate &&
           largest_radius * units <= kMaxLatticeRadius;
  };
  digits = std::min(digits, kMaxLatticeDigits);
  while (digits > 0 && !fits(digits)) --digits;
  return digits;
}

void MoleculeBuilder::place(int digits) {
  double largest_rounding = 0;  // lattice units
  for (std::size_t i = 0; i < size(); ++i) {
    std::int32_t* const out[3] = {&molecule_.atoms[i].position.x, &molecule_.atoms[i].position.y,
                                  &molecule_.atoms[i].position.z};
    for (int k = 0; k < 3; ++k) {
      double rounding;
      const std::int64_t units = to_units(positions_[i][k], digits, rounding);
      if (std::llabs(units) > kMaxLatticeCoordinate) {
        refuse_value(i, "coordinate", positions_[i][k]);
      }
      *out[k] = static_cast<std::int32_t>(units);
      largest_rounding = std::max(largest_rounding, rounding);
    }
    if (radii_.empty() || radii_[i].mantissa < 0) continue;
    double rounding;
    const std::int64_t units = to_units(radii_[i], digits, rounding);
    if (units > kMaxLatticeRadius) refuse_value(i, "radius", radii_[i]);
    if (units == 0 && radii_[i].mantissa > 0) refuse_value(i, "radius", radii_[i]);
    molecule_.atoms[i].file_radius = static_cast<std::int32_t>(units);
    largest_rounding = std::max(largest_rounding, rounding);
  }
  molecule_.lattice = Lattice{digits};
  molecule_.rounding_angstrom = molecule_.lattice.angstrom(largest_rounding);
  if (largest_rounding > 0) {
    char note[160];
    std::snprintf(note, sizeof note,
                  "Numbers have more digits than the lattice of %g Å can hold; they are rounded "
                  "once, by at most %.2g Å",
                  molecule_.lattice.unit_angstrom(), molecule_.rounding_angstrom);
    molecule_.notes.push_back(note);
  }
}

void MoleculeBuilder::refuse_value(std::size_t atom, const char* what, const Decimal& value) const {
  const bool small = std::abs(value.to_double()) < 1;
  throw ReadError(
      molecule_.source, molecule_.atoms[atom].source_line,
      std::string("the ") + what + " " + text_of(value) + " Å is too " +
          (small ? "small beside the largest values of this file" : "large for a molecule"),
      "Coordinates up to 536,000,000 Å and radii up to 67,000,000 Å can be read; check the units "
      "and the columns of this line");
}

}  // namespace alphascope
