// Tables of balls, one "x y z r" (Å) per line:
//   XYZR       x y z r [name…]; blank lines and lines starting with # are skipped
//   CRD        the same after a line with the number of balls (ParallelAC), or without (AlphaMol)
//   labelled   chain [residue-number [atom-name]] x y z r (Voronota)
#include <array>
#include <charconv>
#include <vector>

#include "core/io/atom_names.hpp"
#include "core/io/line_reader.hpp"
#include "core/io/molecule_builder.hpp"
#include "core/io/readers.hpp"

namespace alphascope {
namespace {

constexpr std::size_t kProgressLines = 65536;

bool is_number(std::string_view text) {
  Decimal value;
  return parse_decimal(text, value) != DecimalStatus::malformed;
}

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::string_view f = next_field(line); !f.empty(); f = next_field(line)) fields.push_back(f);
  return fields;
}

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
    return builder_.finish();
  }

 private:
  bool take_count(std::string_view data) {
    const auto [end, error] = std::from_chars(data.data(), data.data() + data.size(), count_);
    counted_ = error == std::errc() && end == data.data() + data.size();
    if (!counted_) return false;
    first_line_ = false;
    builder_.molecule().format = "CRD";
    // Every ball takes eight characters or more: a wrong count cannot make us reserve much.
    builder_.reserve(std::min<std::size_t>(count_, lines_.bytes_left() / 8));
    return true;
  }

  // The first ball tells where the labels are.
  void take_layout(std::string_view data) {
    const std::vector<std::string_view> fields = fields_of(data.substr(0, data.find('#')));
    const std::size_t n = fields.size();
    const auto numbers_from = [&](std::size_t first) {
      for (std::size_t k = first; k < first + 4; ++k) {
        if (k >= n || !is_number(fields[k])) return false;
      }
      return true;
    };
    if (numbers_from(0)) {
      labels_ = 0;
    } else if (n > 4 && !is_number(fields[0]) && numbers_from(n - 4)) {
      labels_ = n - 4;
    } else {
      fail(lines_.number(), "expected four numbers \"x y z r\", found \"" + shortened(data) + "\"",
           "Each line holds the centre and the radius of one ball, in Å");
    }
    layout_known_ = true;
  }

  void take_ball(std::string_view data) {
    if (!layout_known_) take_layout(data);
    if (counted_ && builder_.size() == count_) {
      fail(lines_.number(),
           "more balls than the " + std::to_string(count_) + " that the first line announces",
           "Correct the count or remove the surplus lines");
    }
    Atom atom;
    atom.source_line = static_cast<std::uint32_t>(lines_.number());
    atom.serial = static_cast<std::int32_t>(builder_.size() + 1);
    take_labels(data, atom);
    std::array<Decimal, 3> position;
    for (int k = 0; k < 3; ++k) position[k] = take_number(data, "xyz"[k]);
    const Decimal radius = take_number(data, 'r');
    if (radius.mantissa < 0) {
      fail(lines_.number(), "the radius is negative", "Radii are in Å and at least 0");
    }
    const std::string_view comment = trimmed(data);
    if (labels_ == 0 && !comment.empty()) take_comment(atom, comment);
    builder_.add(atom, position, radius);
  }

  // "chain", "chain residue-number", "chain residue-number atom-name"; more are passed over.
  void take_labels(std::string_view& data, Atom& atom) {
    for (std::size_t k = 0; k < labels_; ++k) {
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

  // The kind stays as it is: each ball of a table is meant.
  void take_name(Atom& atom, std::string_view name) {
    atom.name = builder_.molecule().names.intern(name);
    guesser_.identify(atom, std::nullopt, NamePlace::free, builder_.molecule().names);
  }

  // "# serial chain resSeq resName name …" as Voronota writes, or a single name.
  void take_comment(Atom& atom, std::string_view comment) {
    if (comment.front() == '#') comment.remove_prefix(1);
    const std::vector<std::string_view> fields = fields_of(comment);
    if (fields.size() == 1 && !is_number(fields[0])) {
      take_name(atom, fields[0]);
    } else if (fields.size() == 2 && !is_number(fields[1])) {  // XYZRN: "1 name_res_number"
      take_joined_name(atom, fields[1]);
    } else if (fields.size() >= 5) {
      atom.chain = atom.label_chain = builder_.molecule().names.intern(fields[1]);
      std::from_chars(fields[2].data(), fields[2].data() + fields[2].size(), atom.residue_number);
      atom.residue_name = builder_.molecule().names.intern(fields[3]);
      take_name(atom, fields[4]);
    }
  }

  // "CA_GLY_12".
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
  bool first_line_ = true, layout_known_ = false, counted_ = false;
  std::size_t count_ = 0;
  std::size_t labels_ = 0;  // fields before x
};

}  // namespace

Molecule read_ball_table(const ReaderInput& input) {
  return BallTableReader(input).read();
}

}  // namespace alphascope
