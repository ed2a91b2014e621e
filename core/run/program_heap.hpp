// SPDX-License-Identifier: GPL-3.0-or-later
// The heap of a program whose start allocates much: the system provides memory in few large pages.
#pragma once

namespace alphascope {

// Bytes of the heap that start_heap_on_large_pages() reserves. The window and software OpenGL take
// about as much until the first picture of a small molecule.
inline constexpr int kHeapStartBytes = 64 << 20;

// Lets the heap begin with kHeapStartBytes of addresses, on large pages where the system offers
// them on request. Memory is used only once it is written. Call first in main(): allocations of the
// main thread use this heap, and those of other threads do not.
void start_heap_on_large_pages();

}  // namespace alphascope
