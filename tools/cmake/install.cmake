# Components program, mpi, dev and python are packages (packages.cmake); `cmake --install` without one installs all.
include(CMakePackageConfigHelpers)
get_property(libraries GLOBAL PROPERTY AR3D_LIBRARIES)
install(TARGETS ${libraries} EXPORT ar3dTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev)
install(TARGETS ar3d_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
install(FILES ${PROJECT_SOURCE_DIR}/python/ar3d/figures.py DESTINATION ${CMAKE_INSTALL_DATADIR}/ar3d COMPONENT program)  # to read and change
install(FILES ${PROJECT_SOURCE_DIR}/build/playground/play.html DESTINATION ${CMAKE_INSTALL_DATADIR}/ar3d COMPONENT program OPTIONAL)  # where tools/playground made it
install(DIRECTORY ${PROJECT_SOURCE_DIR}/bench/studies DESTINATION ${CMAKE_INSTALL_DATADIR}/ar3d COMPONENT program)  # to copy and change
if(AR3D_MPI)
  install(TARGETS ar3d_mpi RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT mpi OPTIONAL)  # where it was built
endif()
foreach(folder IN ITEMS base model formats generators algorithms verify optimum store bench analysis)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ar3d COMPONENT dev
          FILES_MATCHING PATTERN "*.h")
endforeach()
install(FILES ${PROJECT_SOURCE_DIR}/apps/program.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ar3d/apps COMPONENT dev)
install(EXPORT ar3dTargets NAMESPACE ar3d:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/ar3d COMPONENT dev)
configure_package_config_file(tools/cmake/ar3dConfig.cmake.in ${PROJECT_BINARY_DIR}/ar3dConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/ar3d)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/ar3dConfigVersion.cmake
  COMPATIBILITY SameMajorVersion)
install(FILES ${PROJECT_BINARY_DIR}/ar3dConfig.cmake ${PROJECT_BINARY_DIR}/ar3dConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/ar3d COMPONENT dev)
file(RELATIVE_PATH up /p/${CMAKE_INSTALL_LIBDIR}/pkgconfig /p)
configure_file(tools/cmake/ar3d.pc.in ${PROJECT_BINARY_DIR}/ar3d.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/ar3d.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT dev)

# The man page is made of what the installed program says of itself.
install(CODE "
  set(man_folder \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_MANDIR}/man1\")
  file(MAKE_DIRECTORY \"\${man_folder}\")
  message(STATUS \"Installing: \${man_folder}/ar3d.1\")
  execute_process(COMMAND ${PROJECT_SOURCE_DIR}/tools/man-page \"$<TARGET_FILE:ar3d_program>\"
                  OUTPUT_FILE \"\${man_folder}/ar3d.1\" COMMAND_ERROR_IS_FATAL ANY)
  if(CMAKE_INSTALL_COMPONENT)  # a package
    execute_process(COMMAND gzip -9nf \"\${man_folder}/ar3d.1\" COMMAND_ERROR_IS_FATAL ANY)
  endif()" COMPONENT program)

# So is the completion of each shell.
function(ar3d_install_completion shell folder name)
  install(CODE "
    set(folder \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR}/${folder}\")
    file(MAKE_DIRECTORY \"\${folder}\")
    message(STATUS \"Installing: \${folder}/${name}\")
    execute_process(COMMAND ${PROJECT_SOURCE_DIR}/tools/completion \"$<TARGET_FILE:ar3d_program>\" ${shell}
                    OUTPUT_FILE \"\${folder}/${name}\" COMMAND_ERROR_IS_FATAL ANY)" COMPONENT program)
endfunction()
ar3d_install_completion(bash bash-completion/completions ar3d)
ar3d_install_completion(zsh zsh/site-functions _ar3d)
ar3d_install_completion(fish fish/vendor_completions.d ar3d.fish)
if(NOT SKBUILD)
  include(tools/cmake/packages.cmake)
endif()
