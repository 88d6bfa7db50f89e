# Writes OUTPUT, a C++ file that defines the texts of page_text.h from FILES (separated by |): the one .html, the one .css, and
# the .js files joined in the order given.
string(REPLACE "|" ";" FILES "${FILES}")
set(html "")
set(css "")
set(js "")
foreach(file IN LISTS FILES)
  file(READ "${file}" text)
  string(FIND "${text}" ")page\"" end_marker)
  if(NOT end_marker EQUAL -1)
    message(FATAL_ERROR "${file} contains )page\", which ends the raw string that it is embedded in; write it differently")
  endif()
  get_filename_component(kind "${file}" LAST_EXT)
  string(SUBSTRING "${kind}" 1 -1 kind)
  string(APPEND ${kind} "${text}")
endforeach()
file(WRITE "${OUTPUT}" "#include \"cli/report/page_text.h\"

namespace reprise {

const char* const kPageHtml = R\"page(${html})page\";
const char* const kPageCss = R\"page(${css})page\";
const char* const kPageJs = R\"page(${js})page\";

}  // namespace reprise
")
