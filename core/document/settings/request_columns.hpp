// SPDX-License-Identifier: GPL-3.0-or-later
// The columns of tables whose rows have a request: alpha and solvent radius, as requested.
#pragma once

#include "core/document/settings/request.hpp"
#include "core/document/tables/column.hpp"
#include "core/geometry/shortest_number.hpp"

namespace alphascope {

// `request_of` is a function: the request of a row.
template <class Row, const Request& (*request_of)(const Row&)>
inline constexpr Column<Row> kRequestedAlpha{
    .id = "alpha_angstrom2",
    .title = "α",
    .unit = "Å²",
    .help = "The requested alpha.",
    .value = [](const Row& row) -> CellValue {
      return shortest_number(request_of(row).alpha_angstrom2);
    },
    .files = InFiles::csv};

template <class Row, const Request& (*request_of)(const Row&)>
inline constexpr Column<Row> kRequestedSolvent{
    .id = "solvent_radius_angstrom",
    .title = "solvent radius",
    .unit = "Å",
    .help = "The requested solvent radius.",
    .value = [](const Row& row) -> CellValue {
      return shortest_number(request_of(row).solvent_radius_angstrom);
    },
    .files = InFiles::csv};

}  // namespace alphascope
