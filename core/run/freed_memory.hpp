// SPDX-License-Identifier: GPL-3.0-or-later
// Returns freed memory to the system.
#pragma once

namespace alphascope {

// Returns whole free pages to the system. Without this call the allocator keeps most of the memory
// of many small objects. Other threads may wait for their allocations meanwhile.
void return_freed_memory();

}  // namespace alphascope
