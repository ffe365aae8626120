# The header mpm_granular/core/version.h in the build folder. It is written
# again when the commit or any source file changes (mpm_granular_version is
# given the list of sources by source/CMakeLists.txt), so that the hash and the
# "-dirty" mark belong to the program that is being built.

set(version_header ${PROJECT_BINARY_DIR}/include/mpm_granular/core/version.h)

function(write_version_header)
  set(commit_files)
  foreach(name HEAD logs/HEAD)
    execute_process(
      COMMAND git -c safe.directory=* -C ${PROJECT_SOURCE_DIR}
        rev-parse --git-path ${name}
      OUTPUT_VARIABLE file OUTPUT_STRIP_TRAILING_WHITESPACE
      ERROR_QUIET RESULT_VARIABLE failed)
    get_filename_component(file "${file}" ABSOLUTE BASE_DIR ${PROJECT_SOURCE_DIR})
    if(NOT failed AND EXISTS ${file})
      list(APPEND commit_files ${file})
    endif()
  endforeach()

  set(stamp ${PROJECT_BINARY_DIR}/include/version.stamp)
  add_custom_command(OUTPUT ${stamp}
    BYPRODUCTS ${version_header}
    COMMAND ${CMAKE_COMMAND}
      -D SOURCE=${PROJECT_SOURCE_DIR}
      -D OUTPUT=${version_header}
      -D VERSION=${PROJECT_VERSION}
      -D "COMPILER=${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}"
      -D BUILD_TYPE=${CMAKE_BUILD_TYPE}
      -P ${PROJECT_SOURCE_DIR}/cmake/write_version.cmake
    COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
    DEPENDS ${ARGN} ${commit_files}
      ${PROJECT_SOURCE_DIR}/cmake/version.h.in
      ${PROJECT_SOURCE_DIR}/cmake/write_version.cmake
    COMMENT "Checking the commit"
    VERBATIM)
  add_custom_target(mpm_granular_version DEPENDS ${stamp})
endfunction()
