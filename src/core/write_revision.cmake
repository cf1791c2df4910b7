# Writes revision.h. Runs in every build, so that the revision is that of the sources being compiled and not that of
# the day CMake was configured; the file is touched only when its text changes, so nothing is rebuilt in vain.
#   cmake -DSOURCE_DIR=... -DOUTPUT=... -DVERSION=... -DCOMPILER=... -P write_revision.cmake
find_program(GIT git)
set(revision "")
if(GIT)
  # The enclosing repository counts only if it is Runout's own, not one that a source archive was unpacked in.
  execute_process(COMMAND ${GIT} rev-parse --show-prefix WORKING_DIRECTORY ${SOURCE_DIR}
                  OUTPUT_VARIABLE prefix RESULT_VARIABLE outside OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(outside EQUAL 0 AND prefix STREQUAL "")
    execute_process(COMMAND ${GIT} describe --always --dirty --abbrev=12 --exclude=* WORKING_DIRECTORY ${SOURCE_DIR}
                    OUTPUT_VARIABLE revision OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  endif()
endif()
if(revision STREQUAL "")
  set(revision "unknown")
endif()

set(text "#pragma once

namespace runout::build {

inline constexpr const char* version = \"${VERSION}\";
inline constexpr const char* revision = \"${revision}\";
inline constexpr const char* compiler = \"${COMPILER}\";

}  // namespace runout::build
")
if(EXISTS ${OUTPUT})
  file(READ ${OUTPUT} old)
endif()
if(NOT "${old}" STREQUAL "${text}")
  file(WRITE ${OUTPUT} "${text}")
endif()
