# Writes FILES as C++ strings to PLACE/NAME.cpp and declares FUNCTION, which finds them, in PLACE/NAME.h.
set(cases "")
foreach(file IN LISTS FILES)
  file(READ ${file} text)
  get_filename_component(file_name ${file} NAME)
  string(APPEND cases "    if (fileName == \"${file_name}\") return R\"embedded(${text})embedded\";\n")
endforeach()
file(WRITE ${PLACE}/${NAME}.h "#pragma once\n\n#include <string_view>\n\nnamespace rubble {\n
std::string_view ${FUNCTION}(std::string_view fileName);\n\n}  // namespace rubble\n")
file(WRITE ${PLACE}/${NAME}.cpp "#include \"${NAME}.h\"\n\nnamespace rubble {\n
std::string_view ${FUNCTION}(std::string_view fileName) {\n${cases}    return {};\n}\n\n}  // namespace rubble\n")
