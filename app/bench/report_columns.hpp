// SPDX-License-Identifier: GPL-3.0-or-later
// The columns that the tables of the thesis' suite share. A row names a molecule with its balls,
// and belongs to a report.
#pragma once

#include <cstdint>

#include "app/bench/thesis_suite.hpp"
#include "core/document/tables/column.hpp"

namespace alphascope {

// `report_of` is a function: the report of a row.
template <class Row>
inline constexpr Column<Row> kMoleculeColumn{
    .id = "molecule",
    .title = "molecule",
    .help = "The name of the file, without ending.",
    .value = [](const Row& r) -> CellValue { return r.row.molecule; }};

template <class Row>
inline constexpr Column<Row> kBallsColumn{
    .id = "balls",
    .title = "balls",
    .help = "The number of balls.",
    .value = [](const Row& r) -> CellValue { return static_cast<std::uint64_t>(r.row.balls); }};

template <class Row, const ThesisReport& (*report_of)(const Row&)>
inline constexpr Column<Row> kSolventColumn{.id = "solvent_radius_angstrom",
                                            .title = "solvent radius",
                                            .unit = "Å",
                                            .help = "The requested solvent radius.",
                                            .value = [](const Row& r) -> CellValue {
                                              return report_of(r).options.solvent_radius_angstrom;
                                            }};

template <class Row, const ThesisReport& (*report_of)(const Row&)>
inline constexpr Column<Row> kProgramColumn{
    .id = "program",
    .title = "program",
    .help = "Name, version and commit of the program.",
    .value = [](const Row& r) -> CellValue { return report_of(r).program; }};

template <class Row, const ThesisReport& (*report_of)(const Row&)>
inline constexpr Column<Row> kCpuColumn{
    .id = "cpu",
    .title = "CPU",
    .help = "The name of the CPU.",
    .value = [](const Row& r) -> CellValue { return report_of(r).machine.cpu; }};

}  // namespace alphascope
