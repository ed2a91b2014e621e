// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a grid of the emulated device at once and to its end.
#pragma once

#include <cstddef>
#include <functional>

namespace emulated {

// Runs the body once for each thread of the grid.
void run_grid(unsigned blocks, unsigned threads, std::size_t shared_bytes,
              const std::function<void()>& body);

}  // namespace emulated
