// SPDX-License-Identifier: GPL-3.0-or-later
// Interns names, with a small cache for short ones.
#include "core/molecule/name_table.hpp"

#include <cstring>

#include "core/text/printable.hpp"

namespace alphascope {

NameId NameTable::intern(std::string_view text) {
  if (text.empty()) return 0;
  Recent* slot = nullptr;
  std::uint64_t key = 0;
  // A name with a zero byte could share its key with a shorter one. So it does not use the cache.
  if (text.size() <= sizeof key && text.find('\0') == std::string_view::npos) {
    std::memcpy(&key, text.data(), text.size());
    slot = &recent_[(key * 0x9E3779B97F4A7C15u) >> 55];
    if (slot->key == key) return slot->id;
  }
  const auto [entry, inserted] =
      ids_.try_emplace(printable(text), static_cast<NameId>(texts_.size()));
  if (inserted) texts_.push_back(entry->first);
  if (slot) *slot = {key, entry->second};
  return entry->second;
}

NameId NameTable::find(std::string_view text) const {
  const auto entry = ids_.find(printable(text));
  return entry == ids_.end() ? 0 : entry->second;
}

}  // namespace alphascope
