// Memory that the program has freed.
#pragma once

namespace alphascope {

// Gives whole pages of it back to the system. The allocator itself keeps most of what many small
// objects had. Other threads that allocate may wait meanwhile.
void give_back_freed_memory();

}  // namespace alphascope
