// SPDX-License-Identifier: GPL-3.0-or-later
// Integers of 128 bits, on host and device.
#pragma once

namespace alphascope {

__extension__ typedef __int128 Int128;
__extension__ typedef unsigned __int128 UInt128;

}  // namespace alphascope
