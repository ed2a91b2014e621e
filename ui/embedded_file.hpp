// SPDX-License-Identifier: GPL-3.0-or-later
// Puts the bytes of a file into the program by the assembler's .incbin. C++ arrays of the same
// bytes took seconds to compile.
#pragma once

// At namespace scope of one source: defines alphascope_NAME_begin and alphascope_NAME_end. `path`
// is a literal. The build must know that the source depends on the file.
#define ALPHASCOPE_EMBEDDED_FILE(name, path)                  \
  asm(".pushsection .rodata\n"                                \
      ".balign 16\n"                                          \
      "alphascope_" #name                                     \
      "_begin:\n"                                             \
      ".incbin \"" path                                       \
      "\"\n"                                                  \
      "alphascope_" #name                                     \
      "_end:\n"                                               \
      ".byte 0\n"                                             \
      ".global alphascope_" #name "_begin, alphascope_" #name \
      "_end\n"                                                \
      ".popsection\n");                                       \
  extern "C" const unsigned char alphascope_##name##_begin[], alphascope_##name##_end[]
