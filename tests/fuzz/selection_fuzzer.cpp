// SPDX-License-Identifier: GPL-3.0-or-later
// Takes any text as a selection expression, as addresses of atoms, and as operators of an assembly.
#include <cstdlib>

#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/assembly.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/selection/atom_address.hpp"
#include "core/selection/selection_expression.hpp"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  alphascope::Molecule m;
  m.atoms.resize(1);
  m.atoms[0].chain = m.names.intern("A");
  try {
    static_cast<void>(alphascope::atoms_named(m, text)(0));
  } catch (const alphascope::SelectionError& error) {
    if (error.column() < 1 || error.column() > size + 1) std::abort();
  }
  try {
    const auto bound = alphascope::SelectionExpression::parse(text).bind(m);
    static_cast<void>(bound(m.atoms[0]));
  } catch (const alphascope::SelectionError& error) {
    if (error.column() < 1 || error.column() > size + 1) std::abort();
  }
  const std::vector<alphascope::SymmetryOperator> operators = {{"1", {}}, {"2", {}}, {"P", {}}};
  std::vector<std::vector<std::uint32_t>> factors;
  alphascope::parse_operator_expression(text, operators, factors);
  return 0;
}
