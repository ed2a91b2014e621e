// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of balls, one "x y z r" (Å) per line:
//   XYZR       x y z r [name…]; blank lines and lines starting with # are skipped
//   CRD        the same after a line with the number of balls (ParallelAC), or without (AlphaMol)
//   labelled   chain [residue-number [atom-name]] x y z r (Voronota)
//   numbered   number x y z r [name…]
#include <array>
#include <charconv>
#include <vector>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/read/ball_columns.hpp"
#include "core/read/field_kinds.hpp"
#include "core/read/file_format.hpp"
#include "core/read/molecule_builder.hpp"
#include "core/read/residues/atom_names.hpp"
#include "core/text/printable.hpp"
#include "core/text_files/line_reader.hpp"

namespace alphascope {
namespace {

constexpr std::size_t kProgressLines = 65536;

class BallTableReader {
 public:
  explicit BallTableReader(const ReaderInput& input)
      : input_(input), lines_(input.text), builder_(input.source, "XYZR") {}

  Molecule read() {
    std::string_view line;
    while (lines_.next(line)) {
      if (lines_.number() % kProgressLines == 0) input_.report(lines_.bytes_left());
      std::string_view data = trimmed(line);
      if (data.empty() || data.front() == '#') continue;
      if (first_line_ && take_count(data)) continue;
      first_line_ = false;
      take_ball(data);
    }
    if (counted_ && builder_.size() != count_) {
      fail(1,
           "the first line announces " + std::to_string(count_) + " balls, but " +
               std::to_string(builder_.size()) + " follow",
           "The file is incomplete or the count is wrong; fetch it again or correct the count");
    }
    add_notes();
    return builder_.finish();
  }

 private:
  void add_notes() {
    std::vector<std::string>& notes = builder_.molecule().notes;
    if (columns_.numbered) {
      notes.push_back(
          "Each line begins with the number of the ball, since the first column counts up by one; "
          "x y z r follow");
    }
    if (surplus_lines_ > 0) {
      notes.push_back("Numbers after the radius are ignored: in " + std::to_string(surplus_lines_) +
                      " of " + std::to_string(builder_.size()) + " lines, first in line " +
                      std::to_string(first_surplus_line_));
    }
  }

  bool take_count(std::string_view data) {
    const auto [end, error] = std::from_chars(data.data(), data.data() + data.size(), count_);
    counted_ = error == std::errc() && end == data.data() + data.size();
    if (!counted_) return false;
    first_line_ = false;
    builder_.molecule().format = "CRD";
    // Every ball takes at least eight characters, so a wrong count cannot reserve much memory.
    builder_.reserve(std::min<std::size_t>(count_, lines_.bytes_left() / 8));
    return true;
  }

  void take_ball(std::string_view data) {
    if (!columns_known_) {
      columns_ = find_ball_columns(input_.source, data, lines_);
      columns_known_ = true;
    }
    if (counted_ && builder_.size() == count_) {
      fail(lines_.number(),
           "more balls than the " + std::to_string(count_) + " that the first line announces",
           "Correct the count or remove the surplus lines");
    }
    Atom atom;
    atom.source_line = static_cast<std::uint32_t>(lines_.number());
    atom.serial = static_cast<std::int32_t>(builder_.size() + 1);
    if (columns_.numbered) {
      take_number_of_ball(data, atom);
    } else if (columns_.labels > 0) {
      take_labels(data, atom);
    }
    std::array<Decimal, 3> position;
    for (int k = 0; k < 3; ++k) position[k] = take_number(data, "xyz"[k]);
    const Decimal radius = take_number(data, 'r');
    if (radius.mantissa < 0) {
      fail(lines_.number(), "the radius is negative", "Radii are in Å and at least 0");
    }
    const std::string_view comment = trimmed(data);
    const bool labelled = columns_.labels > 0 && !columns_.numbered;
    if (!labelled && !comment.empty()) take_comment(atom, comment);
    builder_.add(atom, position, radius);
  }

  void take_number_of_ball(std::string_view& data, Atom& atom) {
    const std::string_view text = next_field(data);
    const bool fits =
        parse_whole(text, atom.serial) && (builder_.size() == 0 || atom.serial == last_number_ + 1);
    if (!fits) {
      fail(lines_.number(),
           "expected the number of the next ball in the first column, found \"" + shortened(text) +
               "\"",
           "The lines before are \"number x y z r\"; remove the numbers from all lines");
    }
    last_number_ = atom.serial;
  }

  // Takes "chain", "chain residue-number" or "chain residue-number atom-name". Further labels are
  // skipped.
  void take_labels(std::string_view& data, Atom& atom) {
    const std::size_t fields = ball_fields(data).size();
    if (fields != columns_.labels + 4) {
      fail(lines_.number(),
           "the line has " + std::to_string(fields) + " fields, the first ball's has " +
               std::to_string(columns_.labels + 4),
           "Every line needs the same labels before x y z r; put # before what follows the radius");
    }
    for (std::size_t k = 0; k < columns_.labels; ++k) {
      const std::string_view label = next_field(data);
      if (k == 0) {
        atom.chain = atom.label_chain = builder_.molecule().names.intern(label);
      } else if (k == 1) {
        std::from_chars(label.data(), label.data() + label.size(), atom.residue_number);
      } else if (k == 2) {
        take_name(atom, label);
      }
    }
  }

  // The kind does not change, because every row of a table is to become a ball.
  void take_name(Atom& atom, std::string_view name) {
    atom.name = builder_.molecule().names.intern(name);
    guesser_.identify(atom, std::nullopt, NamePlace::free, builder_.molecule().names);
  }

  // Takes "# serial chain resSeq resName name …" as Voronota writes it, or a single name.
  void take_comment(Atom& atom, std::string_view comment) {
    const bool marked = comment.front() == '#';
    if (marked) comment.remove_prefix(1);
    const std::vector<std::string_view> fields = ball_fields(comment);
    if (fields.size() == 1 && !is_number(fields[0])) {
      take_name(atom, fields[0]);
    } else if (fields.size() == 2 && !is_number(fields[1])) {  // XYZRN: "1 name_res_number"
      take_joined_name(atom, fields[1]);
    } else if (fields.size() >= 5 && (marked || !is_number(fields[3]))) {
      atom.chain = atom.label_chain = builder_.molecule().names.intern(fields[1]);
      std::from_chars(fields[2].data(), fields[2].data() + fields[2].size(), atom.residue_number);
      atom.residue_name = builder_.molecule().names.intern(fields[3]);
      take_name(atom, fields[4]);
    } else if (!marked && is_number(fields[0])) {
      if (surplus_lines_++ == 0) first_surplus_line_ = lines_.number();
    }
  }

  // Takes "CA_GLY_12".
  void take_joined_name(Atom& atom, std::string_view text) {
    const std::size_t end = text.find('_');
    if (end != std::string_view::npos) {
      const std::string_view rest = text.substr(end + 1);
      atom.residue_name = builder_.molecule().names.intern(rest.substr(0, rest.find('_')));
    }
    take_name(atom, text.substr(0, end));
  }

  Decimal take_number(std::string_view& data, char what) {
    const std::string_view field = next_field(data);
    Decimal value;
    const DecimalStatus status = parse_decimal(field, value);
    if (status == DecimalStatus::ok) return value;
    const std::string name(1, what);
    if (field.empty()) {
      fail(lines_.number(), "the line ends before " + name,
           "A ball needs four numbers \"x y z r\"; the file may be truncated");
    }
    fail(lines_.number(), "expected a number for " + name + ", found \"" + shortened(field) + "\"",
         status == DecimalStatus::not_finite
             ? "Coordinates and radii must be finite; remove this ball or compute it again"
             : "A ball is four numbers \"x y z r\" in Å");
  }

  [[noreturn]] void fail(std::size_t line, std::string reason, std::string remedy) const {
    throw ReadError(input_.source, line, std::move(reason), std::move(remedy));
  }

  const ReaderInput& input_;
  LineReader lines_;
  MoleculeBuilder builder_;
  AtomGuesser guesser_;
  BallColumns columns_;
  bool first_line_ = true, columns_known_ = false, counted_ = false;
  std::size_t count_ = 0;
  std::int32_t last_number_ = 0;                            // of a numbered ball
  std::size_t surplus_lines_ = 0, first_surplus_line_ = 0;  // with numbers behind the radius
};

Molecule read_xyzr(const ReaderInput& input) {
  return BallTableReader(input).read();
}

// True for "1.0 2.0 3.0 1.5 …", and for four numbers behind one to three labels that begin with a
// name.
bool is_ball_line(std::string_view line) {
  const std::string kinds = field_kinds(line.substr(0, line.find('#')));
  return are_numbers_from(kinds, 0, 4) ||
         (kinds.size() >= 5 && kinds.size() <= 7 && kinds[0] == 'w' &&
          are_numbers_from(kinds, kinds.size() - 4, 4));
}

Recognised recognise_xyzr(const FileSample& sample) {
  const bool counted = field_kinds(sample.first) == "i";
  const bool below =
      is_ball_line(sample.second) || (trimmed(sample.second).empty() && is_ball_line(sample.third));
  const bool balls = is_ball_line(trimmed(sample.first)) || (counted && below);
  return balls ? Recognised::likely : Recognised::by_ending;
}

}  // namespace

FileFormat xyzr_format() {
  return {"xyzr", "XYZR (also as CRD)", {".xyzr", ".crd"}, recognise_xyzr, read_xyzr};
}

}  // namespace alphascope
