// Memory that the program has freed.
#pragma once

namespace alphascope {

// Gives it back to the system, as far as whole pages are free. Of many small objects the allocator
// keeps it by itself. Takes some milliseconds for a gigabyte, in which other threads may wait for
// memory.
void give_back_freed_memory();

}  // namespace alphascope
