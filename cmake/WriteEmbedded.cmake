# cmake -DFILES=... -DFOLDER=... -DOUTPUT=... -P WriteEmbedded.cmake: a C++ source that carries files. The assembler copies their bytes; arrays
# of numbers would take the compiler many seconds.
set(data "")
set(names "")
set(table "")
set(number 0)
foreach(file IN LISTS FILES)
    set(name lancer_embedded_${number})
    string(APPEND data "    \".global ${name}\\n.hidden ${name}\\n${name}:\\n.incbin \\\"${FOLDER}/${file}\\\"\\n\"
    \".global ${name}_end\\n.hidden ${name}_end\\n${name}_end:\\n.byte 0\\n\"\n")
    string(APPEND names "extern __attribute__((visibility(\"hidden\"))) const char ${name}[];
extern __attribute__((visibility(\"hidden\"))) const char ${name}_end[];\n")
    string(APPEND table "        {\"${file}\", {${name}, static_cast<std::size_t>(${name}_end - ${name})}},\n")
    math(EXPR number "${number} + 1")
endforeach()
file(WRITE ${OUTPUT} "#include \"lancer/app/embedded_scenes.h\"

#include <cstddef>

asm(\".pushsection .rodata\\n\"
${data}    \".popsection\\n\");

extern \"C\" {
${names}}

namespace lancer::app {

std::span<const EmbeddedFile> embedded_scenes() {
    static const EmbeddedFile files[] = {
${table}    };
    return files;
}

}  // namespace lancer::app
")
