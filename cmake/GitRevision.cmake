# Writes the header OUTPUT with the commit of SOURCE_DIR and whether the sources differ from it. Run at every build:
#     cmake -D SOURCE_DIR=… -D OUTPUT=… -P GitRevision.cmake
# The header is written only when its content changes, so that nothing is compiled again in vain.
# Without git, or where SOURCE_DIR is not itself a checkout, the commit is "unknown".
set(commit "unknown")
set(dirty false)
find_program(git_program git)
if(git_program)
  set(git ${git_program} -c safe.directory=${SOURCE_DIR} -C ${SOURCE_DIR})
  execute_process(COMMAND ${git} rev-parse --show-prefix OUTPUT_VARIABLE prefix RESULT_VARIABLE not_in_git
                  OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  execute_process(COMMAND ${git} rev-parse HEAD OUTPUT_VARIABLE head RESULT_VARIABLE no_head
                  OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(NOT not_in_git AND NOT no_head AND "${prefix}" STREQUAL "")
    set(commit ${head})
    execute_process(COMMAND ${git} status --porcelain --untracked-files=no OUTPUT_VARIABLE changes ERROR_QUIET)
    if(NOT "${changes}" STREQUAL "")
      set(dirty true)
    endif()
  endif()
endif()

set(content "#pragma once
#define RAYGAUGE_GIT_COMMIT \"${commit}\"
#define RAYGAUGE_GIT_DIRTY ${dirty}
")
set(previous "")
if(EXISTS ${OUTPUT})
  file(READ ${OUTPUT} previous)
endif()
if(NOT previous STREQUAL content)
  file(WRITE ${OUTPUT} "${content}")
endif()
