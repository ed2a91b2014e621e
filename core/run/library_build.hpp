// SPDX-License-Identifier: GPL-3.0-or-later
// Names the build of the program. A library that a program loads must be of the same build, because
// types of the standard library and exceptions cross its boundary.
#pragma once

namespace alphascope {

// Version, sources and compiler of this build, for example "0.2.0 5f0c… GCC 12.2.0". The same
// sources give the same text in any folder and at any time.
const char* library_build();

}  // namespace alphascope
