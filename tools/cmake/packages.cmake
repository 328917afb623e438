# Debian packages, one a component, by CPack (tools/release): ar3d, ar3d-mpi, libar3d-dev, python3-ar3d.
set(AR3D_MAINTAINER "The ar3d authors <ar3d@example.org>" CACHE STRING "Whom the packages name")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT ${AR3D_MAINTAINER})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL program dev)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)  # SOURCE_DATE_EPOCH, where it is set

# What lies beside each package; installed by its component alone.
function(ar3d_package component name section depends summary description)
  string(TOUPPER ${component} upper)
  foreach(field IN ITEMS NAME SECTION DEPENDS)
    string(TOLOWER ${field} value)
    set(CPACK_DEBIAN_${upper}_PACKAGE_${field} "${${value}}" PARENT_SCOPE)
  endforeach()
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${summary}\n${description}" PARENT_SCOPE)
  set(changelog ${PROJECT_BINARY_DIR}/changelog-${name})
  file(WRITE ${changelog} "${name} (${PROJECT_VERSION}) unstable; urgency=medium\n\n  * See CHANGELOG.md of the sources.\n\n"
       " -- ${AR3D_MAINTAINER}  ${date}\n")
  execute_process(COMMAND gzip -9nf ${changelog} COMMAND_ERROR_IS_FATAL ANY)
  set(folder ${CMAKE_INSTALL_DATADIR}/doc/${name})
  install(FILES ${changelog}.gz RENAME changelog.gz DESTINATION ${folder} COMPONENT ${component} EXCLUDE_FROM_ALL)
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE RENAME copyright DESTINATION ${folder} COMPONENT ${component} EXCLUDE_FROM_ALL)
endfunction()

ar3d_package(program ar3d science "" "proved 3D drawings of low-degree graphs with optimal angles"
  "Draws graphs of maximum degree 3 and 4 in three dimensions with the best\npossible angles, proves drawings right in exact integers and studies how\ndrawings scale.")
if(CADICAL_LIBRARY)
  set(cadical "libcadical-dev, ")
endif()
ar3d_package(dev libar3d-dev libdevel
  "${cadical}libboost-dev, libcli11-dev, libfmt-dev, libhdf5-dev, liblzma-dev, libpugixml-dev, libtomlplusplus-dev, libxxhash-dev, nlohmann-json3-dev, pkg-config, zlib1g-dev"
  "proved 3D drawings of low-degree graphs (C++ libraries)"
  "Static libraries, headers and files for CMake and pkg-config: graphs,\nalgorithms, formats and the verifier of ar3d.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "git, nauty, python3-matplotlib")  # python3-matplotlib: ar3d figures
if(AR3D_MPI)
  list(APPEND CPACK_COMPONENTS_ALL mpi)
  file(WRITE ${PROJECT_BINARY_DIR}/ar3d-mpi.1 ".so man1/ar3d.1\n")
  execute_process(COMMAND gzip -9nf ${PROJECT_BINARY_DIR}/ar3d-mpi.1 COMMAND_ERROR_IS_FATAL ANY)
  install(FILES ${PROJECT_BINARY_DIR}/ar3d-mpi.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT mpi EXCLUDE_FROM_ALL)
  ar3d_package(mpi ar3d-mpi science "ar3d (= ${PROJECT_VERSION}), openmpi-bin" "proved 3D drawings of low-degree graphs (for mpirun)"
    "The program ar3d for studies on many ranks: mpirun ar3d-mpi study run STUDY.")
endif()
if(AR3D_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
  math(EXPR after "${Python_VERSION_MINOR} + 1")
  ar3d_package(python python3-ar3d python
    "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${after}), python3-numpy" "proved 3D drawings of low-degree graphs (Python)"
    "Draws and proves graphs of networkx, numpy and scipy; reads results of studies\ninto pandas.")
  # Python's byte code comes and goes with the package.
  set(control ${PROJECT_BINARY_DIR}/python-control)
  file(WRITE ${control}/postinst "#!/bin/sh\nset -e\n[ \"$1\" != configure ] || py3compile -p python3-ar3d\n")
  file(WRITE ${control}/prerm "#!/bin/sh\nset -e\npy3clean -p python3-ar3d\n")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${control}/postinst ${control}/prerm)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_STRICT_PERMISSION ON)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-h5py, python3-matplotlib, python3-pandas")
endif()
include(CPack)
