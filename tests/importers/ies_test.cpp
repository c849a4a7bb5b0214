// Photometric files.
#include "lancer/import/ies/ies.h"

#include "reading.h"

namespace lancer {
namespace {

struct Ies {
    std::optional<scene::Photometry> photometry;
    std::string messages;
};

Ies read(const std::string& text) {
    Diagnostics diagnostics;
    Ies result{read_ies(text, "lamp.ies", diagnostics), ""};
    for (const Diagnostic& diagnostic : diagnostics.list()) {
        result.messages += to_string(diagnostic) + "\n";
    }
    return result;
}

const std::string head = "IESNA:LM-63-2002\n[TEST] none\nTILT=NONE\n";

TEST(Ies, ReadsAnglesAndMultipliesFactors) {
    const Ies ies = read(head + "1 1000 2 3 1 1 1 0 0 0\n0.5 1 60\n0 45 90\n0\n10 20.5 3e1\n");
    ASSERT_TRUE(ies.photometry) << ies.messages;
    EXPECT_EQ(ies.photometry->vertical, (std::vector<double>{0, 45, 90}));
    EXPECT_EQ(ies.photometry->horizontal, (std::vector<double>{0}));
    EXPECT_EQ(ies.photometry->candela, (std::vector<double>{10, 20.5, 30}));
    EXPECT_EQ(ies.messages, "");
}

TEST(Ies, TakesCommasAndAnyLines) {
    const Ies ies = read("anything\r\nTILT=NONE\r\n1,1000,1,2,\r\n1,1,1,0,0,0 1 1\r\n60 0 90 0 +7,8");
    ASSERT_TRUE(ies.photometry) << ies.messages;
    EXPECT_EQ(ies.photometry->candela, (std::vector<double>{7, 8}));
}

TEST(Ies, UnfoldsSymmetry) {
    const Ies quarter = read(head + "1 1 1 2 3 1 1 0 0 0\n1 1 1\n0 90\n0 30 90\n1 1 2 2 3 3\n");
    ASSERT_TRUE(quarter.photometry) << quarter.messages;
    EXPECT_EQ(quarter.photometry->horizontal, (std::vector<double>{0, 30, 90, 150, 180, 210, 270, 330, 360}));
    EXPECT_EQ(quarter.photometry->candela, (std::vector<double>{1, 1, 2, 2, 3, 3, 2, 2, 1, 1, 2, 2, 3, 3, 2, 2, 1, 1}));
    const Ies half = read(head + "1 1 1 2 3 1 1 0 0 0\n1 1 1\n0 90\n0 60 180\n1 1 2 2 3 3\n");
    ASSERT_TRUE(half.photometry) << half.messages;
    EXPECT_EQ(half.photometry->horizontal, (std::vector<double>{0, 60, 180, 300, 360}));
    // Like on both sides of the plane from 90 to 270.
    const Ies turned = read(head + "1 1 1 2 3 1 1 0 0 0\n1 1 1\n0 90\n90 180 270\n1 1 2 2 3 3\n");
    ASSERT_TRUE(turned.photometry) << turned.messages;
    EXPECT_EQ(turned.photometry->horizontal, (std::vector<double>{0, 90, 180, 270, 360}));
    EXPECT_EQ(turned.photometry->candela, (std::vector<double>{2, 2, 1, 1, 2, 2, 3, 3, 2, 2}));
    // One that ends anywhere goes on to its first.
    const Ies open = read(head + "1 1 1 2 3 1 1 0 0 0\n1 1 1\n0 90\n0 120 240\n1 1 2 2 3 3\n");
    ASSERT_TRUE(open.photometry) << open.messages;
    EXPECT_EQ(open.photometry->horizontal, (std::vector<double>{0, 120, 240, 360}));
    EXPECT_NE(open.messages.find("lamp.ies:8: warning"), std::string::npos) << open.messages;
}

TEST(Ies, LightThatStartsAtTheHorizonIsDarkBelow) {
    const Ies ies = read(head + "1 1 1 2 1 1 1 0 0 0\n1 1 1\n90 180\n0\n5 6\n");
    ASSERT_TRUE(ies.photometry) << ies.messages;
    EXPECT_EQ(ies.photometry->vertical, (std::vector<double>{0, 89.999, 90, 180}));
    EXPECT_EQ(ies.photometry->candela, (std::vector<double>{0, 0, 5, 6}));
}

TEST(Ies, LeavesTiltOut) {
    const Ies ies = read("TILT=INCLUDE\n1\n2\n0 90\n1 0.7\n1 1 1 2 1 1 1 0 0 0\n1 1 1\n0 90\n0\n5 6\n");
    ASSERT_TRUE(ies.photometry) << ies.messages;
    EXPECT_NE(ies.messages.find("tilted"), std::string::npos);
}

TEST(Ies, SaysWhatIsWrong) {
    const auto wrong = [](const std::string& text, const std::string& message) {
        const Ies ies = read(text);
        EXPECT_FALSE(ies.photometry);
        EXPECT_NE(ies.messages.find(message), std::string::npos) << ies.messages;
    };
    wrong("", "no line that begins with TILT=");
    wrong(head + "1 1 1 2", "ends early");
    wrong(head + "1 1 1 2 1 2 1 0 0 0\n1 1 1\n0 90\n0\n5 6\n", "type B");
    wrong(head + "1 1 0 2 1 1 1 0 0 0\n1 1 1\n0 90\n0\n5 6\n", "more than 0");
    wrong(head + "1 1 1 2 1 1 1 0 0 0\n1 1 1\n90 0\n0\n5 6\n", "must rise");
    wrong(head + "1 1 1 2 1 1 1 0 0 0\n1 1 1\n0 90\n0\n5 -6\n", "lamp.ies:8: error: \"-6\" as candela");
    wrong(head + "1 1 1 99999 99999 1 1 0 0 0\n1 1 1\n0 90\n0\n5 6\n", "too short");
    wrong(head + "1 1 1 2 1 1 x 0 0 0\n", "\"x\" is no number");
}

TEST(Toml, ReadsLightsThatThrowPictures) {
    const auto reading =
        testing::read_text("[[light]]\ntype = \"projector\"\nposition = [0, 0, 0]\nimage = \"nowhere.png\"\npower = [1, 1, 1]\n");
    EXPECT_FALSE(reading.scene);
    EXPECT_NE(reading.all().find("needs \"direction\" or \"look_at\""), std::string::npos) << reading.all();
    const auto nameless = testing::read_text("[[light]]\ntype = \"ies\"\nposition = [0, 0, 0]\npower = \"white\"\n");
    EXPECT_NE(nameless.all().find("\"file\""), std::string::npos) << nameless.all();
}

}  // namespace
}  // namespace lancer
