# Writes OUT (generated/commit.h) with the commit that SOURCE stands at; a tree without a history says "unknown".
# Run at every build, so that the answer cannot be an old one; the file changes only when the commit does.
execute_process(COMMAND git -C ${SOURCE} describe --always --dirty --abbrev=10
  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed OR commit STREQUAL "")
  set(commit unknown)
endif()
file(CONFIGURE OUTPUT ${OUT} CONTENT "#pragma once\n\n#define STILLCUT_COMMIT \"${commit}\"\n")
