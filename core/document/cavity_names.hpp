// Cavities in the words of the molecule: what a cavity is called, and which residues line it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/cavity/cavity_table.hpp"
#include "core/molecule/prepare_balls.hpp"

namespace alphascope {

struct LiningResidue {
  std::string address;               // "A:HIS 87"
  std::vector<std::uint32_t> atoms;  // that line the cavity: indices into Molecule::atoms
  std::vector<BallIndex> balls;      // the same as balls
  friend bool operator==(const LiningResidue&, const LiningResidue&) = default;
};

class CavityNames {
 public:
  CavityNames(std::shared_ptr<const Molecule> molecule,
              std::shared_ptr<const PreparedBalls> prepared)
      : molecule_(std::move(molecule)), prepared_(std::move(prepared)) {}

  // The four atoms of the deepest sink, "A:LEU 24:CD1 A:ILE 50:O …". It stays while alpha moves and
  // does not depend on the order of the table, so a paper can use it.
  std::string name(const CavityTable& table, std::size_t row) const;

  // In the order of the molecule.
  std::vector<LiningResidue> lining(const CavityTable& table, std::size_t row) const;

 private:
  std::shared_ptr<const Molecule> molecule_;
  std::shared_ptr<const PreparedBalls> prepared_;
};

}  // namespace alphascope
