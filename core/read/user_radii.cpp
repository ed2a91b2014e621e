// SPDX-License-Identifier: GPL-3.0-or-later
// Parses tables of radii that users write.
#include "core/read/user_radii.hpp"

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/read/decimal.hpp"
#include "core/read/residues/atom_names.hpp"
#include "core/text/printable.hpp"
#include "core/text_files/line_reader.hpp"
#include "core/text_files/text_file.hpp"

namespace alphascope {
namespace {

constexpr std::uint64_t kMaxBytes = 16 << 20;
constexpr std::int64_t kLargestRadius = 60'000'000;  // 10^-6 Å

class UserRadiiReader {
 public:
  UserRadiiReader(const std::filesystem::path& path, std::string_view text)
      : path_(path), lines_(text) {}

  UserRadii read() {
    std::string_view line;
    while (lines_.next(line)) {
      line = trimmed(line.substr(0, line.find('#')));
      if (!line.empty()) take(line);
    }
    if (radii_.by_atom.empty() && radii_.by_element.empty()) {
      throw ReadError(path_, 0, "the table holds no radii",
                      "Write lines such as \"C 1.70\" or \"ALA CB 1.88\"");
    }
    radii_.source = printable(path_.filename().string());
    return std::move(radii_);
  }

 private:
  void take(std::string_view line) {
    const std::string_view whole = line;
    std::string_view fields[4];
    for (std::string_view& field : fields) field = next_field(line);
    if (fields[1].empty() || !fields[3].empty()) {
      fail("expected \"element radius\" or \"residue atom radius\", found \"" + shortened(whole) +
           "\"");
    }
    const bool by_element = fields[2].empty();
    const std::int32_t radius = parse_radius(by_element ? fields[1] : fields[2]);
    bool added;
    if (by_element) {
      const Element element = element_from_symbol(fields[0]);
      if (element == kUnknownElement && fields[0] != "X") {
        fail("\"" + shortened(fields[0]) + "\" is not an element");
      }
      added = radii_.by_element.emplace(element, radius).second;
    } else {
      const std::string_view residue = fields[0] == "ANY" ? "*" : fields[0];
      added = radii_.by_atom.emplace(std::string(residue) + ' ' + std::string(fields[1]), radius)
                  .second;
    }
    if (!added) fail("this entry was given before");
  }

  std::int32_t parse_radius(std::string_view text) const {
    Decimal value;
    double rounding;
    if (parse_decimal(text, value) != DecimalStatus::ok) {
      fail("expected a radius, found \"" + shortened(text) + "\"");
    }
    const std::int64_t units = to_units(value, 6, rounding);
    if (units <= 0 || units > kLargestRadius) {
      fail("the radius " + shortened(text) + " Å is not above 0 and at most 60");
    }
    if (rounding > 0) fail("the radius " + shortened(text) + " Å has more than six decimals");
    return static_cast<std::int32_t>(units);
  }

  [[noreturn]] void fail(std::string reason) const {
    throw ReadError(
        path_, lines_.number(), std::move(reason),
        "Lines are \"C 1.70\" for an element, \"ALA CB 1.88\" for an atom of a residue, "
        "\"* CB 1.88\" for an atom of any residue");
  }

  const std::filesystem::path& path_;
  LineReader lines_;
  UserRadii radii_;
};

}  // namespace

UserRadii parse_user_radii(const std::filesystem::path& path, std::string_view text) {
  return UserRadiiReader(path, text).read();
}

std::shared_ptr<const UserRadii> read_user_radii(const std::filesystem::path& path,
                                                 const RunContext& context) {
  const LoadedText loaded = load_text(path, kMaxBytes, context);
  UserRadii radii = parse_user_radii(path, loaded.text);
  radii.sha256 = file_hash(loaded);
  return std::make_shared<const UserRadii>(std::move(radii));
}

}  // namespace alphascope
