// Threads whose work may wait.
#pragma once

namespace alphascope {

// How much a thread gets of a core that other threads want, too: the kernel's "nice" value. Where
// nobody else wants it, it gets all.
enum class Share {
  third = 5,       // of what a usual thread gets
  seventieth = 19  // Never nothing: on a machine that is always busy its work would not end.
};

// For the calling thread, and the threads that it starts from now on; for good. Where the system
// has no such rule, nothing happens.
void give_way_to_others(Share share);

}  // namespace alphascope
