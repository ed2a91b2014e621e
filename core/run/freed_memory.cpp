// SPDX-License-Identifier: GPL-3.0-or-later
// Returns freed memory by malloc_trim() of glibc.
#include "core/run/freed_memory.hpp"

#include <malloc.h>

namespace alphascope {

void return_freed_memory() {
  malloc_trim(0);
}

}  // namespace alphascope
