// One function per file format: text in, molecule out. Loading and telling formats apart is done by
// read_molecule.cpp; nothing here touches the disk.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

#include "core/molecule/molecule.hpp"
#include "core/read/sniff_format.hpp"
#include "core/run/cancel_token.hpp"

namespace alphascope {

struct ReaderInput {
  std::filesystem::path source;  // for messages and Molecule::source only
  std::string_view text;
  RunContext context;

  // To be called now and then while reading: reports the share done, and throws Cancelled.
  void report(std::size_t bytes_left) const {
    context.cancel.throw_if_cancelled();
    context.report("reading",
                   1 - static_cast<double>(bytes_left) / static_cast<double>(text.size()));
  }
};

// All of them throw ReadError with the line at fault, and Cancelled.

// By the format's own reader. For FileFormat::unknown, and for a text of blanks, the error says
// what the text looks like.
Molecule read_format(FileFormat format, const ReaderInput& input);

// ATOM and HETATM records of all models. Atoms between two models, or after the last ENDMDL, form a
// model of their own.
Molecule read_pdb(const ReaderInput& input);

// PDBQT of AutoDock and Vina: the same records with AutoDock's types; poses are models.
Molecule read_pdbqt(const ReaderInput& input);

// The atom_site table of the first data block that has one.
Molecule read_mmcif(const ReaderInput& input);

// PQR: atoms with charge and radius.
Molecule read_pqr(const ReaderInput& input);

// XYZ and extended XYZ; frames become models.
Molecule read_xyz(const ReaderInput& input);
Molecule read_tinker_xyz(const ReaderInput& input);

// CHARMM's coordinate cards, narrow and wide.
Molecule read_charmm_card(const ReaderInput& input);

// "x y z r" lines: XYZR, both dialects of the x-y-z-r CRD (with the count in the first line, or
// without), and tables with labels before or after the four numbers.
Molecule read_ball_table(const ReaderInput& input);

}  // namespace alphascope
