// From atoms to balls: which atoms of a molecule are used, with which radii, and an honest account
// of everything that was left out or guessed.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/geometry/ball_set.hpp"
#include "core/molecule/molecule.hpp"
#include "core/radii/radii_set.hpp"
#include "core/run/cancel_token.hpp"
#include "core/selection/ball_options.hpp"

namespace alphascope {

// A radius that the set did not have.
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
  std::string atoms;  // names of some: "CA, CB, CG, …"; empty where the file has none
};

// Each atom left out is counted once, under the first of the reasons that applies.
struct SelectionReport {
  std::size_t total = 0;  // atoms of the chosen model
  std::size_t used = 0;
  std::size_t dropped_chains = 0;
  std::size_t dropped_selection = 0;  // not picked by the selection expression
  std::size_t dropped_dummies = 0;
  std::size_t dropped_waters = 0;           // atoms of waters
  std::size_t dropped_water_hydrogens = 0;  // of them
  std::size_t dropped_ions = 0;
  std::size_t dropped_ligands = 0;
  std::size_t dropped_polymers = 0;
  std::size_t dropped_hydrogens = 0;
  std::size_t dropped_altlocs = 0;
  std::size_t dropped_zero_radius = 0;     // the file says 0: no ball, by its own account
  std::size_t dropped_without_radius = 0;  // the file's own radii are asked for; none here
  std::vector<DroppedAtoms> dropped;  // the same, by residue name: reasons in order, most first

  RadiiSet radii = RadiiSet::bondi;  // never automatic
  std::string radii_name;
  std::string radii_citation;
  std::vector<GuessedRadius> guessed;  // in order of first appearance
  std::size_t guessed_atoms = 0;
  std::vector<GuessedRadius> overridden;  // by BallOptions::overrides
  std::size_t overridden_atoms = 0;
  std::vector<GuessedRadius> unsized;   // dropped for the lack of a radius; theirs is 0 here
  std::vector<BallSize> sizes;          // of the balls, most frequent first
  std::size_t rounded_radii = 0;        // of sets, tables and edits, where no lattice holds them
  double radius_rounding_angstrom = 0;  // the largest change
  Lattice lattice;                      // of the balls: the file's, or a finer one for such radii

  // Residues of the chains and the selection that were guessed to be polymer or ligand.
  std::size_t guessed_residues = 0;

  // Balls whose centre is exactly that of an earlier ball. They stay in the set; of balls with one
  // centre only the largest shows.
  std::size_t coincident_centres = 0;
};

// An atom that is there, though not in the body: to be drawn, or to ask which cavity it is in.
struct LeftOutAtom {
  std::uint32_t atom = 0;                    // index into Molecule::atoms, which has its position
  DropReason reason = DropReason::hydrogen;  // or water (with its hydrogens), ion, ligand
  friend bool operator==(const LeftOutAtom&, const LeftOutAtom&) = default;
};

struct PreparedBalls {
  std::shared_ptr<const BallSet> balls;
  std::vector<std::uint32_t> atom_of_ball;  // index into Molecule::atoms
  // Ascending. Of alternative locations only the chosen ones; no atoms of other models, of chains
  // left out or beside the selection, and none without a radius by the file's own account.
  std::vector<LeftOutAtom> left_out;
  SelectionReport report;
};

// Balls come in the order of their atoms. Throws std::invalid_argument for a model that is not
// there, for radii from a file without any, for RadiiSet::user without a table, and for more atoms
// than an index can count; Cancelled. No atom left is no error: the set is empty and the report
// says why.
PreparedBalls prepare_balls(const Molecule& molecule, const BallOptions& options = {},
                            const RunContext& context = {});

// "used 2,104 of 2,431 atoms; dropped 201 waters, 88 alternative locations; radii Bondi; 2 guessed"
std::string summary(const SelectionReport& report);

struct CountedReason {
  DropReason reason;
  std::size_t count = 0;
  std::string text;  // "201 waters"
};
// The reasons for which something was dropped, in the order in which they apply.
std::vector<CountedReason> drop_reasons(const SelectionReport& report);

}  // namespace alphascope
