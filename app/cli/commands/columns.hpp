// SPDX-License-Identifier: GPL-3.0-or-later
// The columns of --csv of commands in this folder, without provenance, for `columns`.
#pragma once

#include <vector>

#include "core/document/tables/column_info.hpp"

namespace alphascope::cli {

std::vector<ColumnInfo> info_columns();
std::vector<ColumnInfo> compute_columns();
std::vector<ColumnInfo> bench_columns();

}  // namespace alphascope::cli
