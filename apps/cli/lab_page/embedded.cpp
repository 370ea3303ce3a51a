// SPDX-License-Identifier: Apache-2.0
// The page as bytes of the program: the assembler includes the file verbatim, which costs no
// compile time.
#include "lab_page/lab_page.h"

asm(".section .rodata\n"
    "avo_lab_page_begin:\n"
    ".incbin \"" AVO_LAB_PAGE
    "\"\n"
    "avo_lab_page_end:\n"
    ".byte 0\n"
    ".previous\n");

extern "C" {
[[gnu::visibility("hidden")]] extern const char avo_lab_page_begin[];
[[gnu::visibility("hidden")]] extern const char avo_lab_page_end[];
}

namespace avo_cli {

std::string_view lab_page() {
  return {avo_lab_page_begin, static_cast<std::size_t>(avo_lab_page_end - avo_lab_page_begin)};
}

}  // namespace avo_cli
