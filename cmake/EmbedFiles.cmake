# Writes FILES as C++ strings to PLACE/NAME.cpp and declares FUNCTION, which finds them, and FUNCTIONNames in
# PLACE/NAME.h.
set(cases "")
set(names "")
foreach(file IN LISTS FILES)
  file(READ ${file} text)
  get_filename_component(file_name ${file} NAME)
  string(APPEND cases "    if (fileName == \"${file_name}\") return R\"embedded(${text})embedded\";\n")
  string(APPEND names "\n    \"${file_name}\",")
endforeach()
file(WRITE ${PLACE}/${NAME}.h "#pragma once\n\n#include <span>\n#include <string_view>\n\nnamespace rubble {\n
std::string_view ${FUNCTION}(std::string_view fileName);
std::span<const std::string_view> ${FUNCTION}Names();\n\n}  // namespace rubble\n")
file(WRITE ${PLACE}/${NAME}.cpp "#include \"${NAME}.h\"\n\nnamespace rubble {\n
std::string_view ${FUNCTION}(std::string_view fileName) {\n${cases}    return {};\n}\n
std::span<const std::string_view> ${FUNCTION}Names() {
    static constexpr std::string_view kNames[] = {${names}};
    return kNames;\n}\n\n}  // namespace rubble\n")
