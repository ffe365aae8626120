# cmake -D SOURCE=... -D OUTPUT=... -D VERSION=... -D COMPILER=... -D BUILD_TYPE=...
#       -P write_version.cmake
# Writes the header with the version and the commit; leaves it untouched if
# nothing changed. safe.directory: also when the repository belongs to another
# user (containers).

set(git git -c safe.directory=* -C ${SOURCE})
execute_process(COMMAND ${git} rev-parse --show-toplevel
  OUTPUT_VARIABLE top OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
execute_process(COMMAND ${git} rev-parse --verify HEAD RESULT_VARIABLE failed
  OUTPUT_VARIABLE GIT_HASH OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
execute_process(COMMAND ${git} status --porcelain --untracked-files=no
  OUTPUT_VARIABLE changes ERROR_QUIET)

get_filename_component(real_source "${SOURCE}" REALPATH)
set(GIT_DIRTY false)
if(failed OR NOT "${top}" STREQUAL "${real_source}")
  set(GIT_HASH unknown)
elseif(NOT "${changes}" STREQUAL "")
  set(GIT_DIRTY true)
  string(APPEND GIT_HASH -dirty)
endif()

configure_file(${CMAKE_CURRENT_LIST_DIR}/version.h.in ${OUTPUT} @ONLY)
