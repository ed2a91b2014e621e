// The PDB format, version 3.3 and what other programs make of it. Columns are quoted from 1, as the
// format description has them. Coordinates are taken from the text itself, because gemmi's reader
// hands out binary doubles without line numbers, refuses old files with an identifier in columns
// 73-80, and reads wrong numbers where a five-digit residue number pushes the columns right.
#include <charconv>
#include <limits>
#include <optional>
#include <unordered_map>
#include <unordered_set>

#include "core/io/atom_names.hpp"
#include "core/io/line_reader.hpp"
#include "core/io/molecule_builder.hpp"
#include "core/io/pdb_assembly.hpp"
#include "core/io/readers.hpp"

namespace alphascope {
namespace {

constexpr std::size_t kProgressLines = 65536;
constexpr const char* kKeepColumns =
    "In a PDB file each value has its own columns; write the file again with a program that keeps "
    "to them, or as mmCIF";

// Columns first..last of a line (from 1); shorter or empty where the line ends early.
std::string_view columns(std::string_view line, std::size_t first, std::size_t last) {
  if (line.size() < first) return {};
  return line.substr(first - 1, last - first + 1);
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool parse_int(std::string_view text, std::int32_t& value) {
  text = trimmed(text);
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && !text.empty() && end == text.data() + text.size();
}

// Decimal, hybrid-36 ("A0000" follows 99999) or, as some programs write, hexadecimal.
std::int32_t parse_serial(std::string_view text, std::size_t width) {
  std::int32_t value = 0;
  if (parse_int(text, value)) return value;
  text = trimmed(text);
  if (text.size() == width && text.front() >= 'A') {
    const bool lower = text.front() >= 'a';
    std::int64_t number = 0;
    for (const char c : text) {
      const int digit = is_digit(c) ? c - '0' : (lower ? c - 'a' : c - 'A') + 10;
      if (digit < 0 || digit > 35) return 0;
      number = number * 36 + digit;
    }
    // The first letter form starts at A00…, which takes the place of 100…; lower case follows.
    std::int64_t power = 1, decimal = 1;
    for (std::size_t k = 1; k < width; ++k) power *= 36, decimal *= 10;
    number += decimal * 10 - 10 * power;
    if (lower) number += 26 * power;
    return number <= INT32_MAX ? static_cast<std::int32_t>(number) : 0;
  }
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
  return error == std::errc() && end == text.data() + text.size() ? value : 0;
}

// A field of the columns: blank, a number, or something else (cut from its neighbours wrongly).
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
  explicit PdbReader(const ReaderInput& input)
      : input_(input), lines_(input.text), builder_(input.source, "PDB") {
    builder_.reserve(input.text.size() / 81);
  }

  Molecule read() {
    std::string_view line;
    while (lines_.next(line)) {
      if (lines_.number() % kProgressLines == 0) input_.report(lines_.bytes_left());
      take(line);
    }
    Molecule& molecule = builder_.molecule();
    guesser_.add_note(molecule, "because columns 77-78 hold none");
    if (shifted_lines_ > 0) {
      molecule.notes.push_back(
          "Lines read with their columns shifted right by a residue number of five or more "
          "digits: " +
          std::to_string(shifted_lines_));
    }
    assemblies_.finish(molecule);
    return builder_.finish();
  }

 private:
  void take(std::string_view line) {
    // Some programs let a serial number of six digits begin in column 6.
    const bool atom =
        line.starts_with("ATOM ") && line.size() > 5 && (is_blank(line[5]) || is_digit(line[5]));
    if (atom || line.starts_with("HETATM")) {
      take_atom(line);
    } else if (line.starts_with("MODEL") && (line.size() == 5 || is_blank(line[5]))) {
      std::int32_t number = ++model_count_;
      parse_int(line.substr(5), number);
      builder_.begin_model(number);
      between_models_ = false;
    } else if (line.starts_with("ENDMDL")) {
      between_models_ = true;
    } else if (line.starts_with("REMARK 350")) {
      assemblies_.take(line, lines_.number());
    } else if (line.starts_with("TITLE ")) {
      take_title(line);
    } else if (line.starts_with("MODRES")) {
      take_modified(line);
    }
  }

  void take_title(std::string_view line) {
    std::string& title = builder_.molecule().title;
    std::string_view more = columns(line, 11, 80);
    while (!more.empty() && is_blank(more.back())) more.remove_suffix(1);
    if (title.empty()) more = trimmed(more);
    title += more;
  }

  // A residue that stands for an amino acid or a nucleotide. Programs also note other renamings
  // here, such as SUL for the sulphate SO4.
  void take_modified(std::string_view line) {
    const std::string_view standard = trimmed(columns(line, 25, 27));
    if (!standard.empty() && residue_family(standard) != ResidueFamily::biopolymer) return;
    modified_.insert(
        residue_key(columns(line, 17, 17), columns(line, 19, 22), columns(line, 23, 23)));
  }

  static std::string residue_key(std::string_view chain, std::string_view number,
                                 std::string_view insertion_code) {
    return std::string(trimmed(chain)) + '/' + std::string(trimmed(number)) +
           std::string(trimmed(insertion_code));
  }

  void take_atom(std::string_view line) {
    if (between_models_) {
      builder_.begin_model(++model_count_);
      between_models_ = false;
    }
    model_count_ = std::max(model_count_, 1);
    Atom atom;
    atom.source_line = static_cast<std::uint32_t>(lines_.number());
    atom.hetero = line[0] == 'H';
    std::array<Decimal, 3> position;
    const std::size_t shift = take_position(line, position);
    // Behind the coordinates everything is optional.
    const std::string_view rest = line.size() > shift ? line.substr(shift) : std::string_view();
    take_names(line, rest, shift, atom);
    atom.occupancy = to_float(columns(rest, 55, 60), 1);
    take_b_factor(to_float(columns(rest, 61, 66), kNoNumber), atom);
    atom.segment = segment(trimmed(columns(rest, 73, 76)));
    builder_.add(atom, position);
  }

  // PDBQT has charges there, and there is no telling what else others write.
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
    // Only a residue number that runs on into column 27 explains a shift.
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

  // The occupancy is tested too: in a shifted line x, y and z can look like numbers, but then the
  // occupancy is cut apart.
  bool try_position(std::string_view line, std::array<Decimal, 3>& position) const {
    // Digits of z may be missing at the very end of a file; elsewhere short lines are the writer's.
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
           status == DecimalStatus::not_finite
               ? "Coordinates must be finite; remove this atom or compute it again"
               : kKeepColumns);
    }
    fail("the occupancy in columns 55-60 is not a number: \"" + shortened(columns(line, 55, 60)) +
             "\", so the coordinates before it may be cut apart",
         kKeepColumns);
  }

  // rest: the line from `shift` on, with everything behind the coordinates in its columns.
  void take_names(std::string_view line, std::string_view rest, std::size_t shift, Atom& atom) {
    NameTable& names = builder_.molecule().names;
    const bool six_digits = !atom.hetero && is_digit(line[5]);
    atom.serial =
        six_digits ? parse_serial(columns(line, 6, 11), 6) : parse_serial(columns(line, 7, 11), 5);
    const std::string_view name = columns(line, 13, 16);
    atom.name = names.intern(trimmed(name));
    atom.altloc = column(line, 17);
    take_residue_and_chain(line, atom);
    const std::string_view number = columns(line, 23, 26 + shift);
    atom.residue_number = parse_serial(number, 4);
    // A fifth digit without shift: the blanks before x were used up.
    if (shift == 0 && is_digit(column(line, 27)) && is_digit(column(line, 26))) {
      atom.residue_number = parse_serial(columns(line, 23, 27), 5);
    } else {
      atom.insertion_code = column(line, 27 + shift);
    }
    const Element symbol = element_from_symbol(trimmed(columns(rest, 77, 78)));
    const auto stated = symbol == kUnknownElement ? std::nullopt : std::optional(symbol);
    atom.kind = atom_kind(guesser_.identify(atom, stated, place_of(name), names), atom.hetero);
    if (atom.kind == AtomKind::ligand && !modified_.empty() &&
        modified_.contains(residue_key(names.text(atom.chain), number,
                                       std::string_view(&atom.insertion_code, 1)))) {
      atom.kind = AtomKind::polymer;
    }
  }

  // Columns 18-20 and 22; column 21 holds a fourth letter of the residue name (CHARMM) or, in big
  // structures, the first of two of the chain: the latter when 18-20 name a standard residue.
  void take_residue_and_chain(std::string_view line, Atom& atom) {
    NameTable& names = builder_.molecule().names;
    std::string_view residue = trimmed(columns(line, 18, 20));
    std::string_view chain = trimmed(columns(line, 22, 22));
    if (column(line, 21) != ' ') {
      const ResidueFamily family = residue_family(residue);
      const bool two_letter_chain =
          !chain.empty() && family != ResidueFamily::unknown && family != ResidueFamily::ligand;
      if (two_letter_chain) {
        chain = columns(line, 21, 22);
      } else {
        residue = trimmed(columns(line, 18, 21));
      }
    }
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
  std::unordered_set<std::string> modified_;  // residues that MODRES names
  std::unordered_map<std::string, std::uint16_t> segments_;
  std::string_view last_segment_text_;  // of the text that is read
  std::uint16_t last_segment_ = 0;
  int model_count_ = 0;
  bool between_models_ = false;
  std::size_t shifted_lines_ = 0;
};

}  // namespace

Molecule read_pdb(const ReaderInput& input) {
  return PdbReader(input).read();
}

}  // namespace alphascope
