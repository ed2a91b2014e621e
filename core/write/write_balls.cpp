// SPDX-License-Identifier: GPL-3.0-or-later
// Writes balls as XYZR and PQR files.
#include "core/write/write_balls.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/molecule/element.hpp"
#include "core/write/text_writer.hpp"

namespace alphascope {
namespace {

constexpr std::size_t kReportBalls = 65536;

template <class Write>
void for_balls(const BallSet& balls, const RunContext& context, const Write& write) {
  for (std::size_t i = 0; i < balls.size(); ++i) {
    if (i % kReportBalls == 0) {
      context.report("writing", static_cast<double>(i) / static_cast<double>(balls.size()));
    }
    write(i);
  }
}

// The least number of digits that all given lattice numbers need, at most that of the lattice.
class Digits {
 public:
  explicit Digits(int of_lattice) : most_(std::max(of_lattice, 0)), digits_(std::min(3, most_)) {}
  void need(std::int32_t units) {
    while (digits_ < most_) {
      std::int32_t unit = 1;
      for (int n = digits_; n < most_; ++n) unit *= 10;
      if (units % unit == 0) return;
      ++digits_;
    }
  }
  int count() const { return digits_; }

 private:
  int most_, digits_;
};

// A field between blanks. Each character that a reader could take for a blank or line end becomes
// "_".
std::string one_field(std::string_view name, std::string_view otherwise = {}) {
  std::string text(name.empty() ? otherwise : name);
  std::replace_if(
      text.begin(), text.end(),
      [](char c) { return static_cast<unsigned char>(c) <= ' ' || c == '\x7f'; }, '_');
  return text;
}

class PqrWriter {
 public:
  PqrWriter(const BallSet& balls, const Molecule& molecule,
            const std::vector<std::uint32_t>& atom_of_ball)
      : balls_(balls), molecule_(molecule), atoms_(atom_of_ball) {
    Digits of_places(balls.lattice.digits), of_radii(balls.lattice.digits);
    for (std::size_t i = 0; i < balls.size(); ++i) {
      const LatticePoint& p = balls.centres[i];
      for (const std::int32_t x : {p.x, p.y, p.z}) of_places.need(x);
      of_radii.need(balls.radii[i]);
    }
    place_digits_ = of_places.count();
    radius_digits_ = of_radii.count();
    columns_ = place_digits_ <= 3 && balls.size() < 100000;
    for (std::size_t i = 0; columns_ && i < balls.size(); ++i) columns_ = fits(i);
  }

  std::string line(std::size_t i) const {
    const Atom& atom = atom_of(i);
    const std::string name = name_of(atom), residue = residue_of(atom);
    const std::string chain = one_field(molecule_.text(atom.chain));
    const char* const tag = atom.hetero ? "HETATM" : "ATOM";
    const auto place = [&](std::int32_t units) { return balls_.lattice.angstrom(units); };
    const LatticePoint& p = balls_.centres[i];
    const char insertion =
        static_cast<unsigned char>(atom.insertion_code) <= ' ' ? '\0' : atom.insertion_code;
    const std::string number =
        std::to_string(atom.residue_number) + (insertion ? std::string(1, insertion) : "");
    const int digits = place_digits_;
    // Names in mmCIF files have any length.
    std::string text(name.size() + residue.size() + chain.size() + 300, '\0');
    const int size =
        columns_
            ? std::snprintf(text.data(), text.size(),
                            "%-6s%5zu %-4s %3s %1s%4d%c   %8.*f%8.*f%8.*f 0.000 %.*f", tag, i + 1,
                            name.size() < 4 ? (" " + name).c_str() : name.c_str(), residue.c_str(),
                            chain.c_str(), atom.residue_number, insertion ? insertion : ' ', digits,
                            place(p.x), digits, place(p.y), digits, place(p.z), radius_digits_,
                            place(balls_.radii[i]))
            : std::snprintf(text.data(), text.size(),
                            "%s %zu %s %s %s %s %.*f %.*f %.*f 0.000 %.*f", tag, i + 1,
                            name.c_str(), residue.c_str(), chain.c_str(), number.c_str(), digits,
                            place(p.x), digits, place(p.y), digits, place(p.z), radius_digits_,
                            place(balls_.radii[i]));
    text.resize(static_cast<std::size_t>(size));
    return text;
  }

 private:
  const Atom& atom_of(std::size_t i) const { return molecule_.atoms[atoms_[i]]; }
  std::string name_of(const Atom& atom) const {
    return one_field(molecule_.text(atom.name), element_symbol(atom.element));
  }
  std::string residue_of(const Atom& atom) const {
    return one_field(molecule_.text(atom.residue_name), "UNK");
  }
  // Returns whether the line fits the columns of PDB files, with a blank before each number.
  bool fits(std::size_t i) const {
    const Atom& atom = atom_of(i);
    const LatticePoint& p = balls_.centres[i];
    const auto is_narrow = [&](std::int32_t units) {
      const double x = balls_.lattice.angstrom(units);
      return x > -99.9996 && x < 999.9996;
    };
    return name_of(atom).size() <= 4 && residue_of(atom).size() <= 3 &&
           molecule_.text(atom.chain).size() <= 1 && atom.residue_number > -999 &&
           atom.residue_number < 1000 && is_narrow(p.x) && is_narrow(p.y) && is_narrow(p.z);
  }

  const BallSet& balls_;
  const Molecule& molecule_;
  const std::vector<std::uint32_t>& atoms_;
  int place_digits_ = 3, radius_digits_ = 3;
  bool columns_ = true;
};

}  // namespace

void write_xyzr(const BallSet& balls, const BallHeader& header, AtomicFile& file,
                const RunContext& context) {
  TextWriter text(file, context.cancel);
  for (const auto& [key, value] : header) text << "# " << key << " " << value << "\n";
  const int digits = balls.lattice.digits;
  for_balls(balls, context, [&](std::size_t i) {
    const LatticePoint& p = balls.centres[i];
    text.lattice(p.x, digits) << " ";
    text.lattice(p.y, digits) << " ";
    text.lattice(p.z, digits) << " ";
    text.lattice(balls.radii[i], digits).end_line();
  });
  text.flush();
}

void write_pqr(const BallSet& balls, const Molecule& molecule,
               const std::vector<std::uint32_t>& atom_of_ball, const BallHeader& header,
               AtomicFile& file, const RunContext& context) {
  TextWriter text(file, context.cancel);
  for (const auto& [key, value] : header) text << "REMARK   3 " << key << " " << value << "\n";
  const PqrWriter writer(balls, molecule, atom_of_ball);
  for_balls(balls, context, [&](std::size_t i) {
    text << writer.line(i);
    text.end_line();
  });
  text << "END";
  text.end_line();
  text.flush();
}

}  // namespace alphascope
