// SPDX-License-Identifier: GPL-3.0-or-later
// Checks whether the operators of assemblies move a molecule, mirror it, or distort it.
#include <algorithm>
#include <cmath>
#include <set>

#include "core/geometry/alpha.hpp"
#include "core/molecule/assembly.hpp"
#include "core/molecule/molecule.hpp"

namespace alphascope {
namespace {

// Six printed digits leave an error of 3·10^-6 in files of the PDB. A tolerance of 0.001 allows
// 0.05 Å in 100 Å.
constexpr double kLeastTolerance = 1e-3;

using Rows = std::array<std::array<double, 4>, 3>;

double determinant(const Rows& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

std::string named(const SymmetryOperator& o) {
  return "operator " + o.id + (o.line > 0 ? " in line " + std::to_string(o.line) : std::string());
}

std::string fault_of(const SymmetryOperator& o) {
  const bool singular = std::fabs(determinant(o.rows)) < kLeastTolerance;
  return "its " + named(o) +
         (singular ? " is singular: it flattens the molecule"
                   : " is not a rotation: it stretches or shears the molecule") +
         ". Correct its matrix, or fetch the file again";
}

template <class Use>
void for_each_operator(const Assembly& assembly, const Use& use) {
  for (const AssemblyGenerator& generator : assembly.generators) {
    for (const auto& factor : generator.factors) std::for_each(factor.begin(), factor.end(), use);
  }
}

}  // namespace

OperatorKind operator_kind(const SymmetryOperator& symmetry_operator) {
  const Rows& m = symmetry_operator.rows;
  // Integers are exact. With d decimal places the error is half a unit of the last.
  const int digits = symmetry_operator.digits;
  const double error = digits > 0 ? 0.5 * std::pow(10.0, -digits) : 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) {
      double product = i == j ? -1 : 0, tolerance = 3 * error * error;
      for (int k = 0; k < 3; ++k) {
        product += m[i][k] * m[j][k];
        tolerance += (std::fabs(m[i][k]) + std::fabs(m[j][k])) * error;
      }
      // Negated, so that NaN does not pass as a rotation.
      if (!(std::fabs(product) <= std::max(tolerance, kLeastTolerance))) {
        return OperatorKind::no_motion;
      }
    }
  }
  return determinant(m) > 0 ? OperatorKind::rotation : OperatorKind::mirror;
}

void refuse_assembly(Molecule& molecule, std::string id, std::string reason) {
  molecule.notes.push_back(
      (id.empty() ? std::string("The assemblies are") : "Assembly " + id + " is") +
      " left out: " + reason);
  molecule.assemblies.refused.push_back({std::move(id), std::move(reason)});
}

void check_operators(Molecule& molecule) {
  Assemblies& assemblies = molecule.assemblies;
  std::vector<OperatorKind> kinds;
  for (const SymmetryOperator& o : assemblies.operators) kinds.push_back(operator_kind(o));
  std::set<std::uint32_t> mirrors;
  std::vector<RefusedAssembly> refused;
  std::erase_if(assemblies.list, [&](const Assembly& assembly) {
    const SymmetryOperator* fault = nullptr;
    for_each_operator(assembly, [&](std::uint32_t o) {
      if (kinds[o] == OperatorKind::no_motion && !fault) fault = &assemblies.operators[o];
    });
    if (fault) {
      refused.push_back({assembly.id, fault_of(*fault)});
      return true;
    }
    for_each_operator(assembly, [&](std::uint32_t o) {
      if (kinds[o] == OperatorKind::mirror) mirrors.insert(o);
    });
    return false;
  });
  for (RefusedAssembly& r : refused) {
    refuse_assembly(molecule, std::move(r.id), std::move(r.reason));
  }
  for (const std::uint32_t o : mirrors) {
    molecule.notes.push_back("The " + named(assemblies.operators[o]) +
                             " is a reflection: its copies have the opposite handedness, so the "
                             "assembly contains mirror images of the molecule");
  }
}

}  // namespace alphascope
