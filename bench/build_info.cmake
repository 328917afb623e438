cmake_minimum_required(VERSION 3.25)

# Writes OUTPUT, a header with the version, the sources' git commit and the compiler, whenever their values change.
# Runs at every build: cmake -D SOURCE=… -D OUTPUT=… -D VERSION=… -D COMPILER=… -D BUILD_TYPE=… -D FLAGS=… -P build_info.cmake
set(hash unknown)
set(released "$Format:%H$")  # git archive writes the commit here (.gitattributes)
set(dirty 0)
set(dirty_hash "")
find_package(Git QUIET)
if(NOT released MATCHES Format)
  set(hash ${released})
elseif(GIT_FOUND)
  execute_process(COMMAND ${GIT_EXECUTABLE} -C ${SOURCE} rev-parse HEAD
                  OUTPUT_VARIABLE found OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE failed ERROR_QUIET)
  if(NOT failed)
    set(hash ${found})
    execute_process(COMMAND ${GIT_EXECUTABLE} -C ${SOURCE} status --porcelain --untracked-files=no
                    OUTPUT_VARIABLE changes ERROR_QUIET)
    if(NOT "${changes}" STREQUAL "")
      set(dirty 1)
      execute_process(COMMAND ${GIT_EXECUTABLE} -C ${SOURCE} diff HEAD OUTPUT_VARIABLE changes ERROR_QUIET)
      string(SHA256 dirty_hash "${changes}")
    endif()
  endif()
endif()
string(STRIP "${FLAGS}" FLAGS)
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "#pragma once
#define AR3D_VERSION \"@VERSION@\"
#define AR3D_SOURCE_HASH \"@hash@\"
#define AR3D_SOURCE_DIRTY @dirty@
#define AR3D_DIRTY_HASH \"@dirty_hash@\"
#define AR3D_COMPILER \"@COMPILER@\"
#define AR3D_BUILD_TYPE \"@BUILD_TYPE@\"
#define AR3D_FLAGS \"@FLAGS@\"
" @ONLY)
