// SPDX-License-Identifier: GPL-3.0-or-later
// The PDB format, version 3.3, and the dialects of other programs. Columns are counted from 1, as
// in the format description. Coordinates come from the text itself, because gemmi's reader gives
// binary doubles without line numbers. It also refuses old files with an identifier in columns
// 73-80. Where a five-digit residue number shifts the columns right, it reads wrong numbers.
// AutoDock's PDBQT has charges and types behind the same columns.
#include <algorithm>
#include <limits>
#include <optional>
#include <unordered_map>
#include <unordered_set>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/read/frame_marks.hpp"
#include "core/read/molecule_builder.hpp"
#include "core/read/pdb/pdb_assembly.hpp"
#include "core/read/pdb/pdb_chain_columns.hpp"
#include "core/read/pdb/pdb_numbers.hpp"
#include "core/read/pdb/pdb_reader.hpp"
#include "core/read/pdb/pdb_records.hpp"
#include "core/read/predicted_model.hpp"
#include "core/read/residues/atom_names.hpp"
#include "core/read/residues/autodock_types.hpp"
#include "core/text/printable.hpp"
#include "core/text_files/line_reader.hpp"

namespace alphascope {
namespace {

constexpr std::size_t kProgressLines = 65536;
constexpr const char* kKeepColumns =
    "In a PDB file each value has its own columns; write the file again with a program that keeps "
    "to them, or as mmCIF";

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// A field of columns: blank, a number, or other text, as where it is cut wrongly from its
// neighbours.
enum class Field : std::uint8_t { blank, number, other };

Field read_field(std::string_view text, Decimal& value, DecimalStatus& status) {
  text = trimmed(text);
  if (text.empty()) return Field::blank;
  status = parse_decimal(text, value);
  return status == DecimalStatus::ok ? Field::number : Field::other;
}

float to_float(std::string_view text, float fallback) {
  text = trimmed(text);
  Decimal value;
  if (parse_decimal(text, value) != DecimalStatus::ok) return fallback;
  return static_cast<float>(value.to_double());
}

class PdbReader {
 public:
  PdbReader(const ReaderInput& input, bool pdbqt)
      : input_(input),
        lines_(input.text),
        builder_(input.source, pdbqt ? "PDBQT" : "PDB"),
        chain_columns_(input.text),
        pdbqt_(pdbqt) {
    builder_.reserve(input.text.size() / 81);
  }

  Molecule read() {
    std::string_view line;
    while (lines_.next(line)) {
      if (lines_.number() % kProgressLines == 0) input_.report(lines_.bytes_left());
      take(line);
    }
    Molecule& molecule = builder_.molecule();
    guesser_.add_note(molecule, pdbqt_ ? "because the column of types holds none"
                                       : "because columns 77-78 hold none");
    add_line_notes(molecule);
    if (shifted_lines_ > 0) {
      molecule.notes.push_back(
          "Lines read with their columns shifted right by a residue number of five or more "
          "digits: " +
          std::to_string(shifted_lines_));
    }
    assemblies_.finish(molecule);
    predicted_.finish(molecule);
    frames_.split(molecule);
    builder_.records().ter_count = sections_;
    return builder_.finish();
  }

 private:
  void take(std::string_view line) {
    const PdbLineKind kind = kind_of_pdb_line(line);
    if (kind.what == PdbLine::atom || kind.what == PdbLine::nearly_atom) {
      if (kind.what == PdbLine::nearly_atom) nearly_.add(lines_.number());
      take_atom(line.substr(kind.skip), kind.hetero);
    } else if (kind.what == PdbLine::like_atom) {
      unread_.add(lines_.number());
    } else if (line.starts_with("REMARK 350")) {
      assemblies_.take(line, lines_.number());
    } else if (line.starts_with("REMARK")) {
      predicted_.take_remark(line);
    } else if (line.starts_with("EXPDTA")) {
      predicted_.take_method(columns(line, 11, 79));
    } else if (line.starts_with("TITLE ")) {
      take_title(line);
    } else if (line.starts_with("MODRES")) {
      take_modified(line);
    } else if (line.starts_with("SEQRES")) {
      take_sequence(line);
    } else if (line.starts_with("LINK")) {
      builder_.records().bonds.take_link(line, chain_columns_);
    } else if (line.starts_with("SSBOND")) {
      builder_.records().bonds.take_disulphide(line, chain_columns_);
    } else if (line.starts_with("HELIX ")) {
      builder_.records().secondary.take_helix(line, lines_.number(), chain_columns_);
    } else if (line.starts_with("SHEET ")) {
      builder_.records().secondary.take_strand(line, lines_.number(), chain_columns_);
    } else if (line.starts_with("CONECT")) {
      builder_.records().bonds.take_conect(line);
    } else if (line.starts_with("ROOT")) {
      pose_ = true;
    } else {
      take_mark(line);
    }
  }

  void take_mark(std::string_view line) {
    const std::string_view mark = pdb_mark(line);
    if (mark == "MODEL") {
      std::int32_t number = ++model_count_;
      parse_pdb_integer(trimmed(line).substr(5), number);
      builder_.begin_model(number);
      between_models_ = false;
    } else if (mark == "ENDMDL") {
      between_models_ = true;
    } else if (mark == "END") {
      frames_.end_record(builder_.size());
    } else if (mark == "TER") {
      ++sections_;
      frames_.ter_record(builder_.size());
    }
  }

  void add_line_notes(Molecule& molecule) const {
    if (nearly_.count() > 0) {
      molecule.notes.push_back(
          "Lines read as atoms, although their ATOM or HETATM is not written as the format "
          "requires: " +
          nearly_.text());
    }
    if (unread_.count() > 0) {
      molecule.notes.push_back("Lines that look like atoms and are not read: " + unread_.text());
    }
    if (no_place_.count() > 0) {
      molecule.notes.push_back("Atoms left out because their place is not known (9999.000): " +
                               no_place_.text());
    }
    if (residue_numbers_.no_numbers().count() > 0) {
      molecule.notes.push_back(
          "Residue numbers that are not numbers, so residues are separated by repeated atom "
          "names: " +
          residue_numbers_.no_numbers().text());
    }
  }

  void take_title(std::string_view line) {
    std::string& title = builder_.molecule().title;
    std::string_view more = columns(line, 11, 80);
    while (!more.empty() && is_blank(more.back())) more.remove_suffix(1);
    if (title.empty()) more = trimmed(more);
    title += more;
  }

  // Takes a MODRES record of an amino acid or a nucleotide. Programs also note other renamings
  // here, such as SUL for the sulphate SO4.
  void take_modified(std::string_view line) {
    const std::string_view standard = trimmed(columns(line, 25, 27));
    if (!standard.empty() && residue_family(standard) != ResidueFamily::biopolymer) return;
    modified_.insert(
        residue_key(columns(line, 16, 17), columns(line, 19, 22), columns(line, 23, 23)));
  }

  void take_sequence(std::string_view line) {
    auto& names = builder_.records().sequences[std::string(trimmed(columns(line, 11, 12)))];
    std::string_view list = columns(line, 20, 70);
    for (std::string_view name = next_field(list); !name.empty(); name = next_field(list)) {
      names.emplace(name);
    }
  }

  static std::string residue_key(std::string_view chain, std::string_view number,
                                 std::string_view insertion_code) {
    return std::string(trimmed(chain)) + '/' + std::string(trimmed(number)) +
           std::string(trimmed(insertion_code));
  }

  void take_atom(std::string_view line, bool hetero) {
    std::array<Decimal, 3> position;
    const std::size_t shift = take_position(line, position);
    if (is_placeholder(position)) {
      no_place_.add(lines_.number());
      return;
    }
    if (between_models_) {
      builder_.begin_model(++model_count_);
      between_models_ = false;
    }
    model_count_ = std::max(model_count_, 1);
    Atom atom;
    atom.source_line = static_cast<std::uint32_t>(lines_.number());
    atom.hetero = hetero;
    // All fields behind the coordinates are optional.
    const std::string_view rest = line.size() > shift ? line.substr(shift) : std::string_view();
    take_names(line, rest, shift, atom);
    // A pose of AutoDock has energies in these columns.
    if (!pose_) {
      atom.occupancy = to_float(columns(rest, 55, 60), 1);
      take_b_factor(to_float(columns(rest, 61, 66), kNoNumber), atom);
    }
    if (!pdbqt_) atom.segment = segment(trimmed(columns(rest, 73, 76)));
    builder_.set_record({.section = sections_, .modified = is_modified_});
    builder_.add(atom, position);
  }

  // CNS and AMBER write these values for atoms without known coordinates.
  static bool is_placeholder(const std::array<Decimal, 3>& position) {
    return std::all_of(position.begin(), position.end(), [](const Decimal& c) {
      return (c.mantissa == 9999 && c.digits == 0) || (c.mantissa == 9999999 && c.digits == 3);
    });
  }

  // The number of a segment. A text with a point is ignored, because other programs write other
  // things there.
  std::uint16_t segment(std::string_view text) {
    if (text.empty() || text.find('.') != std::string_view::npos) return 0;
    if (text == last_segment_text_) return last_segment_;
    last_segment_text_ = text;
    const auto next = static_cast<std::uint16_t>(
        std::min<std::size_t>(segments_.size() + 1, std::numeric_limits<std::uint16_t>::max()));
    last_segment_ = segments_.try_emplace(std::string(text), next).first->second;
    return last_segment_;
  }

  // Returns by how many columns the coordinates are shifted to the right.
  std::size_t take_position(std::string_view line, std::array<Decimal, 3>& position) {
    if (try_position(line, position)) return 0;
    // Only a residue number that extends into column 27 explains a shift.
    if (line.size() > 27 && is_digit(line[25]) && is_digit(line[26])) {
      for (std::size_t shift = 1; shift <= 4 && line.size() > 54; ++shift) {
        if (try_position(line.substr(shift), position)) {
          ++shifted_lines_;
          return shift;
        }
      }
    }
    refuse_position(line);
  }

  // Also tests the occupancy. In a shifted line x, y and z can look like numbers, but the occupancy
  // is then cut apart.
  bool try_position(std::string_view line, std::array<Decimal, 3>& position) const {
    // In the last line of a file that was cut off, digits of z may be missing. In other lines, the
    // program that wrote the file left the end out.
    if (line.size() < 54 && lines_.cut()) return false;
    DecimalStatus status{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::string_view field = columns(line, 31 + 8 * k, 38 + 8 * k);
      if (read_field(field, position[k], status) != Field::number) return false;
    }
    const std::string_view occupancy = trimmed(columns(line, 55, 60));
    Decimal ignored;
    return occupancy.empty() || is_digit(line[26]) == false ||
           read_field(occupancy, ignored, status) != Field::other;
  }

  [[noreturn]] void refuse_position(std::string_view line) const {
    if (line.size() < 54 && lines_.cut()) {
      fail("the file ends within this atom", "It is truncated; fetch or copy it again");
    }
    for (std::size_t k = 0; k < 3; ++k) {
      Decimal value;
      DecimalStatus status{};
      const std::string_view field = columns(line, 31 + 8 * k, 38 + 8 * k);
      const Field what = read_field(field, value, status);
      if (what == Field::number) continue;
      const std::string name(1, "xyz"[k]);
      const std::string place =
          "columns " + std::to_string(31 + 8 * k) + "-" + std::to_string(38 + 8 * k);
      if (what == Field::blank) {
        fail(name + " is missing: " + place + " are empty",
             "The line may be truncated or not in PDB columns; fetch the file again");
      }
      fail("expected " + name + " in " + place + ", found \"" + shortened(field) + "\"",
           remedy_of_number(status, kKeepColumns));
    }
    fail("the occupancy in columns 55-60 is not a number: \"" + shortened(columns(line, 55, 60)) +
             "\", so the coordinates before it may be cut apart",
         kKeepColumns);
  }

  // rest: the line from `shift` on, so the fields behind the coordinates are in their columns.
  void take_names(std::string_view line, std::string_view rest, std::size_t shift, Atom& atom) {
    NameTable& names = builder_.molecule().names;
    // Columns 7-11. A number of six digits begins in column 6, one of seven in column 5.
    const std::size_t first = !is_digit(line[5]) || atom.hetero ? 7 : is_digit(line[4]) ? 5 : 6;
    atom.serial = parse_pdb_number(columns(line, first, 11), 12 - first);
    const std::string_view name = columns(line, 13, 16);
    atom.name = names.intern(trimmed(name));
    atom.altloc = column(line, 17);
    take_residue_and_chain(line, atom);
    const std::string_view number = columns(line, 23, 26 + shift);
    atom.residue_number = residue_numbers_.next(number, lines_.number());
    // A fifth digit of the residue number without a shift: it takes the place of a blank before x.
    if (shift == 0 && is_digit(column(line, 27)) && is_digit(column(line, 26))) {
      atom.residue_number = parse_pdb_number(columns(line, 23, 27), 5);
    } else {
      atom.insertion_code = column(line, 27 + shift);
    }
    const StatedElement stated = pdbqt_ ? autodock_element(autodock_type(rest))
                                        : stated_element(trimmed(columns(rest, 77, 78)));
    const ResidueFamily family = guesser_.identify(atom, stated, place(name, atom, stated), names);
    atom.kind = residue_kind(family, atom.hetero);
    is_modified_ = !modified_.empty() &&
                   modified_.contains(residue_key(names.text(atom.chain), number,
                                                  std::string_view(&atom.insertion_code, 1)));
  }

  // The first column of a name tells nothing where all names begin in column 13.
  NamePlace place(std::string_view name, const Atom& atom, const StatedElement& stated) {
    const NamePlace place = place_of(name);
    if (place != NamePlace::first_column || !atom.hetero ||
        stated.what == ElementStatement::element) {
      return place;
    }
    if (!name_columns_) name_columns_.emplace(input_.text);
    const std::string_view residue = builder_.molecule().text(atom.residue_name);
    return name_columns_->left_justified(residue) ? NamePlace::free : place;
  }

  // Columns 78-79, or the text behind the charge where the columns are shifted.
  static std::string_view autodock_type(std::string_view rest) {
    const std::string_view type = trimmed(columns(rest, 78, 80));
    if (!type.empty() && type.find(' ') == type.npos && is_blank(column(rest, 77))) return type;
    const std::string_view behind = trimmed(columns(rest, 67, rest.size()));
    const std::size_t blank = behind.find_last_of(" \t");
    return blank == behind.npos ? std::string_view() : behind.substr(blank + 1);
  }

  // Columns 18-20 and 22. Column 21 belongs to either.
  void take_residue_and_chain(std::string_view line, Atom& atom) {
    NameTable& names = builder_.molecule().names;
    const std::string_view chain = chain_columns_.chain_of(line);
    const std::string_view residue = trimmed(columns(line, 18, chain.size() == 2 ? 20 : 21));
    atom.residue_name = names.intern(residue);
    atom.chain = atom.label_chain = names.intern(chain);
  }

  static char column(std::string_view line, std::size_t number) {
    return line.size() >= number ? line[number - 1] : ' ';
  }

  [[noreturn]] void fail(std::string reason, std::string remedy) const {
    throw ReadError(input_.source, lines_.number(), std::move(reason), std::move(remedy));
  }

  const ReaderInput& input_;
  LineReader lines_;
  MoleculeBuilder builder_;
  AtomGuesser guesser_;
  PdbAssemblyRecords assemblies_;
  PdbChainColumns chain_columns_;
  PredictedModel predicted_;
  FrameMarks frames_;
  CountedLines nearly_, unread_, no_place_;
  PdbResidueNumbers residue_numbers_;
  std::unordered_set<std::string> modified_;  // residues in MODRES records
  std::unordered_map<std::string, std::uint16_t> segments_;
  std::string_view last_segment_text_;  // a view of the text
  std::uint16_t last_segment_ = 0;
  int model_count_ = 0;
  std::optional<PdbNameColumns> name_columns_;  // made when first needed
  bool pdbqt_, pose_ = false;
  std::uint32_t sections_ = 0;  // TER records so far
  bool is_modified_ = false;
  bool between_models_ = false;
  std::size_t shifted_lines_ = 0;
};

}  // namespace

Molecule read_pdb(const ReaderInput& input) {
  return PdbReader(input, false).read();
}

Molecule read_pdbqt(const ReaderInput& input) {
  return PdbReader(input, true).read();
}

}  // namespace alphascope
