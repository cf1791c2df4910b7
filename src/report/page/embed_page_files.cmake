# Writes page_files.cpp: what reports are made of as arrays, since compilers need not take string literals this long.
# Called with OUTPUT and, for each function of report/page/page_files.h, its file.
set(text "#include \"report/page/page_files.h\"\n\nnamespace runout::page_file {\n")
foreach(name charting_library style charts animation travel_angles)
  file(READ ${${name}} content)
  string(FIND "${content}" "</script" found)
  if(NOT found EQUAL -1)
    message(FATAL_ERROR "${${name}} would end the script element that it is put into")
  endif()
  file(READ ${${name}} bytes HEX)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
  string(APPEND text "\nstd::string_view ${name}() {\n    static constexpr unsigned char bytes[] = {${bytes}};\n"
                     "    return {reinterpret_cast<const char*>(bytes), sizeof bytes};\n}\n")
endforeach()
string(APPEND text "\n}  // namespace runout::page_file\n")
file(WRITE ${OUTPUT} "${text}")
