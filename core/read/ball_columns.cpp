// SPDX-License-Identifier: GPL-3.0-or-later
// Decides from the lines of a table of balls which columns hold x, y, z and r.
#include "core/read/ball_columns.hpp"
#include "core/text/printable.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <string>

#include "core/files/read_error.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/read/decimal.hpp"
#include "core/read/residues/atom_names.hpp"

namespace alphascope {
namespace {

using Fields = std::vector<std::string_view>;

// Enough lines to decide. The reader reports later lines that do not fit.
constexpr std::size_t kLinesToLookAt = 100'000;

bool is_whole(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

// True when four numbers begin at field `first`.
bool numbers_from(const Fields& fields, std::size_t first) {
  if (fields.size() < first + 4) return false;
  return std::all_of(fields.begin() + first, fields.begin() + first + 4, is_number);
}

// Evidence from the lines of a table about the fields "a b c d e …". a is x or the number of the
// ball.
struct Evidence {
  std::size_t lines = 0;
  bool whole = true;        // a is a whole number without sign
  bool counts = true;       // a goes up by one from 0 or 1
  bool fractions = true;    // b, c and d have a decimal point
  bool flags = true;        // e is 1 and a name follows, as in MSMS' XYZRN
  bool mixed = false;       // some lines have only four numbers
  bool negative_d = false;  // then d is no radius
  bool negative_e = false;

  void take(const Fields& f) {
    ++lines;
    whole &= is_whole(f[0]);
    counts &= whole && continues(f[0]);
    for (std::size_t k = 1; k < 4; ++k) fractions &= f[k].find('.') != std::string_view::npos;
    flags &= f[4] == "1" && f.size() > 5 && !is_number(f[5]);
    negative_d |= f[3].starts_with('-');
    negative_e |= f[4].starts_with('-');
  }

 private:
  bool continues(std::string_view text) {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc()) return false;
    const bool next = lines == 1 ? number <= 1 : number == last_ + 1;
    last_ = number;
    return next;
  }
  std::uint64_t last_ = 0;
};

class ColumnFinder {
 public:
  ColumnFinder(const std::filesystem::path& source, std::string_view data, LineReader rest)
      : source_(source), data_(data), rest_(rest), line_(rest.number()) {}

  BallColumns find() {
    const Fields first = ball_fields(data_);
    if (numbers_from(first, 0)) {
      const bool five = first.size() > 4 && is_number(first[4]);
      return five ? find_number(first) : BallColumns{};
    }
    if (first.size() > 4 && !is_number(first[0]) && numbers_from(first, first.size() - 4)) {
      check_labels(first);
      return {first.size() - 4, false};
    }
    fail("expected four numbers \"x y z r\", found \"" + shortened(data_) + "\"",
         "Each line holds the centre and the radius of one ball, in Å");
  }

 private:
  // Labels are chain, residue number and atom name. Numbers in other places may also be
  // coordinates.
  void check_labels(const Fields& fields) const {
    for (std::size_t k = 1; k + 4 < fields.size(); ++k) {
      const bool fits =
          k == 1 ? !is_number(fields[k]) || is_residue_number(fields[k]) : !is_number(fields[k]);
      if (fits) continue;
      fail("it is not clear which of these numbers are x, y, z and r: \"" + shortened(data_) + "\"",
           "Lines are \"[chain [residue-number [atom-name]]] x y z r\"; put # before what follows "
           "the radius");
    }
  }

  static bool is_residue_number(std::string_view text) {
    if (text.starts_with('-')) text.remove_prefix(1);
    return is_whole(text);
  }

  BallColumns find_number(const Fields& first) {
    const Evidence seen = look_at_all(first);
    const BallColumns numbered{1, true}, plain{};
    if (!seen.whole || seen.negative_e) return plain;
    const bool number = seen.counts && seen.fractions;
    if (seen.counts && seen.negative_d && !seen.mixed) return numbered;
    if (number && seen.lines > 1 && !seen.flags && !seen.mixed) return numbered;
    if (seen.flags && !number) return plain;
    fail("five numbers: the first may be x, or the number of the ball before x y z r",
         "Remove the column that is neither centre nor radius, or put # before what follows the "
         "radius");
  }

  Evidence look_at_all(const Fields& first) {
    Evidence seen;
    seen.take(first);
    std::string_view line;
    while (seen.whole && seen.lines < kLinesToLookAt && rest_.next(line)) {
      const std::string_view data = trimmed(line);
      if (data.empty() || data.front() == '#') continue;
      const Fields fields = ball_fields(data);
      if (fields.size() > 4 && numbers_from(fields, 0) && is_number(fields[4])) {
        seen.take(fields);
      } else if (numbers_from(fields, 0)) {
        seen.whole &= is_whole(fields[0]);
        seen.mixed = true;
      }
    }
    return seen;
  }

  [[noreturn]] void fail(std::string reason, std::string remedy) const {
    throw ReadError(source_, line_, std::move(reason), std::move(remedy));
  }

  const std::filesystem::path& source_;
  std::string_view data_;
  LineReader rest_;
  std::size_t line_;
};

}  // namespace

std::vector<std::string_view> ball_fields(std::string_view data) {
  data = data.substr(0, data.find('#'));
  Fields fields;
  for (std::string_view f = next_field(data); !f.empty(); f = next_field(data)) fields.push_back(f);
  return fields;
}

bool is_number(std::string_view text) {
  Decimal value;
  return parse_decimal(text, value) != DecimalStatus::malformed;
}

BallColumns find_ball_columns(const std::filesystem::path& source, std::string_view data,
                              LineReader rest) {
  return ColumnFinder(source, data, rest).find();
}

}  // namespace alphascope
