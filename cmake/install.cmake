# "cmake --install build/release --prefix DIR": the program, the shipped inputs
# with their meshes, the scripts, the benchmarks and the documentation.

include(GNUInstallDirs)

install(TARGETS mpm_granular RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY prm DESTINATION ${CMAKE_INSTALL_DATADIR}/mpm_granular
  FILES_MATCHING
    PATTERN "*.prm" PATTERN "*.msh" PATTERN "*.geo" PATTERN "*.md")
install(DIRECTORY scripts DESTINATION ${CMAKE_INSTALL_DATADIR}/mpm_granular
  USE_SOURCE_PERMISSIONS
  FILES_MATCHING PATTERN "*.py" PATTERN "*.sh")
install(DIRECTORY benchmarks DESTINATION ${CMAKE_INSTALL_DATADIR}/mpm_granular
  USE_SOURCE_PERMISSIONS
  FILES_MATCHING PATTERN "verify" PATTERN "*.py" PATTERN "*.toml")
install(DIRECTORY doc/ DESTINATION ${CMAKE_INSTALL_DOCDIR}
  FILES_MATCHING PATTERN "*.md" PATTERN "*.bib" PATTERN "*.png")
install(FILES README.md LICENSE CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})
