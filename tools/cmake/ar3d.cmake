# Headers are included as "ar3d/<folder>/<header>.h", in the tree (by the committed link include/ar3d to its top, which
# editors and other tools find, too) as after installation, where nothing else may be called "model/graph.h".
set(AR3D_INCLUDE_ROOT ${PROJECT_SOURCE_DIR}/include)

# Flags of every target of ours, not of the consumers of the installed package.
add_library(ar3d_flags INTERFACE)
target_compile_options(ar3d_flags INTERFACE -Wall -Wextra -Wpedantic -Wconversion
                       # A source that a unit includes (ar3d_together) is taken for a header.
                       $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>
                       $<$<BOOL:${AR3D_WERROR}>:-Werror>
                       # "a" + std::string() is taken for an overlapping copy by g++ 12 at -O3 (GCC bug 105651).
                       $<$<AND:$<BOOL:${AR3D_WERROR}>,$<CXX_COMPILER_ID:GNU>>:-Wno-error=restrict>
                       # <regex> is taken for using what was never set with -fsanitize=address (GCC bug 105562).
                       $<$<AND:$<BOOL:${AR3D_WERROR}>,$<CXX_COMPILER_ID:GNU>>:-Wno-error=maybe-uninitialized>)
target_compile_definitions(ar3d_flags INTERFACE $<$<BOOL:${AR3D_CHECKS}>:AR3D_CHECKS=1>)

# Floating-point arithmetic rounds every operation once, in its own type: no -ffast-math, no fused multiply-add, no x87.
set(AR3D_ROUNDED_ONCE -ffp-contract=off -fno-fast-math)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  list(APPEND AR3D_ROUNDED_ONCE -msse2 -mfpmath=sse)
endif()

# ar3d_together(<target> <most> <sources...>): the sources of one folder are compiled together, up to <most> at a time, since most
# of a compiler's time goes into the same headers and templates again and again. So names in anonymous namespaces are unique
# within a folder and its namespace. A source with options of its own, or in AR3D_ALONE, is compiled alone.
set(AR3D_ALONE apps/one_rank.cpp  # linked only where nothing else defines join_ranks()
    verify/predicates/widths.cpp verify/crossings/crossings.cpp)
option(AR3D_TOGETHER "Compile the sources of a folder together" ON)
function(ar3d_together target most)
  set(group 0)
  if(NOT AR3D_TOGETHER)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  set(former "")
  foreach(source IN LISTS ARGN)
    get_filename_component(folder ${source} DIRECTORY)
    if(NOT folder STREQUAL former)
      set(former ${folder})
      set(count 0)
      math(EXPR group "${group} + 1")
    elseif(count EQUAL most)
      set(count 0)
      math(EXPR group "${group} + 1")
    endif()
    math(EXPR count "${count} + 1")
    cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE name)
    if(name IN_LIST AR3D_ALONE)
      set_property(SOURCE ${source} PROPERTY SKIP_UNITY_BUILD_INCLUSION ON)
    else()
      set_property(SOURCE ${source} PROPERTY UNITY_GROUP g${group})
    endif()
  endforeach()
endfunction()

# ar3d_glue(<target>): code that nothing waits for, compiled in two thirds of the time. Precompiled headers saved 5 % at most.
function(ar3d_glue target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# ar3d_library(<folder> [PUBLIC targets...] [PRIVATE targets...]): one static library a folder, made of
# every .cpp below it; exported as ar3d::<folder>.
function(ar3d_library folder)
  cmake_parse_arguments(ARG "" "" "PUBLIC;PRIVATE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/kernels/|/fuzz/")
  add_library(ar3d_${folder} STATIC ${sources})
  ar3d_together(ar3d_${folder} 10 ${sources})
  add_library(ar3d::${folder} ALIAS ar3d_${folder})
  set_target_properties(ar3d_${folder} PROPERTIES EXPORT_NAME ${folder} POSITION_INDEPENDENT_CODE ON)
  target_include_directories(ar3d_${folder} PUBLIC
    $<BUILD_INTERFACE:${AR3D_INCLUDE_ROOT}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(ar3d_${folder} PUBLIC cxx_std_20)
  target_link_libraries(ar3d_${folder} PUBLIC ${ARG_PUBLIC}
                        PRIVATE ${ARG_PRIVATE} $<BUILD_INTERFACE:ar3d_flags>)
  set_property(GLOBAL APPEND PROPERTY AR3D_LIBRARIES ar3d_${folder})
endfunction()
