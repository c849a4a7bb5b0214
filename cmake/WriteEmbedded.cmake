# cmake -DFILES=... -DFOLDER=... -DOUTPUT=... -P WriteEmbedded.cmake: files as arrays of bytes in a C++ source.
set(arrays "")
set(table "")
set(number 0)
foreach(file IN LISTS FILES)
    file(READ ${FOLDER}/${file} hex HEX)
    string(REGEX REPLACE "(..)" "'\\\\x\\1'," bytes "${hex}")
    string(APPEND arrays "const char bytes_${number}[] = {${bytes}'\\0'};\n")
    string(APPEND table "    {\"${file}\", {bytes_${number}, sizeof(bytes_${number}) - 1}},\n")
    math(EXPR number "${number} + 1")
endforeach()
file(WRITE ${OUTPUT} "#include \"lancer/app/embedded_scenes.h\"

namespace lancer::app {

namespace {

${arrays}
const EmbeddedFile files[] = {
${table}};

}  // namespace

std::span<const EmbeddedFile> embedded_scenes() { return files; }

}  // namespace lancer::app
")
