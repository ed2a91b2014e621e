// SPDX-License-Identifier: GPL-3.0-or-later
// CHARMM's coordinate cards: title lines with *, the number of atoms, then one line per atom in
// columns. Columns are narrow: I5 I5 1X A4 1X A4 3F10.5 1X A4 1X A4 F10.5. After "EXT" or from
// 100,000 atoms on they are wide: I10 I10 2X A8 2X A8 3F20.10 2X A8 2X A8 F20.10. The last number
// is no radius.
#include <charconv>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/read/field_kinds.hpp"
#include "core/read/file_format.hpp"
#include "core/read/molecule_builder.hpp"
#include "core/read/residues/atom_names.hpp"
#include "core/text/printable.hpp"
#include "core/text_files/line_reader.hpp"

namespace alphascope {
namespace {

constexpr std::size_t kProgressAtoms = 65536;

// First column (from 0) and width of each field.
struct CardLayout {
  struct Field {
    std::size_t first, width;
  };
  Field serial, residue_name, atom_name, x, segment, residue_id;
};

constexpr CardLayout kNarrow{{0, 5}, {11, 4}, {16, 4}, {20, 10}, {51, 4}, {56, 4}};
constexpr CardLayout kWide{{0, 10}, {22, 8}, {32, 8}, {40, 20}, {102, 8}, {112, 8}};

std::string_view field_of(std::string_view line, CardLayout::Field field) {
  return line.size() <= field.first ? std::string_view()
                                    : trimmed(line.substr(field.first, field.width));
}

class CardReader {
 public:
  explicit CardReader(const ReaderInput& input)
      : input_(input), lines_(input.text), builder_(input.source, "CHARMM CRD") {}

  Molecule read() {
    std::string_view line;
    bool filled = lines_.next(line);
    for (; filled && (line.starts_with("*") || trimmed(line).empty()); filled = lines_.next(line)) {
      std::string& title = builder_.molecule().title;
      if (title.empty() && line.size() > 1) title = std::string(trimmed(line.substr(1)));
    }
    if (!filled) return builder_.finish();
    read_count(line);
    while (builder_.size() < count_ && lines_.next(line)) {
      if (!trimmed(line).empty()) take_atom(line);
    }
    if (builder_.size() < count_) {
      throw ReadError(input_.source, count_line_,
                      "this line announces " + std::to_string(count_) + " atoms, but " +
                          std::to_string(builder_.size()) + " follow",
                      "The file is incomplete or the count is wrong; fetch it again");
    }
    while (lines_.next(line)) {
      if (!trimmed(line).empty()) {
        fail("more atoms than the " + std::to_string(count_) + " announced",
             "Correct the count or remove the surplus lines");
      }
    }
    guesser_.add_note(builder_.molecule(), "because CHARMM cards hold none");
    return builder_.finish();
  }

 private:
  void read_count(std::string_view line) {
    count_line_ = lines_.number();
    const std::string_view whole = trimmed(line);
    const std::string_view number = next_field(line);
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), count_);
    if (error != std::errc() || end != number.data() + number.size()) {
      fail("expected the number of atoms after the title, found \"" + shortened(whole) + "\"",
           "CHARMM cards have title lines with *, then the number of atoms");
    }
    wide_ = count_ >= 100000 || trimmed(line).starts_with("EXT");
    builder_.reserve(std::min(count_, lines_.bytes_left() / 50));
  }

  void take_atom(std::string_view line) {
    if (builder_.size() % kProgressAtoms == 0) input_.report(lines_.bytes_left());
    const CardLayout& layout = wide_ ? kWide : kNarrow;
    NameTable& names = builder_.molecule().names;
    Atom atom;
    atom.source_line = static_cast<std::uint32_t>(lines_.number());
    atom.serial = static_cast<std::int32_t>(builder_.size() + 1);
    std::array<Decimal, 3> position;
    for (std::size_t k = 0; k < 3; ++k) {
      position[k] =
          number(field_of(line, {layout.x.first + k * layout.x.width, layout.x.width}), "xyz"[k]);
    }
    atom.name = names.intern(field_of(line, layout.atom_name));
    atom.residue_name = names.intern(field_of(line, layout.residue_name));
    atom.chain = atom.label_chain = names.intern(field_of(line, layout.segment));
    const std::string_view id = field_of(line, layout.residue_id);
    const auto [end, error] =
        std::from_chars(id.data(), id.data() + id.size(), atom.residue_number);
    if (error == std::errc() && end + 1 == id.data() + id.size()) atom.insertion_code = *end;
    atom.kind =
        residue_kind(guesser_.identify(atom, StatedElement{}, NamePlace::free, names), false);
    builder_.set_record({});
    builder_.add(atom, position);
  }

  Decimal number(std::string_view text, char what) const {
    Decimal value;
    const DecimalStatus status = parse_decimal(text, value);
    if (status == DecimalStatus::ok) return value;
    const std::string name(1, what);
    if (text.empty()) fail(name + " is missing", "The line may be truncated; fetch the file again");
    fail("expected a number for " + name + ", found \"" + shortened(text) + "\"",
         remedy_of_number(
             status,
             "The columns of CHARMM cards are fixed; write the file again with CHARMM or VMD"));
  }

  [[noreturn]] void fail(std::string reason, std::string remedy) const {
    throw ReadError(input_.source, lines_.number(), std::move(reason), std::move(remedy));
  }

  const ReaderInput& input_;
  LineReader lines_;
  MoleculeBuilder builder_;
  AtomGuesser guesser_;
  bool wide_ = false;
  std::size_t count_ = 0, count_line_ = 0;
};

Molecule read_charmm(const ReaderInput& input) {
  return CardReader(input).read();
}

// Looks for title lines with * and then the number of atoms. Reports of other programs also begin
// with *.
Recognised recognise_charmm(const FileSample& sample) {
  constexpr int kLinesToLookAt = 2000;
  if (!sample.before.empty() || !trimmed(sample.first).starts_with('*')) return Recognised::no;
  LineReader lines(sample.text);
  std::string_view line;
  for (int k = 0; k < kLinesToLookAt && lines.next(line); ++k) {
    const std::string_view data = trimmed(line);
    if (data.empty() || data.front() == '*') continue;
    return field_kinds(data).starts_with('i') ? Recognised::likely : Recognised::no;
  }
  return sample.ending == ".crd" ? Recognised::likely : Recognised::no;  // the file was cut off
}

}  // namespace

FileFormat charmm_format() {
  return {"charmm", "CHARMM CRD", {".crd"}, recognise_charmm, read_charmm};
}

}  // namespace alphascope
