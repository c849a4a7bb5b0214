#include "lancer/import/ply/ply.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <sstream>

#include "reading.h"

namespace lancer {
namespace {

using namespace lancer::testing;

struct MeshReading {
    std::optional<scene::TriangleMesh> mesh;
    std::string messages;
};

MeshReading read(std::string_view bytes) {
    Diagnostics diagnostics;
    MeshReading reading{read_ply(bytes, "m.ply", diagnostics), {}};
    for (const Diagnostic& diagnostic : diagnostics.list()) {
        reading.messages += to_string(diagnostic) + "\n";
    }
    return reading;
}

enum class Form { ascii, little, big };

// Writes values of any type in one of the three forms.
class Writer {
public:
    explicit Writer(Form form) : form_(form) {}

    void header(const std::string& elements) {
        const char* names[] = {"ascii", "binary_little_endian", "binary_big_endian"};
        bytes_ += std::string("ply\nformat ") + names[static_cast<int>(form_)] + " 1.0\n" + elements + "end_header\n";
    }

    void value(const std::string& type, double number) {
        if (form_ == Form::ascii) {
            std::ostringstream text;
            text.precision(17);
            text << number << ' ';
            bytes_ += text.str();
        } else if (type == "char" || type == "int8") {
            put(static_cast<std::int8_t>(number));
        } else if (type == "uchar" || type == "uint8") {
            put(static_cast<std::uint8_t>(number));
        } else if (type == "short" || type == "int16") {
            put(static_cast<std::int16_t>(number));
        } else if (type == "ushort" || type == "uint16") {
            put(static_cast<std::uint16_t>(number));
        } else if (type == "int" || type == "int32") {
            put(static_cast<std::int32_t>(number));
        } else if (type == "uint" || type == "uint32") {
            put(static_cast<std::uint32_t>(number));
        } else if (type == "float" || type == "float32") {
            put(static_cast<float>(number));
        } else {
            ASSERT_TRUE(type == "double" || type == "float64") << type;
            put(number);
        }
    }

    void end_line() { bytes_ += form_ == Form::ascii ? "\n" : ""; }
    const std::string& bytes() const { return bytes_; }

private:
    template <class T>
    void put(T number) {
        char bytes[sizeof(T)];
        std::memcpy(bytes, &number, sizeof(T));
        if (form_ == Form::big) {
            std::reverse(bytes, bytes + sizeof(T));
        }
        bytes_.append(bytes, sizeof(T));
    }

    Form form_;
    std::string bytes_;
};

const Form forms[] = {Form::ascii, Form::little, Form::big};
const glm::dvec3 square[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

void expect_square(const MeshReading& r, const std::string& what) {
    ASSERT_TRUE(r.mesh) << what << r.messages;
    ASSERT_EQ(r.mesh->positions.size(), 4u) << what;
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(glm::dvec3(r.mesh->positions[i]), square[i]) << what;
    }
    ASSERT_EQ(r.mesh->triangles.size(), 2u) << what;
    EXPECT_EQ(r.mesh->triangles[0], glm::uvec3(0, 1, 2)) << what;
    EXPECT_EQ(r.mesh->triangles[1], glm::uvec3(0, 2, 3)) << what;
    EXPECT_EQ(r.messages, "") << what;
}

TEST(Ply, ReadsEveryFormAndType) {
    for (Form form : forms) {
        for (const std::string real : {"float", "float32", "double", "float64", "int", "char", "uint8", "short", "uint16"}) {
            for (const std::string whole : {"int", "uint", "int32", "uint32", "uchar", "int8", "ushort", "short"}) {
                Writer w(form);
                w.header("element vertex 4\nproperty " + real + " x\nproperty " + real + " y\nproperty " + real +
                         " z\nelement face 2\nproperty list uchar " + whole + " vertex_indices\n");
                for (const glm::dvec3& p : square) {
                    for (int axis = 0; axis < 3; ++axis) {
                        w.value(real, p[axis]);
                    }
                    w.end_line();
                }
                for (const std::vector<int>& face : {std::vector<int>{0, 1, 2}, {0, 2, 3}}) {
                    w.value("uchar", 3);
                    for (int corner : face) {
                        w.value(whole, corner);
                    }
                    w.end_line();
                }
                expect_square(read(w.bytes()), real + " " + whole + " " + std::to_string(static_cast<int>(form)) + "\n");
            }
        }
    }
}

TEST(Ply, TakesAnyOrderAndSkipsTheRest) {
    for (Form form : forms) {
        Writer w(form);
        w.header(
            "comment made for a test\nobj_info nothing\nelement camera 2\nproperty list ushort double numbers\nproperty char id\n"
            "element face 1\nproperty uchar red\nproperty list int float other\nproperty list ushort ushort vertex_index\nproperty double "
            "weight\n"
            "element empty 1000000000000\n"
            "element vertex 4\nproperty uchar red\nproperty double z\nproperty float v\nproperty float ny\nproperty short x\nproperty "
            "float u\nproperty "
            "float nx\nproperty float y\nproperty float nz\n"
            "element tail 1\nproperty int last\n");
        for (int i = 0; i < 2; ++i) {
            w.value("ushort", 2);
            w.value("double", 1.5);
            w.value("double", 2.5);
            w.value("char", -3);
        }
        w.end_line();
        w.value("uchar", 7);
        w.value("int", 1);
        w.value("float", 0.5);
        w.value("ushort", 4);
        for (int corner : {0, 1, 2, 3}) {
            w.value("ushort", corner);
        }
        w.value("double", 0.25);
        w.end_line();
        for (const glm::dvec3& p : square) {
            w.value("uchar", 255);
            w.value("double", p.z);
            w.value("float", p.y);
            w.value("float", 0);
            w.value("short", p.x);
            w.value("float", p.x);
            w.value("float", 0);
            w.value("float", p.y);
            w.value("float", 2);
            w.end_line();
        }
        w.value("int", 9);
        const MeshReading r = read(w.bytes());
        expect_square(r, std::to_string(static_cast<int>(form)));
        ASSERT_TRUE(r.mesh);
        EXPECT_EQ(r.mesh->uvs.at(2), glm::vec2(1, 1));
        EXPECT_EQ(r.mesh->uvs.at(1), glm::vec2(1, 0));
        EXPECT_EQ(r.mesh->normals.at(3), glm::vec3(0, 0, 1));
    }
}

TEST(Ply, KnowsTheNamesOfTextureCoordinates) {
    for (const auto& [u, v] : {std::pair("s", "t"), {"u", "v"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}}) {
        const MeshReading r = read(
            std::string("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty float ") +
            u + "\nproperty float " + v +
            "\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
            "0 0 0 .25 .5\n1 0 0 0 0\n0 1 0 0 0\n3 0 1 2\n");
        ASSERT_TRUE(r.mesh) << r.messages;
        EXPECT_EQ(r.mesh->uvs.at(0), glm::vec2(0.25, 0.5)) << u;
    }
}

const std::string vertex_properties = "property float x\nproperty float y\nproperty float z\n";
const std::string face_properties = "property list uchar int vertex_indices\n";

std::string ascii(const std::string& elements, const std::string& data) {
    return "ply\nformat ascii 1.0\n" + elements + "end_header\n" + data;
}

TEST(Ply, ReadsColors) {
    const std::string rest = "\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
    const std::string face = "3 0 1 2\n";
    const MeshReading bytes = read(
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha" +
        rest + "0 0 0 255 0 188 51\n1 0 0 0 255 0 255\n0 1 0 0 0 255 255\n" + face);
    ASSERT_TRUE(bytes.mesh) << bytes.messages;
    ASSERT_EQ(bytes.mesh->colors.size(), 3u);
    EXPECT_EQ(bytes.mesh->colors[0].x, 1.0f);
    EXPECT_NEAR(bytes.mesh->colors[0].z, 0.5028865f, 1e-5f) << "bytes are sRGB";
    EXPECT_NEAR(bytes.mesh->colors[0].w, 0.2f, 1e-6f) << "alpha is not";
    const MeshReading floats = read(
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float red\nproperty float green\nproperty float blue\n"
        "property float x\nproperty float y\nproperty float z" +
        rest + "0.5 0 0 0 0 0\n0 2 0 1 0 0\n0 0 1 0 1 0\n" + face);
    ASSERT_TRUE(floats.mesh) << floats.messages;
    EXPECT_EQ(floats.mesh->colors[0], glm::vec4(0.5f, 0.0f, 0.0f, 1.0f)) << "floats are linear";
    EXPECT_EQ(floats.mesh->colors[1].y, 1.0f);
    EXPECT_NE(floats.messages.find("1 values of colors lie outside of 0 to 1"), std::string::npos) << floats.messages;
}

TEST(Ply, CutsLargeFacesAndStrips) {
    const MeshReading concave = read(
        ascii("element vertex 4\n" + vertex_properties + "element face 1\n" + face_properties, "0 0 0\n2 1 0\n0 2 0\n1 1 0\n4 1 2 3 0\n"));
    ASSERT_TRUE(concave.mesh) << concave.messages;
    EXPECT_EQ(concave.mesh->triangles, (std::vector<glm::uvec3>{{1, 2, 3}, {1, 3, 0}}));
    for (Form form : forms) {
        Writer w(form);
        w.header("element vertex 5\n" + vertex_properties + "element tristrips 1\nproperty list int int vertex_indices\n");
        for (int i = 0; i < 5; ++i) {
            w.value("float", i);
            w.value("float", i % 2);
            w.value("float", 0);
        }
        w.value("int", 8);
        for (int corner : {0, 1, 2, 3, -1, 2, 3, 4}) {
            w.value("int", corner);
        }
        const MeshReading r = read(w.bytes());
        ASSERT_TRUE(r.mesh) << r.messages;
        EXPECT_EQ(r.mesh->triangles, (std::vector<glm::uvec3>{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}}));
    }
}

TEST(Ply, TakesUnusualText) {
    const std::string elements = "element vertex 3\n" + vertex_properties + "element face 1\n" + face_properties;
    const std::string plain = ascii(elements, "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    std::string windows, macintosh;
    for (char c : plain) {
        windows += c == '\n' ? "\r\n" : std::string(1, c);
        macintosh += c == '\n' ? '\r' : c;
    }
    for (const std::string& text :
         {plain, windows, macintosh, ascii(elements, "0 0\n0 1 0 0\n\n 0 1 0 3 0\n1 2"),
          ascii("element vertex 3\nproperty  float32\tx \nproperty float y\nproperty float z\nelement face 1\n" + face_properties,
                "+0 -0. 0e0\n1 0 0\n0 1 0\n3 0 1 2\nmore\n")}) {
        const MeshReading r = read(text);
        ASSERT_TRUE(r.mesh) << text << r.messages;
        EXPECT_EQ(r.mesh->triangles.size(), 1u);
    }
}

// The first byte of the data is that of a line's end.
TEST(Ply, DataMayBeginWithTheByteOfALineEnd) {
    for (const std::string& line_end : {std::string("\n"), std::string("\r\n"), std::string("\r")}) {
        for (char first : {'\n', '\r'}) {
            std::string bytes =
                "ply|format binary_little_endian 1.0|element vertex 3|property uchar x|property uchar y|property uchar z|element face 1|"
                "property list uchar uchar vertex_indices|end_header|";
            for (std::size_t at = 0; (at = bytes.find('|', at)) != std::string::npos; at += line_end.size()) {
                bytes.replace(at, 1, line_end);
            }
            bytes += {first, 0, 0, 1, 0, 0, 0, 1, 0, 3, 0, 1, 2};
            const MeshReading r = read(bytes);
            ASSERT_TRUE(r.mesh) << r.messages;
            EXPECT_EQ(r.mesh->positions.at(0).x, static_cast<float>(first));
            EXPECT_EQ(r.mesh->positions.at(1).x, 1.0f);
        }
    }
}

TEST(Ply, ReadsAByteOrderForEveryBlockOfVertices) {
    constexpr int count = 5000;  // more than fit into one block of the reader
    for (const std::string& extra : {std::string(), std::string("property float w\n")}) {
        Writer w(Form::little);
        w.header("element vertex " + std::to_string(count) + "\n" + vertex_properties + extra + "element face " +
                 std::to_string(count - 2) + "\n" + face_properties);
        for (int i = 0; i < count; ++i) {
            w.value("float", i);
            w.value("float", i % 7);
            w.value("float", i * 0.5);
            if (!extra.empty()) {
                w.value("float", 1);
            }
        }
        for (int i = 0; i + 2 < count; ++i) {
            w.value("uchar", 3);
            for (int k = 0; k < 3; ++k) {
                w.value("int", i + k);
            }
        }
        const MeshReading r = read(w.bytes());
        ASSERT_TRUE(r.mesh) << r.messages;
        for (int i = 0; i < count; ++i) {
            ASSERT_EQ(r.mesh->positions[static_cast<std::size_t>(i)], glm::vec3(i, i % 7, 0.5f * static_cast<float>(i)));
        }
    }
}

std::string binary(const std::string& elements, const std::string& data) {
    return "ply\nformat binary_little_endian 1.0\n" + elements + "end_header\n" + data;
}

TEST(Ply, ExplainsMistakes) {
    const std::string three = "element vertex 3\n" + vertex_properties;
    const std::string one_face = "element face 1\n" + face_properties;
    const std::string corners = "0 0 0\n1 0 0\n0 1 0\n";
    const std::string in_bytes(36, '\0');
    const std::string nan_bytes = [] {
        const float nan = std::numeric_limits<float>::quiet_NaN();
        std::string bytes(36, '\0');
        std::memcpy(bytes.data(), &nan, 4);
        return bytes;
    }();
    const struct {
        std::string bytes, message;
    } mistakes[] = {
        {"", ":1:1: error: this is no PLY file: it does not begin with \"ply\"\n"},
        {"plx\n", ":1:1: error: this is no PLY file: it does not begin with \"ply\"\n"},
        {"ply\n", ":1: error: the header has no end_header\n"},
        {"ply\nend_header\n", ":2:1: error: the header has no format\n"},
        {"ply\nformat ascii 1.0\nend_header\n", ":3:1: error: the header has no element \"vertex\"\n"},
        {"ply\nformat text 1.0\nend_header\n",
         ":2:8: error: the format must be ascii, binary_little_endian or binary_big_endian, not \"text\"\n:3:1: error: the header has no "
         "format\n"},
        {"ply\nformat ascii 2.0\nend_header\n", ":2:14: error: the version must be 1.0, not \"2.0\"\n"},
        {"ply\nformat ascii 1.0\nelemnt vertex 3\nend_header\n",
         ":3:1: error: expected format, element, property, comment or end_header, not \"elemnt\"\n"},
        {ascii("element vertex -1\n", ""), ":3:16: error: expected how many \"vertex\" there are, not \"-1\"\n"},
        {ascii("element vertex 3x\n", ""), ":3:16: error: expected how many \"vertex\" there are, not \"3x\"\n"},
        {ascii("property float x\n", ""), ":3:1: error: a property before the first element\n"},
        {ascii("element vertex 1\nproperty real x\n", ""),
         ":4:10: error: unknown type \"real\"; the types are char, uchar, short, ushort, int, uint, float, double and list\n"},
        {ascii("element vertex 1\nproperty list float int x\n", ""), ":4:15: error: the length of a list must have a whole type\n"},
        {ascii("element vertex 1\nproperty float x\nproperty float y\n", ""), ":3:1: error: the vertices need the properties x, y and z\n"},
        {ascii(three + three, ""), ":7:9: error: a second element \"vertex\"\n"},
        {ascii(three + "element face 1\nproperty list uchar float vertex_indices\n", corners + "3 0 1 2\n"),
         ":7:1: error: \"face\" needs a list of whole numbers named vertex_indices or vertex_index\n"},
        {ascii(three, corners), ": error: this mesh has no triangles\n"},
        {ascii(three + one_face, "0 0 0\n1 zero 0\n0 1 0\n3 0 1 2\n"), ":11:3: error: \"y\" needs a finite number, not \"zero\"\n"},
        {ascii(three + one_face, "0 0 nan\n1 0 0\n0 1 0\n3 0 1 2\n"), ":10:5: error: \"z\" needs a finite number, not \"nan\"\n"},
        {ascii(three + one_face, corners + "3 0 1 3\n"), ": error: triangle 0 names vertex 3, but there are 3 vertices, counted from 0\n"},
        {ascii(three + one_face, corners + "4 0 1 2 3\n"), ": error: a face names vertex 3, but there are 3 vertices, counted from 0\n"},
        {ascii(three + one_face, corners + "3 0 1 -1\n"), ":13:9: error: there is no vertex -1\n"},
        {ascii(three + one_face, corners + "3 0 1 1.5\n"), ":13:8: error: a corner must be a whole number, not \"1.5\"\n"},
        {ascii(three + one_face, corners + "3 0 1"), ":13:2: error: a list can't have 3 entries: 4 bytes are left\n"},
        {ascii(three + one_face, "0 0 0\n1 0 0\n0 1 \n\n"), ":14:1: error: the file ends after 2 of 3 \"vertex\" elements\n"},
        {ascii(three + one_face, corners + "-3 0 1 2"), ":13:3: error: a list can't have -3 entries: 6 bytes are left\n"},
        {ascii(three + one_face, corners + "1000000000 0 1 2"), ":13:11: error: a list can't have 1000000000 entries: 6 bytes are left\n"},
        {ascii("element vertex 4000000000\n" + vertex_properties, corners),
         ":3:1: error: 4000000000 \"vertex\" elements do not fit into the 18 bytes that follow\n"},
        {ascii(three + one_face, "0 0 1e20\n1 0 0\n0 1 0\n3 0 1 2\n"),
         ": error: vertex 0 at (0, 0, 1e+20) is out of reach: coordinates must be finite and at most 1e+15 m\n"},
        {binary("element vertex 4000000000\n" + vertex_properties, in_bytes),
         ":3:1: error: 4000000000 \"vertex\" elements need at least 12 bytes each, but only 36 bytes are left\n"},
        {binary("element vertex 18446744073709551615\n" + vertex_properties, in_bytes),
         ":3:1: error: too many vertices: 18446744073709551615\n"},
        {binary("element vertex 18446744073709551616\n" + vertex_properties, in_bytes),
         ":3:16: error: expected how many \"vertex\" there are, not \"18446744073709551616\"\n"},
        {binary(three + "element face 1000000\n" + face_properties, in_bytes + "\3"),
         ":7:1: error: 1000000 \"face\" elements need at least 1 bytes each, but only 1 bytes are left\n"},
        {binary("element vertex 0\n" + vertex_properties, ""), ": error: this mesh has no triangles\n"},
        {binary(three + one_face, in_bytes + "\3"), ": error: the file ends after 0 of 1 \"face\" elements\n"},
        {binary(three + "element face 1\nproperty list int int vertex_indices\n", in_bytes + "\xff\xff\xff\xff"),
         ": error: \"face\" element 0 (counted from 0): a list can't have -1 entries, 0 bytes are left\n"},
        {binary(three + "element face 1\nproperty list uint int vertex_indices\n", in_bytes + "\xff\xff\xff\xff"),
         ": error: \"face\" element 0 (counted from 0): a list can't have 4294967295 entries, 0 bytes are left\n"},
        {binary(three + one_face, nan_bytes + std::string("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13)),
         ": error: vertex 0 at (nan, 0, 0) is out of reach: coordinates must be finite and at most 1e+15 m\n"},
        {binary(three + one_face, in_bytes + std::string("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13)),
         ": warning: 1 of 1 triangles have no area and are left out\nm.ply: error: this mesh has no triangle with an area\n"},
    };
    for (const auto& mistake : mistakes) {
        const MeshReading r = read(mistake.bytes);
        EXPECT_FALSE(r.mesh) << mistake.bytes;
        std::string expected = mistake.message;
        for (std::size_t at = 0; at < expected.size(); at = expected.find('\n', at) + 1) {
            if (expected[at] == ':') {
                expected.insert(at, "m.ply");
            }
        }
        EXPECT_EQ(r.messages, expected) << mistake.bytes;
    }
}

TEST(Ply, LeavesOutSmallFaces) {
    const MeshReading r = read(
        ascii("element vertex 3\n" + vertex_properties + "element face 3\n" + face_properties, "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n2 0 1\n0\n"));
    ASSERT_TRUE(r.mesh);
    EXPECT_EQ(r.mesh->triangles.size(), 1u);
    EXPECT_EQ(r.messages, "m.ply: warning: 2 faces with less than three corners are left out\n");
}

// Every beginning of a good file is refused or read, never more than its bytes.
TEST(Ply, CutFilesAreRefused) {
    for (Form form : forms) {
        Writer w(form);
        w.header("element vertex 4\n" + vertex_properties + "element face 2\n" + face_properties);
        for (const glm::dvec3& p : square) {
            for (int axis = 0; axis < 3; ++axis) {
                w.value("float", p[axis]);
            }
        }
        for (double number : {3.0, 0.0, 1.0, 2.0}) {
            w.value(number == 3.0 ? "uchar" : "int", number);
        }
        w.value("uchar", 4);
        for (int corner : {0, 1, 2, 3}) {
            w.value("int", corner);
        }
        const std::string& whole = w.bytes();
        ASSERT_TRUE(read(whole).mesh);
        const std::size_t needed = form == Form::ascii ? whole.size() - 1 : whole.size();  // the last blank of the text says nothing
        for (std::size_t size = 0; size < needed; ++size) {
            const std::string part = whole.substr(0, size);  // a copy of its own, so that sanitizers see the end
            EXPECT_FALSE(read(part).mesh) << size;
        }
    }
}

}  // namespace
}  // namespace lancer
