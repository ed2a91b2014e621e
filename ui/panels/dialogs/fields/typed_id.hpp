// SPDX-License-Identifier: GPL-3.0-or-later
// An id as the user types it in the window.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/document/fetch/fetch.hpp"

namespace alphascope {

struct TypedId {
  std::optional<MoleculeId> id;
  std::string fault;  // a sentence: why the text is no id; empty for an id or no text
  std::optional<FetchedFrom> before;  // where and when its file was fetched; none: it was not
};

// Blanks around the id are ignored. Looks into the folder of fetched files.
TypedId read_typed_id(std::string_view text, const FetchOptions& options);

// A field for an id. The disk is asked only when its text has changed.
class IdField {
 public:
  std::string text;

  const TypedId& read(const FetchOptions& options);
  void clear();

 private:
  std::optional<std::string> read_text_;  // of read_; none: nothing was read yet
  TypedId read_;
};

}  // namespace alphascope
