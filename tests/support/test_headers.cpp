// SPDX-License-Identifier: GPL-3.0-or-later
// Has no code of its own. tests/CMakeLists.txt precompiles headers with this source, and other
// tests use them.
