// SPDX-License-Identifier: GPL-3.0-or-later
// GRO, the coordinates of GROMACS: a title, the number of atoms, a line for each atom, the box.
// Further frames follow in the same way and become models. Columns are fixed:
//   residue number (5) residue name (5) atom name (5) atom number (5) x y z [velocities]
// Positions are in nm. The distance of their decimal points is the width of a column.
#include <algorithm>
#include <array>
#include <optional>

#include "core/geometry/alpha.hpp"
#include "core/read/field_kinds.hpp"
#include "core/read/file_format.hpp"
#include "core/read/molecule_builder.hpp"
#include "core/read/residues/atom_names.hpp"
#include "core/text/printable.hpp"
#include "core/text_files/line_reader.hpp"

namespace alphascope {
namespace {

constexpr std::size_t kProgressAtoms = 65536;
constexpr std::size_t kPositions = 20;   // columns before x
constexpr std::size_t kPointColumn = 4;  // of a position, as %8.3f and %10.5f write it
constexpr std::size_t kLeastWidth = 6, kMostWidth = 40;
constexpr std::size_t kShortestAtom = kPositions + 3 * kLeastWidth;

// The width of a position in columns. Nothing where no three decimal points are equally far apart.
std::optional<std::size_t> width_of_positions(std::string_view line) {
  const std::size_t first = line.find('.', kPositions);
  if (first == line.npos) return std::nullopt;
  const std::size_t second = line.find('.', first + 1);
  if (second == line.npos || line.find('.', second + 1) != 2 * second - first) return std::nullopt;
  const std::size_t width = second - first;
  return width < kLeastWidth || width > kMostWidth ? std::nullopt : std::optional(width);
}

std::string_view field_at(std::string_view line, std::size_t first, std::size_t width) {
  return line.size() <= first ? std::string_view() : line.substr(first, width);
}

// True for three numbers or nine. From 10,000 nm on, the numbers of %10.5f touch: then their
// decimal points are counted. The line of an atom has letters.
bool is_box(std::string_view line) {
  const auto is_count_of_box = [](std::ptrdiff_t count) { return count == 3 || count == 9; };
  std::ptrdiff_t fields = 0;
  bool numbers = true;
  std::string_view rest = line;
  for (std::string_view f = next_field(rest); !f.empty(); f = next_field(rest), ++fields) {
    Decimal value;
    numbers &= parse_decimal(f, value) == DecimalStatus::ok;
  }
  if (numbers && is_count_of_box(fields)) return true;
  return line.find_first_not_of("0123456789.- \t\r") == line.npos &&
         is_count_of_box(std::count(line.begin(), line.end(), '.'));
}

// Shifts the decimal point by one place, so the value stays exact.
Decimal angstrom_of_nanometres(Decimal value) {
  if (value.mantissa != 0) --value.digits;
  return value;
}

class GroReader {
 public:
  explicit GroReader(const ReaderInput& input)
      : input_(input), lines_(input.text), builder_(input.source, "GRO") {}

  Molecule read() {
    for (int frame = 1; !is_at_end(); ++frame) {
      std::string_view line;
      lines_.next(line);
      if (frame == 1) builder_.molecule().title = std::string(trimmed(line));
      read_count();
      builder_.begin_model(frame);
      width_.reset();
      for (std::size_t k = 0; k < count_; ++k) read_atom(k);
      read_box();
    }
    guesser_.add_note(builder_.molecule(), "because GRO files hold none");
    return builder_.finish();
  }

 private:
  // Titles may be blank. So a blank line ends the file only where nothing else follows.
  bool is_at_end() const {
    const std::string_view rest = input_.text.substr(input_.text.size() - lines_.bytes_left());
    return rest.find_first_not_of(" \t\r\n\v\f") == rest.npos;
  }

  void read_count() {
    std::string_view line;
    const bool there = lines_.next(line);
    count_line_ = lines_.number();
    if (!there || !parse_whole(trimmed(line), count_)) {
      fail("expected the number of atoms, found \"" + shortened(trimmed(line)) + "\"",
           builder_.size() == 0
               ? "A GRO file begins with a title and, in the second line, the number of its atoms"
               : "The file is truncated, or the count of the frame before is too small");
    }
    // A wrong count cannot reserve much memory.
    if (builder_.size() == 0)
      builder_.reserve(std::min(count_, lines_.bytes_left() / kShortestAtom));
  }

  void read_atom(std::size_t k) {
    if (builder_.size() % kProgressAtoms == 0) input_.report(lines_.bytes_left());
    std::string_view line;
    if (!lines_.next(line) || trimmed(line).empty()) {
      fail("the atoms end after " + std::to_string(k) + " of the " + std::to_string(count_) +
               " that line " + std::to_string(count_line_) + " announces",
           "The file is truncated or the count is wrong; fetch it again or correct the count");
    }
    if (!width_) width_ = width_of_positions(line);
    if (!width_) {
      fail("there are no three numbers with decimal points from column 21 on",
           "The columns of GRO files are fixed; write the file again with gmx editconf");
    }
    Atom atom;
    atom.source_line = static_cast<std::uint32_t>(lines_.number());
    atom.serial = static_cast<std::int32_t>(builder_.size() + 1);
    if (!parse_whole(trimmed(field_at(line, 0, 5)), atom.residue_number)) {
      fail("expected a residue number in columns 1-5, found \"" +
               shortened(trimmed(field_at(line, 0, 5))) + "\"",
           "The count of atoms may be wrong, or the columns have moved; write the file again with "
           "gmx editconf");
    }
    NameTable& names = builder_.molecule().names;
    atom.residue_name = names.intern(trimmed(field_at(line, 5, 5)));
    atom.name = names.intern(trimmed(field_at(line, 10, 5)));
    std::array<Decimal, 3> position;
    for (std::size_t axis = 0; axis < 3; ++axis) position[axis] = coordinate(line, axis);
    atom.kind =
        residue_kind(guesser_.identify(atom, StatedElement{}, NamePlace::free, names), false);
    builder_.set_record({});
    builder_.add(atom, position);
  }

  // The coordinate in Å. A number that is cut by its columns is an error; a shifted number is read.
  Decimal coordinate(std::string_view line, std::size_t axis) const {
    const std::string name(1, "xyz"[axis]);
    const std::size_t first = kPositions + axis * *width_, end = first + *width_;
    const std::string_view field = field_at(line, first, *width_);
    if (trimmed(field).empty()) {
      fail(name + " is missing", "The line may be truncated; fetch the file again");
    }
    const bool ends = end >= line.size() || is_blank(line[end]);
    // Only a velocity can follow z, and it is never so large that it touches z.
    const bool in_place = field.size() == *width_ && field[kPointColumn] == '.' &&
                          (axis < 2 || ends || line[end] == '-');
    const bool apart = is_blank(field.front()) && ends;
    Decimal value;
    const DecimalStatus status = parse_decimal(trimmed(field), value);
    if (status != DecimalStatus::ok || (!in_place && !apart)) {
      fail("expected a number of nm for " + name + " in columns " + std::to_string(first + 1) +
               "-" + std::to_string(end) + ", found \"" + shortened(field) + "\"",
           remedy_of_number(
               status,
               "The columns of GRO files are fixed; write the file again with gmx editconf"));
    }
    return angstrom_of_nanometres(value);
  }

  // Skips the box: three numbers or nine.
  void read_box() {
    std::string_view line;
    if (!lines_.next(line)) {
      builder_.molecule().notes.push_back(
          "The last frame has no line with its box: the file may have been cut off");
      return;
    }
    if (is_box(line)) return;
    fail("expected the box after " + std::to_string(count_) +
             " atoms, which is three numbers or "
             "nine, found \"" +
             shortened(trimmed(line)) + "\"",
         "The count in line " + std::to_string(count_line_) +
             " may be wrong, or the file is truncated; correct the count or fetch the file again");
  }

  [[noreturn]] void fail(std::string reason, std::string remedy) const {
    throw ReadError(input_.source, lines_.number(), std::move(reason), std::move(remedy));
  }

  const ReaderInput& input_;
  LineReader lines_;
  MoleculeBuilder builder_;
  AtomGuesser guesser_;
  std::optional<std::size_t> width_;  // of the positions of this frame
  std::size_t count_ = 0, count_line_ = 0;
};

Molecule read_gro(const ReaderInput& input) {
  return GroReader(input).read();
}

// An atom line, as "    1SOL     OW    1   0.126   1.624   1.679".
bool is_gro_atom(std::string_view line) {
  std::int64_t number = 0;
  if (!parse_whole(trimmed(field_at(line, 0, 5)), number) ||
      !parse_whole(trimmed(field_at(line, 15, 5)), number)) {
    return false;
  }
  const auto width = width_of_positions(line);
  return width && line.size() >= kPositions + 3 * *width &&
         are_numbers_from(field_kinds(line.substr(kPositions)), 0, 3);
}

// Recognises GRO by the two lines below the title, which can be any text.
Recognised recognise_gro(const FileSample& sample) {
  LineReader lines(sample.text);
  std::string_view title, count, atom;
  lines.next(title);
  lines.next(count);
  lines.next(atom);
  return field_kinds(count) == "i" && is_gro_atom(atom) ? Recognised::certain
                                                        : Recognised::by_ending;
}

}  // namespace

FileFormat gro_format() {
  return {"gro", "GRO", {".gro"}, recognise_gro, read_gro};
}

}  // namespace alphascope
