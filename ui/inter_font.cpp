// Puts the font files into the program by the assembler's .incbin. C++ arrays of the same bytes
// took seconds to compile.
#include "ui/inter_font.hpp"

#define ALPHASCOPE_BYTES_OF(name, file)                       \
  asm(".pushsection .rodata\n"                                \
      ".balign 16\n"                                          \
      "alphascope_" #name                                     \
      "_begin:\n"                                             \
      ".incbin \"" ALPHASCOPE_FONTS "/" file                  \
      "\"\n"                                                  \
      "alphascope_" #name                                     \
      "_end:\n"                                               \
      ".byte 0\n"                                             \
      ".global alphascope_" #name "_begin, alphascope_" #name \
      "_end\n"                                                \
      ".popsection\n");                                       \
  extern "C" const unsigned char alphascope_##name##_begin[], alphascope_##name##_end[]

ALPHASCOPE_BYTES_OF(inter_regular, "Inter-Regular.otf");
ALPHASCOPE_BYTES_OF(inter_semibold, "Inter-SemiBold.otf");

namespace alphascope {

std::span<const unsigned char> inter_regular() {
  return {alphascope_inter_regular_begin, alphascope_inter_regular_end};
}

std::span<const unsigned char> inter_semibold() {
  return {alphascope_inter_semibold_begin, alphascope_inter_semibold_end};
}

}  // namespace alphascope
