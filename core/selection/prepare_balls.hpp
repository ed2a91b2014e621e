// SPDX-License-Identifier: GPL-3.0-or-later
// The way from atoms to balls: which atoms are used, and with which radii. A report lists all that
// was left out or guessed.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/geometry/lattice.hpp"
#include "core/run/cancel_token.hpp"
#include "core/selection/ball_options.hpp"
#include "core/selection/drop_reason.hpp"

namespace alphascope {

struct BallSet;
struct ModelRange;
struct Molecule;

// Atoms of one kind with a radius that the set did not have.
struct GuessedRadius {
  std::string atoms;  // "FE in HEM"
  std::size_t count = 0;
  double radius_angstrom = 0;
  std::string source = {};  // "ionic radius, Shannon 1976"
  AtomGroup group = {};
};

// Atoms of one residue name left out for one reason.
struct DroppedAtoms {
  DropReason reason;
  std::string residue;
  std::size_t count = 0;
};

// Balls of one element and radius (lattice units, before any solvent).
struct BallSize {
  Element element = kUnknownElement;
  std::int32_t radius = 0;
  std::size_t count = 0;
  std::string atoms;  // some names: "CA, CB, CG, …"; empty: the file has none
};

// Each dropped atom is counted once, under the first reason that applies.
struct SelectionReport {
  std::size_t total = 0;  // atoms of the chosen model
  std::size_t used = 0;
  std::size_t dropped_chains = 0;
  std::size_t dropped_selection = 0;  // not part of the selection expression
  std::size_t dropped_dummies = 0;
  std::size_t dropped_waters = 0;           // atoms of waters
  std::size_t dropped_water_hydrogens = 0;  // those of them that are hydrogens
  std::size_t dropped_ions = 0;
  std::size_t dropped_ligands = 0;
  std::size_t dropped_polymers = 0;
  std::size_t dropped_hydrogens = 0;
  std::size_t dropped_altlocs = 0;
  std::size_t dropped_zero_radius = 0;  // the file gives the radius 0
  // The file's radii are used, and it gives none for the atom.
  std::size_t dropped_without_radius = 0;
  // The same numbers by residue name: reasons in order, largest number first
  std::vector<DroppedAtoms> dropped;

  RadiiSet radii = RadiiSet::bondi;  // never automatic
  std::string radii_name;
  std::string radii_citation;
  std::vector<GuessedRadius> guessed;  // in order of first appearance
  std::size_t guessed_atoms = 0;
  std::vector<GuessedRadius> overridden;  // by BallOptions::overrides
  std::size_t overridden_atoms = 0;
  std::vector<GuessedRadius> unsized;  // atoms dropped for lack of a radius; their radius here is 0
  std::vector<BallSize> sizes;         // of the balls, most frequent first
  std::size_t rounded_radii = 0;  // radii of sets, tables and edits that the lattice does not hold
  double radius_rounding_angstrom = 0;  // largest change, Å
  Lattice lattice;  // of the balls: the file's, or a finer one that holds such radii

  // Residues of the selected chains and atoms whose kind (polymer or ligand) was guessed.
  std::size_t guessed_residues = 0;

  // Balls with exactly the same centre as an earlier ball. They stay in the set. Among balls with
  // one centre only the largest is a vertex, and the others are hidden.
  std::size_t coincident_centres = 0;
};

// An atom that is present but no ball. It can be drawn, or looked up in a cavity.
struct LeftOutAtom {
  std::uint32_t atom = 0;                    // index into Molecule::atoms
  DropReason reason = DropReason::hydrogen;  // hydrogen, water (with its hydrogens), ion or ligand
  friend bool operator==(const LeftOutAtom&, const LeftOutAtom&) = default;
};

struct PreparedBalls {
  std::shared_ptr<const BallSet> balls;
  std::vector<std::uint32_t> atom_of_ball;  // index into Molecule::atoms
  // Ascending. Only chosen alternative locations are listed. Atoms of other models, of dropped
  // chains or outside the selection are not listed. Neither are atoms to which the file gives no
  // radius.
  std::vector<LeftOutAtom> left_out;
  SelectionReport report;
};

// Makes the balls, in the order of their atoms. Throws std::invalid_argument in four cases: a
// missing model; file radii of a file without any; RadiiSet::user without a table; more atoms than
// an index can count. Throws Cancelled. An empty result is no error; the report says why it is
// empty.
PreparedBalls prepare_balls(const Molecule& molecule, const BallOptions& options = {},
                            const RunContext& context = {});

// The atoms of the model whose atoms are balls, or of all models from the first such one to the
// last; of the first model if there are no balls.
ModelRange models_of_balls(const Molecule& molecule, const PreparedBalls& prepared);

// One line: "used 2,104 of 2,431 atoms; dropped 201 waters, 88 alternative locations; radii Bondi;
// 2 guessed".
std::string summary(const SelectionReport& report);

struct CountedReason {
  DropReason reason;
  std::size_t count = 0;
  std::string text;  // "201 waters"
};
// The reasons for which atoms were dropped, in the order in which they apply.
std::vector<CountedReason> drop_reasons(const SelectionReport& report);

}  // namespace alphascope
