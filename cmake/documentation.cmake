# "cmake --build . --target doc": the reference of the source code, by Doxygen.

find_package(Doxygen QUIET)
if(DOXYGEN_FOUND)
  file(GLOB DOXYGEN_BIB_FILES ${PROJECT_SOURCE_DIR}/doc/*.bib)
  string(REPLACE ";" " " DOXYGEN_BIB_FILES "${DOXYGEN_BIB_FILES}")
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/doc)
  configure_file(${PROJECT_SOURCE_DIR}/doc/Doxyfile.in
    ${PROJECT_BINARY_DIR}/Doxyfile @ONLY)
  add_custom_target(doc
    COMMAND ${DOXYGEN_EXECUTABLE} ${PROJECT_BINARY_DIR}/Doxyfile
    COMMENT "Writing doc/html/index.html in the build folder"
    VERBATIM)
else()
  add_custom_target(doc
    COMMAND ${CMAKE_COMMAND} -E echo "The target doc needs doxygen."
    COMMAND ${CMAKE_COMMAND} -E false
    VERBATIM)
endif()
