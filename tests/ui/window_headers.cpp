// SPDX-License-Identifier: GPL-3.0-or-later
// Has no code of its own. CMakeLists.txt precompiles headers with this source, for all tests of the
// window.
