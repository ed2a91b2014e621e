// SPDX-License-Identifier: GPL-3.0-or-later
// Returns freed memory: large pages that are kept, and the heap's by malloc_trim() of glibc.
#include "core/run/freed_memory.hpp"

#include <malloc.h>

#include "core/run/large_pages.hpp"

namespace alphascope {

void return_freed_memory() {
  free_kept_large();
  malloc_trim(0);
}

}  // namespace alphascope
