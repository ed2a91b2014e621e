// SPDX-License-Identifier: GPL-3.0-or-later
// Keys of a JSON object from a list of columns.
#pragma once

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

#include "core/document/tables/column.hpp"

namespace alphascope {

// Null if there is no value.
inline nlohmann::ordered_json json_cell(const CellValue& value) {
  return std::visit(
      [](const auto& held) -> nlohmann::ordered_json {
        if constexpr (std::is_same_v<std::decay_t<decltype(held)>, std::monostate>)
          return nullptr;
        else
          return held;
      },
      value);
}

// Adds the keys of these columns to a JSON object, in this order.
template <class Row>
void add_keys(nlohmann::ordered_json& json, std::span<const Column<Row>> columns, const Row& row,
              std::initializer_list<std::string_view> ids) {
  for (const std::string_view id : ids) {
    json[std::string(id)] = json_cell(column_of(columns, id).value(row));
  }
}

// Adds the keys that the object lacks, in the order of the list: those up to the column `last`, or
// all without it. Nested values are written by hand between two calls.
template <class Row>
void add_keys_up_to(nlohmann::ordered_json& json, std::span<const Column<Row>> columns,
                    const Row& row, std::string_view last = {}) {
  for (const Column<Row>& column : columns) {
    if (column.is_shown(row, InFiles::json) && !json.contains(column.id)) {
      json[column.id] = json_cell(column.value(row));
    }
    if (column.id == last) return;
  }
  if (!last.empty()) throw InternalError("There is no column " + std::string(last) + ".");
}

}  // namespace alphascope
