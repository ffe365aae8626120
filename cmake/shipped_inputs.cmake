# Links to the shipped inputs in the build folder, so that
# "./mpm_granular wall.prm" works there. Mesh files are named relative to the
# folder of the .prm file (meshes/wall.msh), hence the link to the meshes.

function(link_into_build_folder file)
  get_filename_component(name ${file} NAME)
  execute_process(COMMAND ${CMAKE_COMMAND} -E create_symlink
    ${file} ${PROJECT_BINARY_DIR}/${name})
endfunction()

file(GLOB shipped_inputs ${PROJECT_SOURCE_DIR}/prm/*.prm)
foreach(file ${shipped_inputs} ${PROJECT_SOURCE_DIR}/prm
    ${PROJECT_SOURCE_DIR}/prm/meshes)
  link_into_build_folder(${file})
endforeach()
