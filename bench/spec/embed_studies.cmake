# Writes ar3d_named_studies.h: every bench/studies/*.toml as a row of the catalogue of named studies, its text byte for byte.
# Included by bench/CMakeLists.txt; a changed or new file configures again.
file(GLOB study_files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/bench/studies/*.toml)
set(study_rows "")
foreach(study_file IN LISTS study_files)
  get_filename_component(study_name ${study_file} NAME_WE)
  file(READ ${study_file} study_text)
  ar3d_text_literal(${study_file} study_literal)
  if(NOT study_text MATCHES "\nstudy = \"${study_name}\"\n" AND NOT study_text MATCHES "^study = \"${study_name}\"\n")
    message(FATAL_ERROR "${study_file}: its line `study = \"${study_name}\"` is missing")
  endif()
  string(REGEX MATCH "\ndescription = \"([^\"\n]*)\"" study_description "${study_text}")
  set(study_description "${CMAKE_MATCH_1}")
  string(APPEND study_rows
    "    {\"${study_name}\", R\"text(${study_description})text\", ${study_literal}},\n")
endforeach()
file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/ar3d_named_studies.h @ONLY CONTENT
"// Made from bench/studies/*.toml by bench/spec/embed_studies.cmake.
namespace ar3d {
inline constexpr NamedStudy kNamedStudies[] = {
@study_rows@};
}  // namespace ar3d
")
