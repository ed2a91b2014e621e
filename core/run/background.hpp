// Threads whose work may wait.
#pragma once

namespace alphascope {

// The calling thread gets a core only when no other thread wants it, from now on and for good.
// Where the system has no such rule, nothing happens.
void let_others_go_first();

}  // namespace alphascope
