// lancer figures: a few of them here; all of them are made by the test cli.all_figures.
#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/program.h"
#include "lancer/image/image.h"

namespace lancer::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

TEST(Figures, ArePicturesAndAPage) {
    const Folder folder;
    const Finished finished = run_lancer(folder, {"figures", "out", "--only", "ssaa-1,low-angle,figure-1-adaptive,one-light"});
    EXPECT_EQ(finished.status, 0) << finished.err;
    EXPECT_THAT(finished.out, HasSubstr("4 figures written in "));
    EXPECT_THAT(finished.out, HasSubstr("open out/index.html"));

    EXPECT_EQ(read_image(folder.file("out/low-angle.png")).height * 4, read_image(folder.file("out/low-angle.png")).width * 3);
    const Image part = read_image(folder.file("out/ssaa-1-enlarged.png"));
    EXPECT_EQ(part.width, 640);
    EXPECT_EQ(part.pixels[0], part.pixels[7 * 3]);  // the first pixel, eight times
    EXPECT_TRUE(folder.has("out/figure-1-adaptive-samples.png"));
    EXPECT_FALSE(folder.has("out/figure-1.png"));
    EXPECT_FALSE(folder.has("out/threads.svg"));

    const std::string page = folder.read("out/index.html");
    EXPECT_THAT(page, AllOf(HasSubstr("<img src=\"ssaa-1.png\""), HasSubstr("<img src=\"ssaa-1-enlarged.png\""),
                            HasSubstr("lancer render scenes/report/figure-1.toml --ssaa 1 -o ssaa-1.png"),
                            HasSubstr("<a href=\"scenes/report/lights.toml\">")));
    EXPECT_THAT(page, Not(HasSubstr("ssaa-2")));
}

TEST(Figures, TheirCommandsMakeThemAgain) {
    const Folder folder;
    ASSERT_EQ(run_lancer(folder, {"figures", "out", "--only", "two-lights,adaptive"}).status, 0);
    const std::string lights = folder.read("out/two-lights.png");
    const std::string adaptive = folder.read("out/adaptive.png");
    const std::string page = folder.read("out/index.html");
    for (const char* name : {"two-lights", "adaptive"}) {
        const std::size_t end = page.find(std::string("-o ") + name + ".png");
        ASSERT_NE(end, std::string::npos);
        const std::size_t begin = page.rfind("<code>", end) + 6;
        const std::string command = page.substr(begin, page.find("</code>", begin) - begin);
        ASSERT_EQ(command.rfind("lancer ", 0), 0u) << command;
        folder.write("again.sh", "cd out && rm " + std::string(name) + ".png && " LANCER_PROGRAM " " + command.substr(7));
        EXPECT_EQ(Running(folder, {"sh", "again.sh"}).wait().status, 0) << command;
    }
    EXPECT_TRUE(folder.read("out/two-lights.png") == lights);
    EXPECT_TRUE(folder.read("out/adaptive.png") == adaptive);
}

TEST(Figures, TheSpeedUpIsAPlot) {
    const Folder folder;
    const Finished finished = run_lancer(folder, {"figures", "--only", "threads", "--quiet"});
    EXPECT_EQ(finished.status, 0) << finished.err;
    EXPECT_EQ(finished.out + finished.err, "");
    EXPECT_THAT(folder.read("figures/threads.svg"), AllOf(HasSubstr("<svg "), HasSubstr(">threads</text>"), HasSubstr("<polyline")));
    const Image plot = read_image(folder.file("figures/threads.png"));
    EXPECT_EQ(plot.width, 720);
    EXPECT_GT(plot.pixels.front(), 0.99f);                                       // white paper ...
    EXPECT_LT(*std::min_element(plot.pixels.begin(), plot.pixels.end()), 0.1f);  // ... and ink
    EXPECT_THAT(folder.read("figures/index.html"), HasSubstr("<th>times faster</th>"));
}

TEST(Figures, UnknownNamesAreRefused) {
    const Folder folder;
    const Finished finished = run_lancer(folder, {"figures", "--only", "figure-1,prsm"});
    EXPECT_EQ(finished.status, 2);
    EXPECT_THAT(finished.err, HasSubstr("--only: there is no figure \"prsm\": did you mean \"prism\"?; there are threads, figure-1, "));
    EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace lancer::test
